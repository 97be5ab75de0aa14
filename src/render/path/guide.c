#include "guide.h"

#include "emitters.h"

bool guide_glows(const struct shading *s, num_length glow[3], num_length facing[3])
{
    bool any = false;

    emitter_radiance(&s->material->emission, s->material->emission_bits, glow);
    ray_rgb(&s->material->facing, facing);
    for (int c = 0; c < 3; c++)
        any = any || glow[c] > 0 || facing[c] > 0;
    return any;
}

void guide_add(struct estimate *e, const num_length throughput[3], const num_length albedo[3],
               const struct num_dir *normal, num_length depth)
{
    num_length seen[3];

    for (int c = 0; c < 3; c++)
        seen[c] = num_product_within(throughput[c], albedo[c]);
    estimate_guide(e, seen, normal, depth);
}

void guide_add_surface(struct estimate *e, const num_length throughput[3], const struct scatter *scatter,
                       num_length depth)
{
    const struct shading *s = scatter->surface;
    num_length glow[3], facing[3], albedo[3];

    if (!guide_glows(s, glow, facing) && !scatter->rough && !scatter->black)
        return;
    for (int c = 0; c < 3; c++) {
        albedo[c] = s->colour[c] + scatter->specular[c] + scatter->mirror[c] + scatter->refraction[c];
        albedo[c] = num_sum_within(albedo[c], glow[c]);
        if (s->facing > 0)
            albedo[c] = num_sum_within(albedo[c], num_times(facing[c], s->facing));
    }
    guide_add(e, throughput, albedo, &s->normal, depth);
}
