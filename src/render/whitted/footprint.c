/* footprint.c - the parts of surfaces that rays stand for.
 *
 * The neighbour of the ray O + t D starts at O' in the direction D'. With v = O' + t D' - P, linearised, it meets the
 * tangent plane at P, whose normal is N, at P + v - D (v.N)/(D.N). Towards the horizon D.N goes to 0 and the footprint
 * grows without limit. So v and the quotient are cut to 2^15, and positions stay below P + 2^16.
 *
 * A cone is w + s t wide at the distance t. Behind a surface whose normal turns by k per unit of length, a ray at the
 * distance w from the middle ray has a normal that differs by k w. Across the plane of incidence the mirrored direction
 * D + 2 c N, c = -D.N, then differs by s + 2 c k w. In that plane w is w/c on the surface, and it differs by s + 2 k w/c;
 * the geometric mean of both additions is 2 k w. The refracted direction e D + (e c - d) N, with e = n1/n2 and the cosine
 * d of its angle, differs by e s + (e c - d) k w across the plane. */
#include "footprint.h"

#include "filter.h"
#include "render/trace/texture.h"
#include "scene/colour.h"

#define REACH (NUM_LENGTH_FAR / 2) /* 2^15 */
#define SPREAD_MAX NUM_LENGTH_ONE

static struct num_point cut(struct num_point p)
{
    return (struct num_point){num_length_clamp(p.x, -REACH, REACH), num_length_clamp(p.y, -REACH, REACH),
                              num_length_clamp(p.z, -REACH, REACH)};
}

/* Returns the change of the hit's point from a ray to its neighbour. */
static struct num_point moved(const struct ray *ray, const struct ray *next, num_length t, const struct shading *s)
{
    struct num_point v = cut(num_point_sub(num_point_at(next->origin, next->direction, t), s->point));
    num_length dt = num_div(num_point_dot(v, s->geometric), num_dir_dot(ray->direction, s->geometric));

    return num_point_sub(v, num_point_along(ray->direction, num_length_clamp(dt, -REACH, REACH)));
}

/* Sets the edges of a camera ray's footprint. */
static void from_neighbours(const struct path *path, const struct ray *ray, const struct hit *hit,
                            const struct shading *s, struct num_point edge[2])
{
    for (int i = 0; i < 2; i++) {
        struct ray next;
        ray_camera_next(&path->view->camera, path->pixel, path->sample, i, &next);
        edge[i] = moved(ray, &next, hit->t, s);
    }
}

/* Returns the cone at the distance t. Behind its narrowest place, it spreads again. */
static struct cone cone_at(const struct cone *cone, num_length t)
{
    num_length width = cone->width + num_product(cone->spread, num_length_clamp(t, 0, NUM_LENGTH_FAR));
    bool crossed = width < 0;

    return (struct cone){num_length_clamp(crossed ? -width : width, 0, REACH), crossed ? -cone->spread : cone->spread};
}

/* Sets the edges of the section of a cone by the tangent plane: along the ray's projection, and across it. */
static void from_cone(const struct cone *cone, const struct ray *ray, const struct hit *hit, const struct shading *s,
                      struct num_point edge[2])
{
    const num_length width = cone_at(cone, hit->t).width;
    const num_unit cosine = num_dir_dot(s->viewer, s->geometric);
    struct num_dir axes[2];

    shape_axes(s->geometric, axes);
    if (cosine < NUM_UNIT_ONE - NUM_UNIT_ONE / 65536) {
        axes[0] = num_dir_normalised(num_dir_add(ray->direction, num_dir_scaled(s->geometric, cosine)));
        axes[1] = num_dir_cross(s->geometric, axes[0]);
    }
    num_length longer = cosine > NUM_UNIT_LEAST ? num_div(width, cosine) : REACH;
    edge[0] = num_point_along(axes[0], num_length_clamp(longer, 0, REACH));
    edge[1] = num_point_along(axes[1], width);
}

static const struct tia_texture *filtered(const struct ray_view *view, uint32_t number)
{
    const struct tia_texture *t = number ? &view->scene->textures[number - 1] : NULL;

    return t && t->footprint ? t : NULL;
}

void footprint_filter(const struct path *path, const struct ray *ray, const struct hit *hit, struct shading *s)
{
    const struct ray_view *view = path->view;
    const struct tia_material *m = s->material;
    const struct tia_texture *colour = colour_is_black(&m->colour) ? NULL : filtered(view, m->texture);
    const struct tia_texture *opacity = filtered(view, m->opacity);
    struct num_point edge[2];
    num_length value[3];

    if (!colour && !opacity)
        return;
    if (path->pixel)
        from_neighbours(path, ray, hit, s, edge);
    else
        from_cone(&path->cone, ray, hit, s, edge);
    if (colour && filter_texture(view, hit, s->point, colour, edge, value)) {
        ray_rgb(&m->colour, s->colour);
        for (int c = 0; c < 3; c++)
            s->colour[c] = num_product(s->colour[c], value[c]);
        s->textured[0] = false;
    }
    if (opacity && filter_texture(view, hit, s->point, opacity, edge, value)) {
        s->opacity = value[0];
        s->textured[1] = false;
    }
}

/* Returns the cone of a camera ray: the mean of the distances to its neighbours. */
static struct cone cone_of(const struct path *path, const struct ray *ray)
{
    struct cone cone = {0, 0};

    for (int i = 0; i < 2; i++) {
        struct ray next;
        ray_camera_next(&path->view->camera, path->pixel, path->sample, i, &next);
        struct num_dir turn = num_dir_add(next.direction, num_dir_negated(ray->direction));
        cone.width += num_norm(cut(num_point_sub(next.origin, ray->origin))) / 2;
        cone.spread += num_norm(num_point_along(turn, NUM_LENGTH_ONE)) / 2;
    }
    cone.spread = num_length_clamp(cone.spread, 0, SPREAD_MAX);
    return cone;
}

/* Returns k w, the mean of two directions: above 0 where the surface is convex. */
static num_length bend_of(const struct ray_view *view, const struct hit *hit, const struct shading *s, num_length width)
{
    struct num_dir axes[2];
    struct surface here, beside;
    num_unit sum = 0;
    int times = 0;

    for (; width > NUM_LENGTH_ONE; times++)
        width /= 2;
    shape_axes(s->geometric, axes);
    ray_surface(view, hit, s->point, &here);
    for (int i = 0; i < 2; i++) {
        ray_surface(view, hit, num_point_at(s->point, axes[i], width), &beside);
        sum += num_dir_dot(beside.smooth, axes[i]) / 2 - num_dir_dot(here.smooth, axes[i]) / 2;
    }
    num_length bend = num_length_of_unit(s->back ? -sum : sum);
    for (; times > 0; times--)
        bend = num_length_clamp(2 * bend, -SPREAD_MAX, SPREAD_MAX);
    return bend;
}

void footprint_spread(const struct path *path, const struct ray *ray, const struct hit *hit, const struct shading *s,
                      struct bounces *next)
{
    const struct cone from = path->pixel ? cone_of(path, ray) : path->cone, at = cone_at(&from, hit->t);
    const num_length bend = bend_of(path->view, hit, s, at.width);

    next->width = at.width;
    next->spread[0] = num_length_clamp(at.spread + 2 * bend, -SPREAD_MAX, SPREAD_MAX);
    next->spread[1] = next->spread[2] = at.spread;
    if (next->straight || colour_is_black(&s->material->refraction))
        return;
    num_length e = num_ratio(num_length_of(next->between.from), num_length_of(next->between.to));
    num_length c = num_length_of_unit(s->facing);
    num_length d = num_length_of_unit(-num_dir_dot(next->refracted.direction, s->normal));
    num_length spread = num_product(e, at.spread) + num_product(num_product(e, c) - d, bend);
    next->spread[1] = num_length_clamp(spread, -SPREAD_MAX, SPREAD_MAX);
}
