/* pending.c - goes when grid.c comes. */
#include "shape.h"

static bool intersect(const struct shape *shape, const struct ray *ray, num_x limit, struct crossing *crossing)
{
    (void)shape;
    (void)ray;
    (void)limit;
    (void)crossing;
    return false;
}

void shape_grid(struct shape *shape, const struct tia_grid *grid)
{
    static const struct shape_kind kind = {intersect, shape_occludes, NULL, NULL};

    (void)grid;
    shape->kind = &kind;
}

uint32_t shape_material(const struct shape *shape, uint32_t element)
{
    (void)element;
    return shape->material;
}
