#include "model_pack.h"

size_t model_element(enum model_array_name name)
{
    static const size_t sizes[MODEL_ARRAYS] = {
        [MODEL_MATERIALS] = sizeof(struct tia_material),
        [MODEL_NAMES] = sizeof(struct model_name),
        [MODEL_LIGHTS] = sizeof(struct tia_light),
        [MODEL_SHAPES] = sizeof(struct tia_shape),
        [MODEL_TRANSFORMS] = sizeof(struct tia_transform),
        [MODEL_TEXTURES] = sizeof(struct model_texture),
        [MODEL_MESHES] = sizeof(struct model_mesh),
        [MODEL_VERTICES] = sizeof(struct tia_vec3),
        [MODEL_NORMALS] = sizeof(struct tia_dir3),
        [MODEL_UVS] = sizeof(struct tia_uv),
        [MODEL_FACES] = sizeof(struct tia_face),
        [MODEL_GROUPS] = sizeof(uint32_t),
        [MODEL_TEXELS] = 1,
        [MODEL_FILES] = sizeof(struct model_input),
    };
    return sizes[name];
}
