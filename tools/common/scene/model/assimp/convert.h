/* convert.h - the state of a conversion, shared by its steps; see convert_model.c. */
#ifndef TOOLS_SCENE_MODEL_ASSIMP_CONVERT_H
#define TOOLS_SCENE_MODEL_ASSIMP_CONVERT_H

#include <assimp/material.h>
#include <assimp/scene.h>

#include "affine.h"
#include "library.h"
#include "model_files.h"

struct texture_key;

/* A node's use of a mesh. */
struct mesh_use {
    struct affine to_world;
    uint32_t mesh, material, number; /* number: its place in the order of the nodes */
    bool instance;                   /* placed by a transform; otherwise its vertices are */
};

struct convert {
    struct assimp_library library;
    struct model_files files;
    const struct aiScene *from;
    struct pack pack;
    struct mesh_use *uses;
    uint32_t use_count, use_room;
    uint32_t *mesh_uses;              /* for each mesh the number of its uses */
    struct texture_key *texture_keys; /* of the textures so far */
    uint32_t texture_key_count;
    struct box box; /* of all faces, in the file's unit */

    /* The position p of the file is (p - origin) 2^bits in the scene. */
    double origin[3];
    int bits;
};

/* Sets the error unless there is one; returns `status`. */
int convert_fail(struct convert *c, int status, const char *format, ...) __attribute__((format(printf, 3, 4)));
int convert_exhausted(struct convert *c);

/* Adds a warning, of whose kind the first is kept. */
void convert_warn(struct convert *c, enum tia_read_warning_kind kind, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Rounds to nearest; numbers beyond the range, and those that are none, are clamped. */
int32_t convert_fixed(double x, double one);
/* A position of the file in the scene. */
struct tia_vec3 convert_place(const struct convert *c, const double at[3]);
struct tia_dir3 convert_direction(const double d[3]);
/* A colour, clamped to 0..most. */
struct tia_rgb convert_colour(const double rgb[3], double most);

/* ---- nodes.c ---- */
/* Collects the uses of meshes. */
int convert_nodes(struct convert *c);
/* Finds the place of the node of that name. */
bool convert_node_place(const struct convert *c, const struct aiString *name, struct affine *place);

/* ---- meshes.c ---- */
/* Measures the faces. */
int convert_measure(struct convert *c);
int convert_meshes(struct convert *c);

/* ---- materials.c ---- */
int convert_materials(struct convert *c);

/* ---- unit.c ---- */
/* Chooses origin and bits. */
int convert_fit(struct convert *c);
/* True for a position where the camera or a light may be. */
bool convert_reaches(const struct convert *c, const double at[3]);
/* True for files whose angles and fields of view are glTF's. */
bool convert_is_gltf(const struct convert *c);

/* ---- lights.c ---- */
/* Adds the lights, after convert_fit. Returns false if there is no memory. */
bool convert_lights(struct convert *c);

/* ---- view.c ---- */
int convert_view(struct convert *c);

#endif
