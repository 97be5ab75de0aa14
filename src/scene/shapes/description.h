/* description.h - a table of the kinds of shapes: fields, rules and bounding boxes.
 *
 * Intersections with rays are in src/render/geometry.
 */
#ifndef TIA_SCENE_SHAPES_DESCRIPTION_H
#define TIA_SCENE_SHAPES_DESCRIPTION_H

#include "scene/check/scene_check.h"
#include "scene/hull.h"

#define SHAPE_FIELDS_MAX 8

struct shape_description {
    const char *word;                                    /* the kind's word in scene files; NULL: `instance` */
    const char *what;                                    /* name in error messages: "a box" */
    struct tia_shape_field fields[SHAPE_FIELDS_MAX + 1]; /* fields of the statement; the last one is empty */
    /* checks the rules of this kind; distance and flatness are checked elsewhere, alike for all kinds */
    int (*check)(const struct check *check, const struct tia_shape *shape);
    /* adds the shape's box; NULL: the shape is infinite, and has no box */
    void (*add_bounds)(struct hull *hull, const struct tia_scene *scene, const struct tia_shape *shape);
};

#define FIELD(spelt, shape, field, type, must)                                                                         \
    {                                                                                                                  \
        .word = spelt, .member = #field, .offset = offsetof(struct tia_shape, shape.field), .value = TIA_SHAPE_##type, \
        .needed = must                                                                                                 \
    }
#define NEEDED(shape, field, type) FIELD(#field, shape, field, type, true)
#define OPTIONAL(shape, field, type) FIELD(#field, shape, field, type, false)

/* Declares each kind's description, which is in a file of its own: tia_box_description in box.c. */
#define DECLARE(KIND, name) extern const struct shape_description tia_##name##_description;
TIA_SHAPES(DECLARE)
#undef DECLARE

/* Returns a kind's description; NULL: there is no such kind. */
const struct shape_description *tia_shape_description(enum tia_shape_kind kind);

#endif
