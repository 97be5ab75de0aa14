/* disc.c - discs: planes within a radius. */
#include "flat.h"

static bool intersect(const struct shape *shape, const struct ray *ray, num_length limit,
                      struct intersection *intersection)
{
    const struct prepared_plane *disc = &shape->plane;
    struct num_point from = num_point_sub(ray->origin, disc->point);

    intersection->element = 0;
    return flat_intersect(disc, ray, limit, &intersection->t) &&
           num_within(disc->radius, num_point_at(from, ray->direction, intersection->t));
}

static void uv_at(const struct shape *shape, struct num_point point, uint32_t element, num_length uv[2])
{
    num_length radius = shape->plane.radius;

    (void)element;
    flat_uv(&shape->plane, point, uv);
    uv[0] = num_ratio(uv[0] + radius, 2 * radius);
    uv[1] = num_ratio(uv[1] + radius, 2 * radius);
}

static void prepare(struct shape *shape, const struct tia_scene *scene, const struct tia_shape *given)
{
    (void)scene;
    flat_prepare(&shape->plane, given->disc.centre, given->disc.normal);
    shape->plane.radius = num_length_of(given->disc.radius);
}

const struct shape_kind SHAPE_KIND(disc) = {prepare, intersect, shape_occludes, flat_surface, uv_at, NULL};
