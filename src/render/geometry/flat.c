/* flat.c - planes: t = (P - O).N / (D.N). A ray with |D.N| below 2^-42 counts as parallel: it meets the plane within
 * 2^17 units only if its origin is less than 2^-25 from the plane. */
#include "flat.h"

void flat_prepare(struct prepared_plane *plane, struct tia_vec3 point, struct tia_dir3 normal)
{
    plane->point = num_point_of(point);
    plane->normal = num_dir_of(normal);
    shape_tangents(plane->normal, plane->tangents);
}

bool flat_intersect(const struct prepared_plane *plane, const struct ray *ray, num_length limit, num_length *t)
{
    num_unit slope = num_dir_dot(ray->direction, plane->normal);

    if (slope < NUM_UNIT_LEAST && slope > -NUM_UNIT_LEAST)
        return false;
    *t = num_div(num_point_dot(num_point_sub(plane->point, ray->origin), plane->normal), slope);
    return *t >= 0 && *t <= limit && *t < NUM_LENGTH_MAX;
}

void flat_surface(const struct shape *shape, struct num_point point, uint32_t element, struct surface *surface)
{
    (void)point;
    (void)element;
    surface->normal = surface->smooth = shape->plane.normal;
}

void flat_uv(const struct prepared_plane *plane, struct num_point point, num_length uv[2])
{
    struct num_point v = num_point_sub(point, plane->point);

    uv[0] = num_point_dot(v, plane->tangents[0]);
    uv[1] = num_point_dot(v, plane->tangents[1]);
}
