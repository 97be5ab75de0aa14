/* plain.h - models of one mesh with one material: STL, PLY, OFF and height fields.
 *
 * The file is read twice. The first pass measures the vertices and counts; the second one stores.
 */
#ifndef TIA_READ_MODEL_PLAIN_H
#define TIA_READ_MODEL_PLAIN_H

#include "model.h"
#include "read/readers.h"

struct tia_plain {
    struct tia_model model;
    const char *faces_expected; /* describes a face in an error: "some facets" */
    struct tia_array vertices, normals, uvs;
    struct tia_face *faces;
    uint32_t face_count, most_corners;
    struct tia_corner *corners;     /* of the next polygon: room for most_corners */
    struct polygon_corner *polygon; /* working storage */
    bool distinct;                  /* no face is given twice */
    uint32_t *table;                /* working storage */
    uint64_t colour[3];             /* sums of the vertices' colours, 0 to 255 each */
    uint32_t colours;               /* number of vertices with a colour */
};

/* Reads a model; `read` reads the file once. */
int tia_plain_read(struct tia_plain *plain, struct tia_arena *arena, int (*read)(struct tia_plain *, void *ctx),
                   void *ctx);

/* Begins to read a model. */
struct tia_plain tia_plain_begin(struct tia_reader *reader, struct tia_scene *scene, struct tia_model_use *use,
                                 const char *faces_expected);

/* Adds a polygon of `count` corners, 3 to POLYGON_MAX, which are in plain->corners; the first pass counts it. */
void tia_plain_polygon(struct tia_plain *plain, uint32_t count);

/* Sets a corner of the next polygon; the first pass only counts it. Without normals or uvs, the corner has none; else
 * their indices are the vertex's. */
void tia_plain_corner(struct tia_plain *plain, uint32_t corner, uint32_t vertex);

/* Sets the error's text for a binary file: "THING NUMBER: ", the number counted from 1. Returns TIA_ERR_RANGE. */
int tia_plain_error(const struct tia_plain *plain, const char *thing, uint32_t number);

/* Turns the error into a warning, counted in the first pass. */
int tia_plain_forgive(struct tia_plain *plain, enum tia_read_warning_kind kind, const char *remedy);

#endif
