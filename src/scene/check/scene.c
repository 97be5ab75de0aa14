/* scene.c - the whole check, in order: objects are checked before the indices that refer to them. */
#include "scene_check.h"

/* True if the arrays of scenes of spheres are there; more.c checks the others. */
static bool are_arrays(const struct tia_scene *s)
{
    return check_is_array(s->materials, s->material_count) && check_is_array(s->spheres, s->sphere_count) &&
           check_is_array(s->lights, s->light_count) && check_is_array(s->bindings, s->binding_count) &&
           check_is_array(s->textures, s->texture_count) && check_is_array(s->tracks, s->track_count);
}

/* True if the hierarchy, if any, has as many objects as the scene: a hierarchy of another scene would omit some. */
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
    return check->more ? check->more->falling(check) : TIA_OK;
}

static int check_light(const struct check *check)
{
    return tia_check_light(check, &check->scene->lights[check->index]);
}

static int check_key(const struct check *check)
{
    return tia_check_light(check, &check->scene->bindings[check->index].state);
}

int tia_check_each(struct check *check, const char *thing, uint32_t count, int (*one)(const struct check *check))
{
    int status = TIA_OK;

    check->thing = thing;
    for (check->index = 0; !status && check->index < count; check->index++)
        status = cancelled(check->cancel, 1) ? TIA_STOPPED : one(check);
    return status;
}

static int check_parts(struct check *check)
{
    const struct tia_scene *s = check->scene;
    int status = tia_check_each(check, "material", s->material_count, tia_check_material);

    status = status ? status : tia_check_each(check, "sphere", s->sphere_count, tia_check_sphere);
    status = status ? status : tia_check_each(check, "light", s->light_count, check_light);
    return status ? status : tia_check_each(check, "key", s->binding_count, check_key);
}

static int refuse_more(const struct check *check)
{
    const struct tia_scene *s = check->scene;
    uint32_t counts = s->shape_count | s->transform_count | s->texture_count | s->mesh_count | s->grid_count |
                      s->solid_count | s->track_count;

    REQUIRE(!counts && !s->falling && !s->shadows, "counts", "must have spheres alone, without techniques for shadows");
    return TIA_OK;
}

int tia_check_by(const struct check_more *more, const struct tia_scene *scene, struct tia_fault *fault,
                 struct cancel *cancel)
{
    struct check check = {.more = more, .scene = scene, .fault = fault, .thing = "scene", .cancel = cancel};
    int status;

    if (!scene->tracks && scene->track_count)
        return tia_check_refuse(&check, "arrays", "an array with a count must not be NULL");
    check.eyes = (struct tia_bounds){scene->camera.eye, scene->camera.eye};
    if (more)
        more->eyes(scene, &check.eyes);
    status = check_whole(&check);
    if (!status)
        status = check_parts(&check);
    return status ? status : more ? more->parts(&check) : refuse_more(&check);
}

int tia_check_spheres(const struct tia_scene *scene, struct tia_fault *fault, struct cancel *cancel)
{
    return tia_check_by(NULL, scene, fault, cancel);
}
