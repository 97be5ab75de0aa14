/* more.c - checks of scenes with more than spheres. */
#include <tia/motion.h>

#include "scene_check.h"

/* Enlarges *eyes to cover all positions of the eye. Tracks are not checked yet: their keys may be NULL. */
static void find_eyes(const struct tia_scene *scene, struct tia_bounds *eyes)
{
    for (uint32_t i = 0; i < scene->track_count; i++) {
        const struct tia_track *t = &scene->tracks[i];
        for (uint32_t k = 0; t->target == TIA_MOVES_EYE && t->keys && k < t->key_count; k++)
            tia_bounds_add(eyes, &(struct tia_bounds){t->keys[k].value, t->keys[k].value});
    }
    tia_check_eyes(&scene->camera, eyes);
}

static bool are_arrays(const struct tia_scene *s)
{
    return check_is_array(s->shapes, s->shape_count) && check_is_array(s->transforms, s->transform_count) &&
           check_is_array(s->meshes, s->mesh_count) && check_is_array(s->grids, s->grid_count) &&
           check_is_array(s->solids, s->solid_count);
}

static int check_parts(struct check *check)
{
    static const struct {
        const char *thing;
        size_t count; /* offset of the count in struct tia_scene */
        int (*one)(const struct check *check);
    } parts[] = {
        {"texture", offsetof(struct tia_scene, texture_count), tia_check_texture},
        {"transform", offsetof(struct tia_scene, transform_count), tia_check_transform},
        {"mesh", offsetof(struct tia_scene, mesh_count), tia_check_mesh},
        {"grid", offsetof(struct tia_scene, grid_count), tia_check_grid},
        {"solid", offsetof(struct tia_scene, solid_count), tia_check_solid},
        {"shape", offsetof(struct tia_scene, shape_count), tia_check_shape},
        {"track", offsetof(struct tia_scene, track_count), tia_check_track},
    };
    const struct tia_scene *s = check->scene;
    int status = TIA_OK;

    check->thing = "scene";
    check->index = 0;
    REQUIRE(are_arrays(s), "arrays", "an array with a count must not be NULL");
    for (size_t i = 0; !status && i < sizeof parts / sizeof *parts; i++)
        status = tia_check_each(check, parts[i].thing,
                                *(const uint32_t *)(const void *)((const char *)s + parts[i].count), parts[i].one);
    status = status ? status : tia_check_each(check, "fall", s->falling ? s->falling->count : 0, tia_check_fall);
    check->thing = "shape";
    status = status ? status : tia_check_uses(check);
    return status ? status : tia_check_rendering(check);
}

static const struct check_more more = {find_eyes, tia_check_look, tia_check_falling, tia_check_textures_of,
                                       check_parts};

int tia_check_scene(const struct tia_scene *scene, struct tia_fault *fault, struct cancel *cancel)
{
    return tia_check_by(&more, scene, fault, cancel);
}

int tia_scene_check(const struct tia_scene *scene, struct tia_fault *fault)
{
    struct cancel never = {0};

    if (!scene)
        return TIA_ERR_ARGUMENT;
    int status = tia_check_scene(scene, fault, &never);
    if (!status && fault)
        tia_check_warn(scene, fault);
    return status;
}
