#include "shape.h"

void shape_prepare(struct shape *shape, const struct tia_scene *scene, const struct tia_shape *given)
{
#define ENTRY(KIND, name) [KIND] = &SHAPE_KIND(name),
    static const struct shape_kind *const kinds[] = {TIA_SHAPES(ENTRY)};
#undef ENTRY

    shape->kind = kinds[given->kind];
    shape->uv_bits = 0;
    shape->kind->prepare(shape, scene, given);
}

uint32_t shape_material(const struct shape *shape, uint32_t element)
{
    if (shape->kind == &SHAPE_KIND(grid))
        return shape->material + shape->grid.grid->cells[element / 6] - 1;
    return shape_part(shape, &element)->material;
}
