/* cone.c - cones.
 *
 * A cone is w + s t wide at the distance t. Behind a surface whose normal turns by k per unit of length, a ray at the
 * distance w from the middle ray has a normal that differs by k w. Across the plane of incidence the mirrored direction
 * D + 2 c N, c = -D.N, then differs by s + 2 c k w. In that plane w is w/c on the surface, and it differs by s + 2 k
 * w/c; the geometric mean of both additions is 2 k w. The refracted direction e D + (e c - d) N, with e = n1/n2 and the
 * cosine d of its angle, differs by e s + (e c - d) k w across the plane. */
#include "cone.h"

#include "footprint.h"
#include "scene/colour.h"

#define SPREAD_MAX NUM_LENGTH_ONE

/* Returns the cone of a camera ray: the mean of the distances to its neighbours. */
static struct cone cone_of(const struct path *path, const struct ray *ray)
{
    struct cone cone = {0, 0};

    for (int i = 0; i < 2; i++) {
        struct ray next;
        ray_camera_next(&path->view->camera, path->pixel, path->sample, i, &next);
        struct num_dir turn = num_dir_add(next.direction, num_dir_negated(ray->direction));
        cone.width += num_norm(footprint_cut(num_point_sub(next.origin, ray->origin))) / 2;
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

void cone_spread(const struct path *path, const struct ray *ray, const struct hit *hit, const struct shading *s,
                 struct bounces *next)
{
    const struct cone from = path->pixel ? cone_of(path, ray) : path->cone, at = footprint_cone_at(&from, hit->t);
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
