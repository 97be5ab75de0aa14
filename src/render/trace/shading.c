#include "shading.h"

#include "bump.h"
#include "scene/colour.h"
#include "texture.h"

static void look_up(const struct tia_texture *t, const struct texture_place *at, num_length value[], struct shading *s,
                    unsigned which)
{
    s->texels[which] = ray_texture(t, at, value);
    s->textured[which] = ray_texture_is_hashed(t);
}

static void texture(const struct ray_view *view, const struct hit *hit, struct shading *s)
{
    const struct tia_material *m = s->material;
    const struct tia_texture *textures = view->scene->textures;
    bool coloured = m->texture && !colour_is_black(&m->colour);
    struct texture_place at;
    num_length texel[3];

    ray_rgb(&m->colour, s->colour);
    s->opacity = NUM_LENGTH_ONE;
    s->textured[0] = s->textured[1] = false;
    if (coloured) {
        const struct tia_texture *t = &textures[m->texture - 1];
        ray_texture_place(view, t, hit, s->point, &at);
        look_up(t, &at, texel, s, 0);
        for (int c = 0; c < 3; c++)
            s->colour[c] = num_product(s->colour[c], texel[c]);
    }
    if (m->opacity) {
        const struct tia_texture *t = &textures[m->opacity - 1];
        if (!coloured || textures[m->texture - 1].kind == TIA_NOISE) /* else the place is the same */
            ray_texture_place(view, t, hit, s->point, &at);
        look_up(t, &at, &s->opacity, s, 1);
    }
}

void shading_prepare(const struct ray_view *view, num_length bias, const struct ray *ray, const struct hit *hit,
                     struct shading *s)
{
    struct surface surface;

    s->object = hit->object;
    s->material = &view->scene->materials[ray_material(view, hit->object, hit->element)];
    s->point = num_point_at(ray->origin, ray->direction, hit->t);
    s->viewer = num_dir_negated(ray->direction);
    ray_surface(view, hit, s->point, &surface);
    s->back = num_dir_dot(surface.normal, s->viewer) < 0;
    s->geometric = s->back ? num_dir_negated(surface.normal) : surface.normal;
    s->outside = num_point_at(s->point, s->geometric, bias);
    s->normal = s->back ? num_dir_negated(surface.smooth) : surface.smooth;
    if (s->material->bump)
        bump_normal(view, hit, s->point, s->viewer, s->back, &s->normal);
    s->facing = num_dir_dot(s->normal, s->viewer);
    texture(view, hit, s);
}

/* Returns R/2 = (N.V) N - V/2, normalised. */
struct num_dir shading_mirrored(const struct shading *s)
{
    struct num_dir half = {-s->viewer.x / 2, -s->viewer.y / 2, -s->viewer.z / 2};

    return num_dir_normalised(num_dir_add(num_dir_scaled(s->normal, s->facing), half));
}

/* Refracts by Snell's law, with q = n2/(4 n1), c = N.V and the sines s of V and s n1/n2 of the refracted direction T:
 *
 *     n2/n1 T = -V + (c - sqrt((n2/n1)^2 - s^2)) N,   in quarters  -V/4 + (c/4 - root) N,
 *     root = sqrt(q^2 - s^2/16)
 *
 * All light is reflected if there is no root, or if an interpolated normal is turned away from the viewer. Then Rs and
 * Rp are exactly 1, while their formulas in fixed point could give slightly less. Returns F, the reflectance by
 * Fresnel's equations: with n2/n1 cos T = 4 root,
 *
 *     Rs = (c - n2/n1 cos T)/(c + ...)          = (c/4 - root)/(c/4 + root)
 *     Rp = (n2/n1 c - cos T)/(n2/n1 c + cos T)  = (q^2 c - root/4)/(q^2 c + root/4).
 *
 * q must be at most 1. So if n2 > 4 n1, all values are in sixteenths: n2 is at most 16 n1. */
num_unit shading_refract(const struct shading *s, struct boundary between, struct num_dir *refracted)
{
    const num_length parts = between.to <= 4 * between.from ? 4 : 16;
    num_unit q = num_fraction(num_length_of(between.to), parts * num_length_of(between.from));
    num_unit c = s->facing, square = num_times(q, q);
    num_unit inside = square - (NUM_UNIT_ONE - num_times(c, c)) / (parts * parts);

    if (inside <= 0 || c <= 0)
        return NUM_UNIT_ONE;
    num_unit root = num_unit_sqrt(inside), bend = c / parts - root, q2c = num_times(square, c);
    struct num_dir part = {-s->viewer.x / parts, -s->viewer.y / parts, -s->viewer.z / parts};
    num_unit rs = num_fraction(bend, c / parts + root), rp = num_fraction(q2c - root / parts, q2c + root / parts);

    *refracted = num_dir_normalised(num_dir_add(part, num_dir_scaled(s->normal, bend)));
    return num_times(rs, rs) / 2 + num_times(rp, rp) / 2;
}
