/* model.h - what the readers of models share: a unit of length, a camera and lights for files that have none.
 *
 * A model keeps its coordinates if they are within 4096 and its largest extent is at least 1. Its points are then
 * nearer than 32768 to the camera, which is at most 3.93 radii from each of them, and the last bit of a coordinate is
 * at most 2^-16 of the model's size. Any other model is moved, so that the middle of its bounds is the origin, and
 * scaled by a power of two, so that it extends 8 to 16 from there. The picture stays the same, since nothing else in
 * such a file has a size. Only models smaller than 2^-15 are refused: 28 fractional bits are too few for their shape.
 * A mesh of a .tia scene is in the scene's unit instead.
 */
#ifndef TIA_READ_MODEL_MODEL_H
#define TIA_READ_MODEL_MODEL_H

#include "math/integer.h"
#include "read/text/arena.h"
#include "read/text/text_lines.h"
#include "read/triangulation.h"

/* Fractional bits of bounds; and of coordinates as files are measured and as moved models are read. */
#define TIA_MODEL_BITS 28
#define TIA_MODEL_FINE_BITS 32

/* A model that is a mesh of a .tia scene. */
struct tia_model_use {
    const char *file; /* the path that errors and warnings name */
    int scale_bits;   /* of the scene's unit */

    /* Results of the first pass. */
    uint32_t mesh_most;     /* an upper bound of the number of meshes */
    int64_t min[3], max[3]; /* bounds of the vertices in the file's unit, Q35.28, rounded down; min > max: none */
    bool rounded;           /* a coordinate is not exact in Q16.16 */
};

struct tia_model {
    struct tia_reader *reader;
    struct tia_scene *scene;
    struct tia_model_use *use; /* NULL: the model is a scene of its own */
    bool counting;             /* the first pass: vertices are measured */

    /* min, max: bounds of all vertices, Q35.28. origin, shift and moved: the conversion to the scene's coordinates. */
    int64_t min[3], max[3], origin[3];
    int shift;
    bool moved, rounded;
};

/* Begins the first pass. */
struct tia_model tia_model_begin(struct tia_reader *reader, struct tia_scene *scene, struct tia_model_use *use);

/* Begins a model's text. */
struct tia_text tia_model_text(const struct tia_model *model);

/* Returns how many fractional bits coordinates have in this pass: 0 to 32. */
unsigned tia_model_bits(const struct tia_model *model);

/* Converts a vertex with tia_model_bits fractional bits, each coordinate below 2^31 in size. The first pass only
 * measures it. */
struct tia_vec3 tia_model_vertex(struct tia_model *model, const int64_t v[3]);

/* Converts a coordinate of a moved model. |v - origin| is below 2^61; shifted, it is below 2^21. */
static inline tia_q16 tia_model_move(const struct tia_model *model, int64_t v, int axis)
{
    int64_t from = (v >> (TIA_MODEL_FINE_BITS - TIA_MODEL_BITS)) - model->origin[axis];
    return (tia_q16)(model->shift >= 0 ? tia_round_shift(from, (unsigned)model->shift)
                                       : (int64_t)((uint64_t)from << (unsigned)-model->shift));
}

/* Does what tia_model_vertex does in the second pass. */
static inline struct tia_vec3 tia_model_place(const struct tia_model *model, const int64_t v[3])
{
    if (!model->moved)
        return (struct tia_vec3){tia_saturate_s32(v[0]), tia_saturate_s32(v[1]), tia_saturate_s32(v[2])};
    return (struct tia_vec3){tia_model_move(model, v[0], 0), tia_model_move(model, v[1], 1),
                             tia_model_move(model, v[2], 2)};
}

/* Ends the first pass: chooses the unit, or refuses the model. `expected` describes the statement of a face: "some
 * f". */
int tia_model_fit(struct tia_model *model, uint32_t face_count, bool has_vertices, const char *expected);

/* Sets the camera, the background and the TIA_MODEL_LIGHTS lights of a model that is a scene. */
int tia_model_frame(struct tia_model *model, struct tia_light *lights);

/* Refuses the whole file; the error has no line. */
int tia_model_refuse(const struct tia_model *model, const char *why);

/* Turns the error just found into a warning of that kind, with its remedy, and returns TIA_OK; with reader->strict,
 * returns TIA_ERR_RANGE. Each mistake is found in several passes, and `counts` in one. */
int tia_model_forgive(struct tia_reader *reader, enum tia_read_warning_kind kind, const char *remedy, bool counts);

/* ---- faces ---- */

/* Triangulates a polygon of 3 to POLYGON_MAX corners; writes `count` - 2 faces. `work` has room for `count` corners. */
void tia_model_polygon(struct tia_face *faces, const struct tia_vec3 *vertices, const struct tia_corner *corners,
                       uint32_t count, struct polygon_corner *work);

/* If there are many faces that are the same as one before them, see unique.c, removes these; returns how many are left.
 * `groups` has the group of each face, or is NULL; `table` has room for tia_model_slots(count) numbers. */
uint32_t tia_model_unique(struct tia_face *faces, uint32_t *groups, uint32_t count, const struct tia_vec3 *vertices,
                          uint32_t *table);
uint32_t tia_model_slots(uint32_t face_count);

/* True if all corners have normals, none of them (0, 0, 0). */
bool tia_model_has_normals(const struct tia_array *normals, const struct tia_corner *corners, uint32_t count);

/* Gives a direction to normals of (0, 0, 0): no face uses them any more, but a mesh must not contain them. */
void tia_model_fix_normals(struct tia_array *normals);

#endif
