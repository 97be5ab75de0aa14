/* plane.c - planes, which extend up to the largest coordinates. */
#include "flat.h"

static bool is_near(num_length x)
{
    return x < NUM_LENGTH_FAR && x > -NUM_LENGTH_FAR;
}

static bool intersect(const struct shape *shape, const struct ray *ray, num_length limit,
                      struct intersection *intersection)
{
    intersection->element = 0;
    if (!flat_intersect(&shape->plane, ray, limit, &intersection->t))
        return false;
    struct num_point p = num_point_at(ray->origin, ray->direction, intersection->t);
    return is_near(p.x) && is_near(p.y) && is_near(p.z);
}

/* The half-space behind the plane: its chord begins or ends at infinity. */
static bool chord_of(const struct shape *shape, const struct ray *ray, num_length after, struct chord *chord)
{
    const struct prepared_plane *plane = &shape->plane;
    num_unit slope = num_dir_dot(ray->direction, plane->normal);
    num_length height = num_point_dot(num_point_sub(plane->point, ray->origin), plane->normal);

    *chord = (struct chord){{-NUM_LENGTH_MAX, 0}, {NUM_LENGTH_MAX, 0}};
    if (slope < NUM_UNIT_LEAST && slope > -NUM_UNIT_LEAST)
        return height > 0 && after < NUM_LENGTH_MAX;
    struct intersection *end = slope < 0 ? &chord->enter : &chord->leave;
    end->t = num_div(height, slope);
    return chord->leave.t > after;
}

static void uv_at(const struct shape *shape, struct num_point point, uint32_t element, num_length uv[2])
{
    (void)element;
    flat_uv(&shape->plane, point, uv);
}

static void prepare(struct shape *shape, const struct tia_scene *scene, const struct tia_shape *given)
{
    flat_prepare(&shape->plane, given->plane.point, given->plane.normal);
    shape->plane.radius = 0;
    shape->uv_bits = (int8_t)-scene->scale_bits;
}

const struct shape_kind SHAPE_KIND(plane) = {prepare, intersect, shape_occludes, flat_surface, uv_at, chord_of};
