/* shadows.c - what techniques for shadows other than traced rays ask of a scene, see shadow.h. */
#include "check.h"

#include "scene/colour.h"

static bool is_flat(enum tia_shape_kind kind)
{
    return kind == TIA_PLANE || kind == TIA_BOX || kind == TIA_TRIANGLE || kind == TIA_MESH;
}

/* Area lights may be of any kind then, and have one sample. */
static bool is_soft(const struct tia_scene *scene)
{
    return scene->shadows == TIA_SHADOWS_MAP && scene->shadow_map.filter == TIA_FILTER_PCSS;
}

static int check_light(const struct check *check, const struct tia_light *light, uint32_t *samples)
{
    bool soft = is_soft(check->scene);

    REQUIRE(soft || (light->kind != TIA_DISC_LIGHT && light->kind != TIA_SPHERE_LIGHT), "kind",
            "must be no disc or sphere light with these shadows");
    if (light->kind == TIA_RECTANGLE_LIGHT && !soft)
        *samples += light->samples ? light->samples : TIA_LIGHT_SAMPLES;
    else if (light->kind != TIA_AMBIENT_LIGHT)
        *samples += 1;
    REQUIRE(*samples <= TIA_SHADOW_SAMPLES, "samples", "must be at most 64 of all lights and keys with these shadows");
    return TIA_OK;
}

static int check_lights(struct check *check)
{
    const struct tia_scene *scene = check->scene;
    uint32_t samples = 0;
    int status = TIA_OK;

    check->thing = "light";
    for (check->index = 0; !status && check->index < scene->light_count; check->index++)
        status = check_light(check, &scene->lights[check->index], &samples);
    if (status)
        return status;
    check->thing = "key";
    for (check->index = 0; !status && check->index < scene->binding_count; check->index++)
        status = check_light(check, &scene->bindings[check->index].state, &samples);
    return status;
}

static int check_shapes(struct check *check)
{
    const struct tia_scene *scene = check->scene;

    check->index = 0;
    check->thing = "sphere";
    REQUIRE(!scene->sphere_count, "shape", "must have flat faces with these shadows");
    check->thing = "shape";
    for (; check->index < scene->shape_count; check->index++)
        REQUIRE(is_flat(scene->shapes[check->index].kind), "kind",
                "must be a plane, a box, a triangle or a mesh with these shadows");
    check->thing = "material";
    for (check->index = 0; check->index < scene->material_count; check->index++) {
        REQUIRE(colour_is_black(&scene->materials[check->index].transmission), "transmission",
                "must be 0 with these shadows");
        REQUIRE(!scene->materials[check->index].opacity, "opacity", "must be 0 with these shadows");
    }
    return TIA_OK;
}

static int check_map(struct check *check)
{
    const struct tia_shadow_map *map = &check->scene->shadow_map;

    REQUIRE(!map->size ||
                (map->size >= TIA_MAP_SIZE_MIN && map->size <= TIA_MAP_SIZE_MAX && !(map->size & (map->size - 1))),
            "shadow_map.size", "must be 64, 128, 256, 512, 1024, 2048 or 4096");
    REQUIRE(map->bias == TIA_BIAS_DEFAULT || tia_bias_name((unsigned)map->bias), "shadow_map.bias", "must be a bias");
    REQUIRE(map->amount >= 0, "shadow_map.amount", "must be at least 0");
    REQUIRE(map->filter == TIA_FILTER_DEFAULT || tia_filter_name((unsigned)map->filter), "shadow_map.filter",
            "must be a filter");
    return TIA_OK;
}

int tia_check_shadows(struct check *check)
{
    const struct tia_scene *scene = check->scene;

    if (scene->shadows == TIA_SHADOWS_TRACED)
        return TIA_OK;
    check->index = 0;
    check->thing = "scene";
    REQUIRE(tia_shadows_name((unsigned)scene->shadows), "shadows", "must be a technique");
    int status = check_map(check);
    if (status)
        return status;
    check->thing = "camera";
    REQUIRE(scene->camera.samples <= 1, "samples", "must be 1 with these shadows");
    status = check_shapes(check);
    return status ? status : check_lights(check);
}
