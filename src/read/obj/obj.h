/* obj.h - the state of the .obj reader, shared by its statements; see obj.c. */
#ifndef TIA_READ_OBJ_OBJ_H
#define TIA_READ_OBJ_OBJ_H

#include "read/model/model.h"
#include "read/readers.h"
#include "read/text/name_table.h"

#define OBJ_LIBRARIES 16 /* material libraries in one scene */

/* The passes over the text and its libraries. The first pass stores nothing. */
enum obj_pass {
    OBJ_COUNT,
    OBJ_MEASURE, /* stores the names of materials and images; counts the faces of each material */
    OBJ_FILL
};

/* Kinds of names. OBJ_OPACITY + c are images whose channel c, an enum tia_channel, is an opacity. */
enum obj_name { OBJ_MATERIAL, OBJ_IMAGE, OBJ_OBJECT, OBJ_GROUP, OBJ_OPACITY };

struct obj_library {
    struct tia_word name; /* the library's name in the text */
    const char *text;
    size_t length;
};

/* The faces of one material, and the range of the text's vertices, normals and uvs that they use. */
struct obj_group {
    uint32_t face_count, next_face;
    uint32_t low[3], high[3]; /* low > high: none */
};

struct obj {
    struct tia_model model;
    struct tia_reader *reader; /* model.reader */
    struct tia_scene *scene;
    struct tia_text text;
    enum obj_pass pass;
    struct obj_library libraries[OBJ_LIBRARIES];
    uint32_t library_count;

    struct tia_array materials, textures, names, vertices, normals, uvs;
    struct tia_face *faces;
    uint32_t *table; /* working storage, see tia_model_unique */
    uint32_t face_count, material_uses, most_corners;
    struct polygon_corner *polygon; /* working storage for the largest polygon */
    struct tia_corner *corners;

    struct tia_array group_lines; /* names of o and g lines */
    uint32_t *face_groups;        /* group of each face; NULL without such lines */
    uint32_t face_group;          /* group of the next face */

    struct obj_group *groups; /* one for each material; then those of the parts */
    uint32_t group;           /* material of the next face */

    struct obj_parts *parts; /* NULL: the text is read by one thread */
    const char *head_end;    /* with parts, the end of the text that is read without them */
};

/* ---- statement.c ---- */
/* Reads a statement whose first word is `word`. */
int tia_obj_statement(struct obj *o, const struct tia_word *word);

/* ---- parts.c ---- */
/* Allocates the parts of a long text for which there are threads. Returns NULL for any other text, or if they do not
 * fit. */
struct obj_parts *tia_obj_take_parts(const struct tia_reader *reader, struct tia_arena *arena);
/* Returns how many copies of the working storage the head and the parts need. */
uint32_t tia_obj_copies(const struct tia_reader *reader, uint32_t materials);
/* Divides the text into the head, up to o->head_end, and parts. Returns false if it cannot be read by parts. */
bool tia_obj_divide(struct obj *o);
/* Reads the parts, after the head, in o->pass. Returns false if one of them has a mistake. */
bool tia_obj_read_parts(struct obj *o);
/* Counts all faces as those of the first material: `face_count` of the whole text, of which the parts have theirs. */
void tia_obj_count_faces(struct obj *o, uint32_t face_count);
/* Places the faces of each material in their order in the text. */
void tia_obj_place_groups(struct obj *o);
/* Adds the groups of the parts to those of the head. */
void tia_obj_join_groups(struct obj *o);

/* ---- name.c ---- */
/* Reads the rest of the line as a name, which may contain blanks: many programs write such names. */
int tia_obj_name(struct tia_text *t, struct tia_word *name, const char *expected);

/* ---- warn.c ---- */
/* Turns the error just found into a warning of that kind and returns TIA_OK; with reader->strict, returns
 * TIA_ERR_RANGE. */
int tia_obj_forgive(struct obj *o, enum tia_read_warning_kind kind);

/* Reports a file for which a callback failed with `status` and `why`: as a warning or, if memory is short, as an
 * error. */
int tia_obj_unreadable(struct obj *o, struct tia_text *t, const struct tia_word *word, int status, const char *why,
                       enum tia_read_warning_kind kind);

/* Skips the rest of the line, and the lines joined to it by backslashes. */
void tia_obj_skip(struct tia_text *t);

/* ---- material.c ---- */
int tia_obj_usemtl(struct obj *o);
int tia_obj_mtllib(struct obj *o);

/* ---- face.c ---- */
int tia_obj_f(struct obj *o);
int tia_obj_make_meshes(struct obj *o, struct tia_mesh *meshes, struct tia_shape *shapes);

/* ---- group.c ---- */
int tia_obj_o(struct obj *o);
int tia_obj_g(struct obj *o);

/* ---- mtl.c ---- */
/* Adds the first material, which faces without a material get. */
void tia_mtl_add_default(struct obj *o);
int tia_mtl_read(struct obj *o, const struct obj_library *library);

#endif
