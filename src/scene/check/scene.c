/* scene.c - the whole check, in order: an object is checked before the indices that point to it. */
#include <tia/motion.h>

#include "check.h"

static bool is_array(const void *array, uint32_t count)
{
    return array || !count;
}

static bool are_arrays(const struct tia_scene *s)
{
    return is_array(s->materials, s->material_count) && is_array(s->spheres, s->sphere_count) &&
           is_array(s->lights, s->light_count) && is_array(s->bindings, s->binding_count) &&
           is_array(s->shapes, s->shape_count) && is_array(s->transforms, s->transform_count) &&
           is_array(s->textures, s->texture_count) && is_array(s->meshes, s->mesh_count) &&
           is_array(s->grids, s->grid_count) && is_array(s->tracks, s->track_count);
}

/* True if the hierarchy fits the scene: one built for another scene would leave objects out. */
static bool is_bvh(const struct tia_scene *scene)
{
    const struct tia_bvh *b = scene->bvh;
    return !b ||
           (uint64_t)b->objects.item_count + b->unbounded_count == (uint64_t)scene->sphere_count + scene->shape_count;
}

static int check_whole(struct check *check)
{
    const struct tia_scene *scene = check->scene;
    int status;

    REQUIRE(are_arrays(scene), "arrays", "an array with a count must not be NULL");
    REQUIRE((uint64_t)scene->sphere_count + scene->light_count <= INT32_MAX, "counts",
            "spheres and lights must be fewer than 2^31");
    REQUIRE((uint64_t)scene->sphere_count + scene->shape_count <= TIA_OBJECTS_MAX, "counts",
            "spheres and shapes must be at most 2^24");
    check->thing = "camera";
    status = tia_check_camera(check);
    if (status)
        return status;
    check->thing = "scene";
    REQUIRE(tia_check_is_unit(&scene->background), "background", CHECK_UNIT);
    REQUIRE(scene->depth <= TIA_DEPTH_MAX, "depth", "must be in 1..16");
    REQUIRE(is_bvh(scene), "bvh", "must be of this scene");
    return tia_check_falling(check);
}

static int check_light(const struct check *check)
{
    return tia_check_light(check, &check->scene->lights[check->index]);
}

static int check_key(const struct check *check)
{
    return tia_check_light(check, &check->scene->bindings[check->index].state);
}

static int check_each(struct check *check, const char *thing, uint32_t count, int (*one)(const struct check *check))
{
    int status = TIA_OK;

    check->thing = thing;
    for (check->index = 0; !status && check->index < count; check->index++)
        status = cancelled(check->cancel, 1) ? TIA_STOPPED : one(check);
    return status;
}

static int check_parts(struct check *check)
{
    static const struct {
        const char *thing;
        size_t count; /* array and count in the scene */
        int (*one)(const struct check *check);
    } parts[] = {
        {"material", offsetof(struct tia_scene, material_count), tia_check_material},
        {"sphere", offsetof(struct tia_scene, sphere_count), tia_check_sphere},
        {"light", offsetof(struct tia_scene, light_count), check_light},
        {"key", offsetof(struct tia_scene, binding_count), check_key},
        {"texture", offsetof(struct tia_scene, texture_count), tia_check_texture},
        {"transform", offsetof(struct tia_scene, transform_count), tia_check_transform},
        {"mesh", offsetof(struct tia_scene, mesh_count), tia_check_mesh},
        {"grid", offsetof(struct tia_scene, grid_count), tia_check_grid},
        {"shape", offsetof(struct tia_scene, shape_count), tia_check_shape},
        {"track", offsetof(struct tia_scene, track_count), tia_check_track},
    };
    const struct tia_scene *s = check->scene;
    int status = TIA_OK;

    for (size_t i = 0; !status && i < sizeof parts / sizeof *parts; i++)
        status = check_each(check, parts[i].thing, *(const uint32_t *)(const void *)((const char *)s + parts[i].count),
                            parts[i].one);
    return status ? status : check_each(check, "fall", s->falling ? s->falling->count : 0, tia_check_fall);
}

/* Returns a box around the camera's eye and its positions in tracks. Tracks are not checked yet: a bad one may have no
 * keys. */
static struct tia_bounds find_eyes(const struct tia_scene *scene)
{
    struct tia_bounds eyes = {scene->camera.eye, scene->camera.eye};

    for (uint32_t i = 0; i < scene->track_count; i++) {
        const struct tia_track *t = &scene->tracks[i];
        for (uint32_t k = 0; t->target == TIA_MOVES_EYE && t->keys && k < t->key_count; k++)
            tia_bounds_add(&eyes, &(struct tia_bounds){t->keys[k].value, t->keys[k].value});
    }
    tia_check_eyes(&scene->camera, &eyes);
    return eyes;
}

int tia_check_scene(const struct tia_scene *scene, struct tia_fault *fault, struct cancel *cancel)
{
    struct check check = {.scene = scene, .fault = fault, .thing = "scene", .cancel = cancel};
    int status;

    if (!scene->tracks && scene->track_count)
        return tia_check_refuse(&check, "arrays", "an array with a count must not be NULL");
    check.eyes = find_eyes(scene);
    status = check_whole(&check);
    if (!status)
        status = check_parts(&check);
    check.thing = "shape";
    status = status ? status : tia_check_uses(&check);
    return status ? status : tia_check_rendering(&check);
}

int tia_scene_check(const struct tia_scene *scene, struct tia_fault *fault)
{
    struct cancel nobody = {0};

    if (!scene)
        return TIA_ERR_ARGUMENT;
    return tia_check_scene(scene, fault, &nobody);
}
