/* scene.c - the whole check, in order: what an index points to is checked before what has the index. */
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

/* A hierarchy built for another scene would leave objects out. */
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

enum part { MATERIALS, SPHERES, LIGHTS, KEYS, TEXTURES, TRANSFORMS, MESHES, GRIDS, SHAPES, TRACKS, FALLS, PARTS };

static int check_one(const struct check *check, enum part part)
{
    switch (part) {
    case MATERIALS:
        return tia_check_material(check);
    case SPHERES:
        return tia_check_sphere(check);
    case LIGHTS:
        return tia_check_light(check, &check->scene->lights[check->index]);
    case KEYS:
        return tia_check_light(check, &check->scene->bindings[check->index].state);
    case TEXTURES:
        return tia_check_texture(check);
    case TRANSFORMS:
        return tia_check_transform(check);
    case MESHES:
        return tia_check_mesh(check);
    case GRIDS:
        return tia_check_grid(check);
    case SHAPES:
        return tia_check_shape(check);
    case TRACKS:
        return tia_check_track(check);
    case FALLS:
    default:
        return tia_check_fall(check);
    }
}

static int check_parts(struct check *check)
{
    const struct tia_scene *s = check->scene;
    const struct {
        const char *thing;
        uint32_t count;
    } parts[PARTS] = {
        [MATERIALS] = {"material", s->material_count},
        [SPHERES] = {"sphere", s->sphere_count},
        [LIGHTS] = {"light", s->light_count},
        [KEYS] = {"key", s->binding_count},
        [TEXTURES] = {"texture", s->texture_count},
        [TRANSFORMS] = {"transform", s->transform_count},
        [MESHES] = {"mesh", s->mesh_count},
        [GRIDS] = {"grid", s->grid_count},
        [SHAPES] = {"shape", s->shape_count},
        [TRACKS] = {"track", s->track_count},
        [FALLS] = {"fall", s->falling ? s->falling->count : 0},
    };
    int status = TIA_OK;

    for (unsigned part = 0; !status && part < PARTS; part++) {
        check->thing = parts[part].thing;
        for (check->index = 0; !status && check->index < parts[part].count; check->index++)
            status = asker_stops(check->asker, 1) ? TIA_STOPPED : check_one(check, (enum part)part);
    }
    return status;
}

/* The camera's eye, and where tracks move it. Tracks are not checked yet: a bad one may have no keys. */
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

int tia_check_scene(const struct tia_scene *scene, struct tia_fault *fault, struct asker *asker)
{
    struct check check = {.scene = scene, .fault = fault, .thing = "scene", .asker = asker};
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
    struct asker nobody = {0};

    return tia_check_scene(scene, fault, &nobody);
}
