/* kind.c - functions shared by all kinds of shapes. */
#include "shape.h"

bool shape_occludes(const struct shape *shape, const struct ray *ray, num_length limit)
{
    struct intersection intersection;

    return shape->kind->intersect(shape, ray, limit, &intersection);
}

/* Returns e x N, where e is the unit vector along the axis of N's smallest coordinate. */
static struct num_dir across(struct num_dir n)
{
    num_unit x = n.x < 0 ? -n.x : n.x, y = n.y < 0 ? -n.y : n.y, z = n.z < 0 ? -n.z : n.z;

    if (x <= y && x <= z)
        return (struct num_dir){0, -n.z, n.y};
    if (y <= z)
        return (struct num_dir){n.z, 0, -n.x};
    return (struct num_dir){-n.y, n.x, 0};
}

void shape_axes(struct num_dir normal, struct num_dir axes[2])
{
    axes[0] = num_dir_normalised(across(normal));
    axes[1] = num_dir_cross(normal, axes[0]);
}

void shape_tangents(struct num_dir normal, struct num_dir tangents[2])
{
    struct num_dir right = {normal.z, 0, -normal.x}; /* y x N */

    if (shape_is_upright(normal))
        right.x = NUM_UNIT_ONE;
    tangents[0] = num_dir_normalised(right);
    tangents[1] = num_dir_cross(normal, tangents[0]);
}
