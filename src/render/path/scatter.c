#include "scatter.h"

#include "samples/direction.h"

static num_length largest(const num_length rgb[3])
{
    num_length most = rgb[0] > rgb[1] ? rgb[0] : rgb[1];

    return most > rgb[2] ? most : rgb[2];
}

void scatter_prepare(struct scatter *s, const struct shading *surface)
{
    const struct tia_material *m = surface->material;

    s->surface = surface;
    ray_rgb(&m->specular, s->specular);
    ray_rgb(&m->mirror, s->mirror);
    ray_rgb(&m->refraction, s->refraction);
    num_length parts[4] = {largest(s->mirror), largest(s->refraction), largest(s->specular), largest(surface->colour)};
    num_length sum = parts[0] + parts[1] + parts[2] + parts[3], before = 0;
    s->rough = parts[2] > 0 || parts[3] > 0;
    s->black = sum <= 0;
    for (int i = 0; i < 3; i++) {
        before += parts[i];
        s->below[i] = s->black ? 0 : before >= sum ? UINT32_MAX : num_chance(num_fraction(before, sum));
    }
    if (parts[0] > 0 || parts[1] > 0 || parts[2] > 0)
        s->mirrored = shading_mirrored(surface);
}

enum lobe scatter_choose(const struct scatter *s, uint32_t number)
{
    if (s->black)
        return LOBE_NONE;
    return num_happens(s->below[0], number)   ? LOBE_MIRROR
           : num_happens(s->below[1], number) ? LOBE_GLASS
           : num_happens(s->below[2], number) ? LOBE_GLOSSY
                                              : LOBE_DIFFUSE;
}

num_unit scatter_chance(const struct scatter *s, enum lobe lobe)
{
    num_unit mirror = num_of_chance(s->below[0]);

    return lobe == LOBE_MIRROR ? mirror : num_of_chance(s->below[1]) - mirror;
}

/* Returns (n + k)/2 cos^n, where cos^n is `power`: the glossy lobe's reflectance for k = 2, its density for k = 1. */
static num_length lobe_height(const struct scatter *s, num_unit power, int k)
{
    tia_q16 n = s->surface->material->exponent + k * TIA_Q16_ONE;

    return num_times(num_length_of(n) / 2, power);
}

/* Returns x^n, or a number near it with the same heights. */
static num_unit lobe_power(const struct scatter *s, num_unit x)
{
    tia_q16 n = s->surface->material->exponent;
    num_unit off, power = num_power_near(x, n, &off), low = power > off ? power - off : 0, high = power + off;

    if (off == 0 ||
        (lobe_height(s, low, 2) == lobe_height(s, high, 2) && lobe_height(s, low, 1) == lobe_height(s, high, 1)))
        return power;
    return num_power(x, n);
}

void scatter_evaluate(const struct scatter *s, struct num_dir to, num_unit cosine, num_length reflected[3],
                      struct num_density *density)
{
    num_unit glossy = num_of_chance(s->below[2]) - num_of_chance(s->below[1]);
    num_unit diffuse = NUM_UNIT_ONE - num_of_chance(s->below[2]), power = 0;

    for (int c = 0; c < 3; c++)
        reflected[c] = num_times(s->surface->colour[c], cosine);
    *density = num_density_product(num_density_of_unit(diffuse), num_density_of_unit(cosine));
    if (glossy <= 0)
        return;
    num_unit along = num_dir_dot(s->mirrored, to);
    if (along > 0)
        power = lobe_power(s, along < NUM_UNIT_ONE ? along : NUM_UNIT_ONE);
    num_length height = lobe_height(s, power, 2);
    for (int c = 0; c < 3; c++)
        reflected[c] += num_times(num_product(s->specular[c], height), cosine);
    *density = num_density_sum(
        *density, num_density_product(num_density_of_unit(glossy), num_density_of(lobe_height(s, power, 1))));
}

bool scatter_sample(const struct scatter *s, enum lobe lobe, const uint32_t u[2], struct num_dir *to,
                    num_length factor[3], struct num_density *density)
{
    const struct shading *surface = s->surface;
    num_length reflected[3];
    int64_t local[3];

    if (lobe == LOBE_GLOSSY)
        tia_sample_phong(u, surface->material->exponent, local);
    else
        tia_sample_cosine(u, local);
    *to = ray_around(lobe == LOBE_GLOSSY ? s->mirrored : surface->normal, num_dir_of_q62(local));
    num_unit cosine = num_dir_dot(*to, surface->normal);
    if (cosine <= 0 || num_dir_dot(*to, surface->geometric) <= 0)
        return false;
    scatter_evaluate(s, *to, cosine, reflected, density);
    for (int c = 0; c < 3; c++)
        factor[c] = s->below[2] ? num_density_over(reflected[c], *density) : surface->colour[c];
    return true;
}
