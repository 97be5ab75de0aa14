#include "model_map.h"

#include <stdlib.h>

const void *model_map_array(const struct model_header *header, enum model_array_name name)
{
    return (const char *)header + header->offset[name];
}

static bool array_is_inside(const struct model_header *header, enum model_array_name name, size_t size)
{
    uint64_t offset = header->offset[name], count = header->count[name];
    return offset % 8 == 0 && offset <= size && count <= UINT32_MAX && count <= (size - offset) / model_element(name);
}

static bool is_inside(const struct model_header *header, enum model_array_name name, struct model_range range)
{
    return range.first <= header->count[name] && range.count <= header->count[name] - range.first;
}

/* Returns the range of an array; NULL if it is empty. */
static const void *part_of(const struct model_header *header, enum model_array_name name, struct model_range range)
{
    return range.count ? (const char *)model_map_array(header, name) + range.first * model_element(name) : NULL;
}

static bool map_mesh(struct tia_mesh *mesh, const struct model_header *header, const struct model_mesh *packed)
{
    if (!is_inside(header, MODEL_VERTICES, packed->vertices) || !is_inside(header, MODEL_NORMALS, packed->normals) ||
        !is_inside(header, MODEL_UVS, packed->uvs) || !is_inside(header, MODEL_FACES, packed->faces) ||
        !is_inside(header, MODEL_GROUPS, packed->groups) ||
        (packed->groups.count && packed->groups.count != packed->faces.count))
        return false;
    *mesh = (struct tia_mesh){.vertices = part_of(header, MODEL_VERTICES, packed->vertices),
                              .normals = part_of(header, MODEL_NORMALS, packed->normals),
                              .uvs = part_of(header, MODEL_UVS, packed->uvs),
                              .faces = part_of(header, MODEL_FACES, packed->faces),
                              .groups = part_of(header, MODEL_GROUPS, packed->groups),
                              .vertex_count = (uint32_t)packed->vertices.count,
                              .normal_count = (uint32_t)packed->normals.count,
                              .uv_count = (uint32_t)packed->uvs.count,
                              .face_count = (uint32_t)packed->faces.count};
    return true;
}

static bool map_texture(struct tia_texture *texture, const struct model_header *header,
                        const struct model_texture *packed)
{
    uint64_t texels = (uint64_t)packed->texture.width * packed->texture.height;
    *texture = packed->texture;
    texture->texels = part_of(header, MODEL_TEXELS, packed->texels);
    return is_inside(header, MODEL_TEXELS, packed->texels) &&
           packed->texels.count == texels * (texture->kind == TIA_OPACITY ? 1 : 3);
}

static bool map_tables(struct tia_mesh *meshes, struct tia_texture *textures, const struct model_header *header)
{
    const struct model_mesh *packed = model_map_array(header, MODEL_MESHES);
    const struct model_texture *images = model_map_array(header, MODEL_TEXTURES);

    for (uint64_t i = 0; i < header->count[MODEL_MESHES]; i++)
        if (!map_mesh(&meshes[i], header, &packed[i]))
            return false;
    for (uint64_t i = 0; i < header->count[MODEL_TEXTURES]; i++)
        if (!map_texture(&textures[i], header, &images[i]))
            return false;
    return true;
}

int model_map(struct tia_scene *scene, void **tables, const struct model_header *header, size_t size)
{
    for (unsigned name = 0; name < MODEL_ARRAYS; name++)
        if (!array_is_inside(header, (enum model_array_name)name, size))
            return TIA_ERR_RANGE;
    size_t meshes = (size_t)header->count[MODEL_MESHES], textures = (size_t)header->count[MODEL_TEXTURES];
    struct tia_mesh *mesh = calloc(1, meshes * sizeof *mesh + textures * sizeof(struct tia_texture) + 1);
    struct tia_texture *texture = mesh ? (void *)(mesh + meshes) : NULL;
    *tables = mesh;
    if (!mesh)
        return TIA_ERR_MEMORY;
    *scene = (struct tia_scene){.camera = header->camera,
                                .background = TIA_RGB(0.8, 0.8, 0.8),
                                .materials = model_map_array(header, MODEL_MATERIALS),
                                .lights = model_map_array(header, MODEL_LIGHTS),
                                .shapes = model_map_array(header, MODEL_SHAPES),
                                .transforms = model_map_array(header, MODEL_TRANSFORMS),
                                .meshes = mesh,
                                .textures = texture,
                                .material_count = (uint32_t)header->count[MODEL_MATERIALS],
                                .light_count = (uint32_t)header->count[MODEL_LIGHTS],
                                .shape_count = (uint32_t)header->count[MODEL_SHAPES],
                                .transform_count = (uint32_t)header->count[MODEL_TRANSFORMS],
                                .mesh_count = (uint32_t)meshes,
                                .texture_count = (uint32_t)textures,
                                .scale_bits = header->scale_bits};
    return map_tables(mesh, texture, header) ? TIA_OK : TIA_ERR_RANGE;
}
