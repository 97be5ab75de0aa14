/* plane.c - infinite planes, as far as the world goes. */
#include "flat.h"

static bool is_near(num_x x)
{
    return x < NUM_X_FAR && x > -NUM_X_FAR;
}

static bool intersect(const struct shape *shape, const struct ray *ray, num_x limit, struct crossing *crossing)
{
    crossing->element = 0;
    if (!flat_meet(&shape->plane, ray, limit, &crossing->t))
        return false;
    struct num_point p = num_point_at(ray->origin, ray->direction, crossing->t);
    return is_near(p.x) && is_near(p.y) && is_near(p.z);
}

static void uv_at(const struct shape *shape, struct num_point point, uint32_t element, num_x uv[2])
{
    (void)element;
    flat_uv(&shape->plane, point, uv);
}

void shape_plane(struct shape *shape, const struct tia_plane *plane)
{
    static const struct shape_kind kind = {intersect, shape_occludes, flat_surface, uv_at};

    shape->kind = &kind;
    flat_prepare(&shape->plane, plane->point, plane->normal);
    shape->plane.radius = 0;
}
