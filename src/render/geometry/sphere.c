/* sphere.c - spheres by the geometric form, with L = C - O:
 *
 *     tca = L.D,   d^2 = |L - tca D|^2,   thc = sqrt(r^2 - d^2),   t = tca -+ thc
 *
 * The smaller t counts unless it is negative, then the larger one. The perpendicular L - tca D does not cancel. */
#include "shape.h"

bool sphere_intersect(struct num_point centre, num_length radius, const struct ray *ray, num_length limit,
                      num_length *t)
{
    struct num_point l = num_point_sub(centre, ray->origin);
    num_length tca = num_point_dot(l, ray->direction);

    if (tca < -radius || tca - radius > limit)
        return false;
    num_length thc = num_half_chord(radius, num_point_sub(l, num_point_along(ray->direction, tca)));
    if (thc < 0 || tca + thc < 0)
        return false;
    *t = tca - thc < 0 ? tca + thc : tca - thc;
    return *t <= limit;
}

void sphere_surface(struct num_point centre, struct num_point point, struct surface *surface)
{
    (void)num_normalise(num_point_sub(point, centre), &surface->normal);
    surface->smooth = surface->normal;
}

/* Gives (1/2 - atan2(z, x)/(2 pi), 1 - acos(y)/pi), the latter as atan2(sqrt(1 - y^2), y)/pi. */
void sphere_uv(struct num_point centre, struct num_point point, num_length uv[2])
{
    struct num_dir n;

    (void)num_normalise(num_point_sub(point, centre), &n);
    num_unit aside = num_unit_sqrt(num_times(n.x, n.x) + num_times(n.z, n.z));
    uv[0] = NUM_LENGTH_ONE / 2 - num_length_of_unit(num_atan2(n.z, n.x));
    uv[1] = NUM_LENGTH_ONE - 2 * num_length_of_unit(num_atan2(aside, n.y));
}

static bool intersect(const struct shape *shape, const struct ray *ray, num_length limit,
                      struct intersection *intersection)
{
    intersection->element = 0;
    return sphere_intersect(shape->sphere.centre, shape->sphere.radius, ray, limit, &intersection->t);
}

static bool chord_of(const struct shape *shape, const struct ray *ray, num_length after, struct chord *chord)
{
    num_length radius = shape->sphere.radius;
    struct num_point l = num_point_sub(shape->sphere.centre, ray->origin);
    num_length tca = num_point_dot(l, ray->direction);
    num_length thc = num_half_chord(radius, num_point_sub(l, num_point_along(ray->direction, tca)));

    *chord = (struct chord){{tca - thc, 0}, {tca + thc, 0}};
    return thc >= 0 && chord->leave.t > after;
}

static void surface_at(const struct shape *shape, struct num_point point, uint32_t element, struct surface *surface)
{
    (void)element;
    sphere_surface(shape->sphere.centre, point, surface);
}

static void uv_at(const struct shape *shape, struct num_point point, uint32_t element, num_length uv[2])
{
    (void)element;
    sphere_uv(shape->sphere.centre, point, uv);
}

static void prepare(struct shape *shape, const struct tia_scene *scene, const struct tia_shape *given)
{
    (void)scene;
    shape->sphere = (struct prepared_sphere){num_point_of(given->sphere.centre), num_length_of(given->sphere.radius)};
}

const struct shape_kind SHAPE_KIND(sphere) = {prepare, intersect, shape_occludes, surface_at, uv_at, chord_of};
