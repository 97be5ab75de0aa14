/* The sums of a scene's steps: a change of any array changes the sum of its step, and none before it. */
#include <tia/tia.h>

#include "check.h"
#include "common/scene/scene_load.h"
#include "scene/picture.h"
#include "scene/scene_sum.h"

static struct scene_file file;
static const struct tia_scene *scene;
static unsigned arrays_seen;

/* The sums of all steps differ where `changed` says. */
static bool differ(const struct tia_scene *s, const uint64_t sums[SCENE_STEPS], int changed)
{
    for (int step = 0; step <= changed; step++)
        if ((tia_scene_sum(s, step) == sums[step]) == (step == changed))
            return false;
    return true;
}

/* Changes a bit of up to 64 bytes of an array of a step. Sums of later steps are not asked for: the array may have
 * pointers. */
static void change_array(const char *name, int step, const void *array, size_t size)
{
    unsigned char *bytes = (unsigned char *)(uintptr_t)array;
    size_t stride = size / 64 + 1;
    uint64_t sums[SCENE_STEPS];

    for (int i = 0; i < SCENE_STEPS; i++)
        sums[i] = tia_scene_sum(scene, i);

    arrays_seen += size > 0;
    for (size_t i = 0; i < size; i += i + stride < size || i == size - 1 ? stride : size - 1 - i) {
        bytes[i] ^= (unsigned char)(1u << i % 8);
        CHECK_MSG(differ(scene, sums, step), "%s: byte %zu of %zu", name, i, size);
        bytes[i] ^= (unsigned char)(1u << i % 8);
    }
}

#define ARRAY(step, pointer, count) change_array(#pointer, step, pointer, (count) * sizeof *(pointer))

static void change_tree(int step, const struct tia_bvh_tree *tree)
{
    ARRAY(step, tree->nodes, tree->node_count);
    ARRAY(step, tree->items, tree->item_count);
}

static void change_mesh(const struct tia_mesh *mesh)
{
    ARRAY(SCENE_PARTS, mesh->vertices, mesh->vertex_count);
    ARRAY(SCENE_PARTS, mesh->normals, mesh->normal_count);
    ARRAY(SCENE_PARTS, mesh->uvs, mesh->uv_count);
    ARRAY(SCENE_PARTS, mesh->faces, mesh->face_count);
    ARRAY(SCENE_PARTS, mesh->groups, mesh->groups ? mesh->face_count : 0);
}

static void change_deep_arrays(const struct tia_scene *s)
{
    for (uint32_t i = 0; i < s->mesh_count; i++) {
        change_mesh(&s->meshes[i]);
        change_tree(SCENE_TREES, &s->bvh->meshes[i]);
    }
    for (uint32_t i = 0; i < s->texture_count; i++)
        ARRAY(SCENE_PARTS, s->textures[i].texels,
              texture_has_texels(&s->textures[i])
                  ? (size_t)s->textures[i].width * s->textures[i].height * (s->textures[i].kind == TIA_IMAGE ? 3 : 1)
                  : 0);
    for (uint32_t i = 0; i < s->grid_count; i++)
        ARRAY(SCENE_PARTS, s->grids[i].cells, (size_t)s->grids[i].size[0] * s->grids[i].size[1] * s->grids[i].size[2]);
    for (uint32_t i = 0; i < s->solid_count; i++) {
        ARRAY(SCENE_PARTS, s->solids[i].members, s->solids[i].member_count);
        ARRAY(SCENE_PARTS, s->solids[i].steps, s->solids[i].step_count);
    }
    for (uint32_t i = 0; i < s->track_count; i++)
        ARRAY(SCENE_PARTS, s->tracks[i].keys, s->tracks[i].key_count);
    if (s->fine) {
        ARRAY(SCENE_PARTS, s->fine->spheres, s->sphere_count);
        ARRAY(SCENE_PARTS, s->fine->shapes, s->shape_count);
    }
    if (s->falling)
        ARRAY(SCENE_PARTS, s->falling->balls, s->falling->count);
}

static void change_arrays(const struct tia_scene *s)
{
    ARRAY(SCENE_SELF, s, 1);
    ARRAY(SCENE_ARRAYS, s->materials, s->material_count);
    ARRAY(SCENE_ARRAYS, s->spheres, s->sphere_count);
    ARRAY(SCENE_ARRAYS, s->lights, s->light_count);
    ARRAY(SCENE_ARRAYS, s->bindings, s->binding_count);
    ARRAY(SCENE_ARRAYS, s->shapes, s->shape_count);
    ARRAY(SCENE_ARRAYS, s->transforms, s->transform_count);
    ARRAY(SCENE_ARRAYS, s->textures, s->texture_count);
    ARRAY(SCENE_ARRAYS, s->meshes, s->mesh_count);
    ARRAY(SCENE_ARRAYS, s->grids, s->grid_count);
    ARRAY(SCENE_ARRAYS, s->solids, s->solid_count);
    ARRAY(SCENE_ARRAYS, s->tracks, s->track_count);
    ARRAY(SCENE_ARRAYS, s->fine, s->fine ? 1 : 0);
    ARRAY(SCENE_ARRAYS, s->field, s->field ? 1 : 0);
    ARRAY(SCENE_ARRAYS, s->falling, s->falling ? 1 : 0);
    if (s->bvh) {
        ARRAY(SCENE_ARRAYS, s->bvh, 1);
        ARRAY(SCENE_PARTS, s->bvh->meshes, s->mesh_count);
        ARRAY(SCENE_PARTS, s->bvh->unbounded, s->bvh->unbounded_count);
        change_tree(SCENE_PARTS, &s->bvh->objects);
    }
    change_deep_arrays(s);
}

/* Adds what few files have. */
static struct tia_scene completed(const struct tia_scene *s)
{
    static struct tia_fine_sphere spheres[16];
    static struct tia_fine_ends ends[64];
    static struct tia_fine fine;
    static struct tia_light_field field;
    static struct tia_fall balls[3];
    static struct tia_falling falling;
    static struct tia_mesh meshes[8];
    static uint32_t groups[1000];
    struct tia_scene all = *s;

    CHECK(s->sphere_count <= 16 && s->shape_count <= 64 && s->mesh_count <= 8 && s->mesh_count > 0);
    memcpy(meshes, s->meshes, s->mesh_count * sizeof *meshes);
    meshes[0].groups = groups;
    CHECK(meshes[0].face_count <= 1000);
    fine.spheres = spheres;
    fine.shapes = ends;
    falling.balls = balls;
    falling.count = 3;
    all.meshes = meshes;
    all.fine = &fine;
    all.field = &field;
    all.falling = &falling;
    return all;
}

static void change_scene(const char *path, bool complete)
{
    struct tia_scene all;
    int status = scene_open(&file, path, TIA_FORMAT_TIA, false);

    CHECK_MSG(status == TIA_OK, "%.300s", file.why);
    if (status)
        return;
    all = complete ? completed(&file.scene) : file.scene;
    scene = &all;
    if (!check_failed)
        change_arrays(&all);
    scene_close(&file);
}

TEST(changes_of_all_arrays)
{
    change_scene("tests/scenes/every.tia", true);
    change_scene("scenes/marbles.tia", false);
    change_scene("scenes/chess.tia", false);
    CHECK_MSG(arrays_seen > 60, "only %u arrays", arrays_seen);
}

/* Scenes without arrays, which may have NULL for them. */
TEST(empty_scenes)
{
    struct tia_scene none = {0};
    uint64_t zero = tia_scene_sum(&tia_thesis_scene, SCENE_PARTS);

    for (int step = SCENE_ARRAYS; step < SCENE_STEPS; step++)
        CHECK(tia_scene_sum(&none, step) == zero);
    CHECK(tia_scene_sum(&tia_thesis_scene, SCENE_ARRAYS) != zero);
}

int main(void)
{
    RUN(changes_of_all_arrays);
    RUN(empty_scenes);
    return check_status();
}
