#include "technique.h"

const struct tia_shadow_technique *tia_shadow_technique(enum tia_shadows technique)
{
    switch (technique) {
    case TIA_SHADOWS_RAYS:
        return &tia_shadow_rays;
    case TIA_SHADOWS_ZPASS:
    case TIA_SHADOWS_ZFAIL:
    case TIA_SHADOWS_ZPASS_PLAIN:
        return &tia_shadow_volumes;
    case TIA_SHADOWS_MAP:
        return &tia_shadow_maps;
    case TIA_SHADOWS_MAP_EXACT:
        return &tia_shadow_exact_maps;
    default:
        return NULL;
    }
}

unsigned tia_shadow_samples(const struct tia_scene *scene, const struct tia_light *light)
{
    const struct tia_shadow_technique *technique = tia_shadow_technique(scene->shadows);

    if (technique->is_whole && technique->is_whole(scene))
        return !tia_light_has(light->kind, TIA_LIGHT_EVERYWHERE);
    return tia_flat_light_samples(light);
}
