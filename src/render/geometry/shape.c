#include "shape.h"

void shape_prepare(struct shape *shape, const struct tia_scene *scene, const struct tia_shape *given)
{
#define ENTRY(KIND, name) [KIND] = &SHAPE_KIND(name),
    static const struct shape_kind *const kinds[] = {TIA_SHAPES(ENTRY)};
#undef ENTRY

    shape->kind = kinds[given->kind];
    shape->kind->prepare(shape, scene, given);
}

bool shape_occludes(const struct shape *shape, const struct ray *ray, num_length limit)
{
    struct intersection intersection;

    return shape->kind->intersect(shape, ray, limit, &intersection);
}

uint32_t shape_material(const struct shape *shape, uint32_t element)
{
    if (shape->kind != &SHAPE_KIND(grid))
        return shape->material;
    return shape->material + shape->grid.grid->cells[element / 6] - 1;
}

/* e x N, e the unit vector of N's smallest coordinate. */
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
