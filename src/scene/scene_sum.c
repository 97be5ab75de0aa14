#include "scene_sum.h"

#include "math/checksum.h"
#include "picture.h"

#include <tia/bvh.h>
#include <tia/mip.h>
#include <tia/motion.h>

/* Adds an array of `count` elements, which is NULL if there are none. */
static void add(struct checksum *sum, const void *array, uint32_t count, size_t element)
{
    if (array)
        tia_checksum_add(sum, array, (size_t)count * element);
}

#define ADD(sum, elements, count) add(sum, elements, count, sizeof *(elements))

static void add_arrays(struct checksum *sum, const struct tia_scene *s)
{
    ADD(sum, s->materials, s->material_count);
    ADD(sum, s->spheres, s->sphere_count);
    ADD(sum, s->lights, s->light_count);
    ADD(sum, s->bindings, s->binding_count);
    ADD(sum, s->shapes, s->shape_count);
    ADD(sum, s->transforms, s->transform_count);
    ADD(sum, s->textures, s->texture_count);
    ADD(sum, s->meshes, s->mesh_count);
    ADD(sum, s->grids, s->grid_count);
    ADD(sum, s->solids, s->solid_count);
    ADD(sum, s->tracks, s->track_count);
    ADD(sum, s->fine, 1);
    ADD(sum, s->field, 1);
    ADD(sum, s->fog, 1);
    ADD(sum, s->lens, 1);
    ADD(sum, s->bvh, 1);
    ADD(sum, s->falling, 1);
}

static void add_mesh(struct checksum *sum, const struct tia_mesh *m)
{
    ADD(sum, m->vertices, m->vertex_count);
    ADD(sum, m->normals, m->normal_count);
    ADD(sum, m->uvs, m->uv_count);
    ADD(sum, m->faces, m->face_count);
    ADD(sum, m->groups, m->face_count);
}

static void add_images(struct checksum *sum, const struct tia_scene *s)
{
    for (uint32_t i = 0; i < s->texture_count; i++) {
        const struct tia_texture *t = &s->textures[i];
        if (!texture_has_texels(t))
            continue;
        add(sum, t->texels, (uint32_t)t->width * t->height, t->kind == TIA_IMAGE ? 3 : 1);
        if (t->mip_levels)
            add(sum, t->mip_levels, 1, tia_mip_size(t));
    }
    for (uint32_t i = 0; i < s->grid_count; i++) {
        const uint16_t *size = s->grids[i].size;
        ADD(sum, s->grids[i].cells, (uint32_t)size[0] * size[1] * size[2]);
    }
}

static void add_tree(struct checksum *sum, const struct tia_bvh_tree *tree)
{
    ADD(sum, tree->nodes, tree->node_count);
    ADD(sum, tree->items, tree->item_count);
}

/* Adds what the scene's arrays refer to. */
static void add_parts(struct checksum *sum, const struct tia_scene *s)
{
    for (uint32_t i = 0; i < s->mesh_count; i++)
        add_mesh(sum, &s->meshes[i]);
    for (uint32_t i = 0; i < s->solid_count; i++) {
        ADD(sum, s->solids[i].members, s->solids[i].member_count);
        ADD(sum, s->solids[i].steps, s->solids[i].step_count);
    }
    add_images(sum, s);
    for (uint32_t i = 0; i < s->track_count; i++)
        ADD(sum, s->tracks[i].keys, s->tracks[i].key_count);
    if (s->fine) {
        ADD(sum, s->fine->spheres, s->sphere_count);
        ADD(sum, s->fine->shapes, s->shape_count);
    }
    if (s->falling)
        ADD(sum, s->falling->balls, s->falling->count);
    if (s->bvh) {
        add_tree(sum, &s->bvh->objects);
        ADD(sum, s->bvh->meshes, s->mesh_count);
        ADD(sum, s->bvh->unbounded, s->bvh->unbounded_count);
    }
}

uint64_t tia_scene_sum(const struct tia_scene *scene, int step)
{
    struct checksum sum = {0, 0};

    if (step == SCENE_SELF)
        ADD(&sum, scene, 1);
    else if (step == SCENE_ARRAYS)
        add_arrays(&sum, scene);
    else if (step == SCENE_PARTS)
        add_parts(&sum, scene);
    else
        for (uint32_t i = 0; scene->bvh && scene->bvh->meshes && i < scene->mesh_count; i++)
            add_tree(&sum, &scene->bvh->meshes[i]);
    return tia_checksum_value(&sum);
}
