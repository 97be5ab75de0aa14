#include "description.h"

const struct shape_description *tia_shape_description(enum tia_shape_kind kind)
{
#define ENTRY(KIND, name) [KIND] = &tia_##name##_description,
    static const struct shape_description *const descriptions[] = {TIA_SHAPES(ENTRY)};
#undef ENTRY

    return (size_t)kind < sizeof descriptions / sizeof *descriptions ? descriptions[kind] : NULL;
}

const struct tia_shape_field *tia_shape_fields(enum tia_shape_kind kind)
{
    const struct shape_description *description = tia_shape_description(kind);

    return description ? description->fields : NULL;
}
