/* job.h - reading a .tia file: what its statements share.
 *
 * Three passes over the text. In the first one nothing is stored; of a named sphere it is not known yet
 * whether it moves, so it is counted among the spheres and among the shapes. The second one collects the
 * names, so that they may be used before the line that defines them; the last one fills the arrays.
 */
#ifndef TIA_SRC_READ_JOB_H
#define TIA_SRC_READ_JOB_H

#include "read/text/fields.h"
#include "read/text/names.h"

enum tia_kind_of_name {
    TIA_NAMED_MATERIAL, /* index: of the material; of a texture likewise */
    TIA_NAMED_TEXTURE,
    TIA_NAMED_SOLID, /* twice the index of a mesh; of a grid, and 1 */
    TIA_NAMED_MOVER  /* twice the index of a transform; of a light, and 1 */
};

enum tia_job_array {
    TIA_OF_MATERIALS,
    TIA_OF_TEXTURES,
    TIA_OF_SPHERES,
    TIA_OF_SHAPES,
    TIA_OF_TRANSFORMS,
    TIA_OF_MESHES,
    TIA_OF_VERTICES,
    TIA_OF_NORMALS,
    TIA_OF_UVS,
    TIA_OF_FACES,
    TIA_OF_GRIDS,
    TIA_OF_CELLS,
    TIA_OF_LIGHTS,
    TIA_OF_BINDINGS,
    TIA_OF_TRACKS,
    TIA_OF_KEYS,
    TIA_OF_NAMES,    /* what is defined */
    TIA_OF_ANIMATED, /* what moves */
    TIA_ARRAYS
};

enum tia_pass { TIA_COUNTING, TIA_NAMING, TIA_FILLING };

struct tia_job {
    struct tia_text text;
    struct tia_reader *reader;
    struct tia_scene *scene;
    enum tia_pass pass;
    struct tia_array arrays[TIA_ARRAYS];
    uint32_t once; /* bit n: statement n, of which there may be one, was there */

    /* When reading again to find the line of a thing: item sought_index of an array, or a statement. */
    bool seeking;
    unsigned sought; /* enum tia_job_array; TIA_ARRAYS: none */
    uint32_t sought_index;
    const char *sought_statement; /* NULL: none */
};

/* Adds to an array; the index of what was added. */
uint32_t tia_job_add(struct tia_job *job, enum tia_job_array array, const void *item);
uint32_t tia_job_count(const struct tia_job *job, enum tia_job_array array);

/* Where item `index` of an array will be; NULL before the last pass. */
const void *tia_job_at(const struct tia_job *job, enum tia_job_array array, uint32_t index);

/* The next word as a name, and what has it from now on. */
int tia_job_define(struct tia_job *job, enum tia_kind_of_name kind, uint32_t index);
void tia_job_name(struct tia_job *job, enum tia_kind_of_name kind, const struct tia_word *name, uint32_t index);

/* The index of what has the name, 0 before the last pass. `expected`: "the name of a material". */
int tia_job_find(struct tia_job *job, enum tia_kind_of_name kind, const struct tia_word *name, const char *expected,
                 uint32_t *index);

/* The name as that of something that moves; whether it is one; what of it moves, known at the end. */
void tia_job_animate(struct tia_job *job, const struct tia_word *name);
bool tia_job_moves(const struct tia_job *job, const struct tia_word *name);
struct tia_name *tia_job_mover(const struct tia_job *job, const struct tia_word *name);

/* The rest of each statement's line, and of its block where it has one. */
int tia_line_camera(struct tia_job *job);
int tia_line_samples(struct tia_job *job);
int tia_line_background(struct tia_job *job);
int tia_line_depth(struct tia_job *job);
int tia_line_material(struct tia_job *job);
int tia_line_texture(struct tia_job *job);
int tia_line_shape(struct tia_job *job, enum tia_shape_kind kind);
int tia_line_instance(struct tia_job *job);
int tia_line_mesh(struct tia_job *job);
int tia_line_grid(struct tia_job *job);
int tia_line_light(struct tia_job *job);
int tia_line_key(struct tia_job *job);
int tia_line_animate(struct tia_job *job);

#endif
