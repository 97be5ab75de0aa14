/* model_pack.h - a model as a file in memory, from the process that imports it: a header, then arrays. */
#ifndef TOOLS_SCENE_MODEL_MODEL_PACK_H
#define TOOLS_SCENE_MODEL_MODEL_PACK_H

#include <tia/tia.h>

#define MODEL_WHY 600
#define MODEL_UNFINISHED 1 /* status while the importing process works */

/* The arrays, and their elements. */
enum model_array_name {
    MODEL_MATERIALS,  /* struct tia_material */
    MODEL_NAMES,      /* struct model_name, one for each material */
    MODEL_LIGHTS,     /* struct tia_light */
    MODEL_SHAPES,     /* struct tia_shape, all of the kind TIA_MESH */
    MODEL_TRANSFORMS, /* struct tia_transform */
    MODEL_TEXTURES,   /* struct model_texture */
    MODEL_MESHES,     /* struct model_mesh */
    MODEL_VERTICES,   /* struct tia_vec3 */
    MODEL_NORMALS,    /* struct tia_dir3 */
    MODEL_UVS,        /* struct tia_uv */
    MODEL_FACES,      /* struct tia_face */
    MODEL_GROUPS,     /* uint32_t */
    MODEL_TEXELS,     /* uint8_t */
    MODEL_FILES,      /* struct model_input; the last array */
    MODEL_ARRAYS
};

struct model_name {
    char text[TIA_NAME_MAX + 1];
};

#define MODEL_PATH 4096

struct model_input {
    uint64_t device, inode;
    char path[MODEL_PATH]; /* ends with a 0 */
};

/* A range of an array. */
struct model_range {
    uint64_t first, count;
};

struct model_mesh {
    struct model_range vertices, normals, uvs, faces, groups; /* groups: none, or one for each face */
};

struct model_texture {
    struct tia_texture texture; /* without texels */
    struct model_range texels;
};

struct model_header {
    int32_t status; /* enum tia_status, or MODEL_UNFINISHED */
    int32_t scale_bits;
    char why[MODEL_WHY]; /* after an error, the reason */
    struct tia_read_warning warnings[TIA_WARNINGS];
    struct tia_camera camera;
    struct tia_placement placement;
    uint64_t offset[MODEL_ARRAYS], count[MODEL_ARRAYS];
};

/* Returns the size of an array's elements. */
size_t model_element(enum model_array_name name);

#endif
