/* shadows.c - rules of the techniques for shadows, other than traced rays, see shadow.h. */
#include "scene_check.h"

#include "scene/colour.h"
#include "scene/facet_count.h"

/* True if shadows are soft: lights may then be of any kind, and an area light counts as one sample. */
static bool is_soft(const struct tia_scene *scene)
{
    return scene->shadows == TIA_SHADOWS_MAP && scene->shadow_map.filter == TIA_FILTER_PCSS;
}

static int check_light(const struct check *check, const struct tia_light *light, uint32_t *samples)
{
    bool soft = is_soft(check->scene);

    REQUIRE(soft || tia_light_has(light->kind, TIA_LIGHT_TECHNIQUES), "kind",
            "must be another kind with these shadows");
    if (!soft && tia_light_has(light->kind, TIA_LIGHT_AREA))
        *samples += light->samples ? light->samples : TIA_LIGHT_SAMPLES_DEFAULT;
    else if (!tia_light_has(light->kind, TIA_LIGHT_EVERYWHERE))
        *samples += 1;
    REQUIRE(*samples <= TIA_SHADOW_SAMPLES_MAX, "samples",
            "must be at most 64 of all lights and keys with these shadows");
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

static int check_materials(struct check *check)
{
    const struct tia_scene *scene = check->scene;

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
    REQUIRE(map->amount_bits <= (map->bias == TIA_BIAS_CONSTANT ? TIA_AMOUNT_BITS_MAX : 0), "shadow_map.amount_bits",
            "must be in 0..12 with a constant bias, otherwise 0");
    REQUIRE(map->filter == TIA_FILTER_DEFAULT || tia_filter_name((unsigned)map->filter), "shadow_map.filter",
            "must be a filter");
    return TIA_OK;
}

static int check_facets(const struct check *check)
{
    const struct tia_scene *scene = check->scene;
    uint64_t faces = 0;

    REQUIRE(scene->tessellated >= 0, "tessellated", "must be 0 or more");
    for (uint32_t i = 0; i < scene->sphere_count + scene->shape_count && faces <= TIA_OBJECTS_MAX; i++) {
        struct tia_facets facets;
        if (tia_facets_of(scene, i, &facets))
            faces += facets.faces;
    }
    REQUIRE(faces <= TIA_OBJECTS_MAX, "tessellated", "must be larger: there would be more than 2^24 faces");
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
    status = status ? status : check_facets(check);
    status = status ? status : check_materials(check);
    return status ? status : check_lights(check);
}
