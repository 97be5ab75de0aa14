/* unit.h - writes a scene as a C translation unit: const tables, named after the scene's symbol. */
#ifndef TIA_COMPILE_UNIT_H
#define TIA_COMPILE_UNIT_H

#include <tia/bvh.h>
#include <tia/motion.h>

#include "common/convert.h"
#include "common/text_file.h"

struct unit {
    struct text text;
    const char *symbol;
    const struct tia_scene *scene;
};

/* Writes the whole unit; a comment in it names `source`. If scene->bvh is NULL, the unit has no hierarchy. If
 * `telltales` is not NULL, the unit has the `crcs` of these as well. */
void unit_write(struct unit *unit, const char *source, const struct convert_telltales *telltales, const uint32_t *crcs);

/* Draws the rectangles in each state of the scene. Returns their CRCs, all states of the first rectangle first, to be
 * freed by the caller; NULL after a failure, with the reason in `why`, PORT_WHY bytes. */
uint32_t *telltales_draw(const struct tia_scene *scene, const struct convert_telltales *all, char *why);

/* The parts of the unit: the tables that the scene points to. */
void unit_things(struct unit *unit); /* writes materials, spheres, lights, keys */
void unit_fine(struct unit *unit);   /* writes fine digits, if the scene has them */
void unit_fog(struct unit *unit);    /* writes the fog, if the scene has one */
void unit_shapes(struct unit *unit); /* writes shapes, transforms, solids */
void unit_images(struct unit *unit); /* writes textures and grids */
void unit_meshes(struct unit *unit);
void unit_tracks(struct unit *unit);
void unit_bvh(struct unit *unit);
void unit_telltales(struct unit *unit, const struct convert_telltales *all, const uint32_t *crcs);

/* Writes one light, without a separator. */
void unit_light(struct unit *unit, const struct tia_light *light);

/* Begins a table: writes "static const TYPE SYMBOL_NAME[] = {". */
__attribute__((format(printf, 3, 4))) void table_begin(struct unit *unit, const char *type, const char *name, ...);
/* Writes the end of the table. */
void table_end(struct unit *unit);

/* Writes ".FIELD = VALUE," as a word; nothing if the value is 0, which C initialises anyway. */
void field_number(struct unit *unit, const char *field, int64_t value);
void field_unsigned(struct unit *unit, const char *field, uint32_t value);
void field_vec3(struct unit *unit, const char *field, struct tia_vec3 v);
void field_dir3(struct unit *unit, const char *field, struct tia_dir3 d);
void field_rgb(struct unit *unit, const char *field, struct tia_rgb c);
/* Writes ".FIELD = SYMBOL_NAME," if count is not 0. */
__attribute__((format(printf, 4, 5))) void field_table(struct unit *unit, const char *field, uint32_t count,
                                                       const char *name, ...);

#endif
