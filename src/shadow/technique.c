#include "technique.h"

const struct tia_shadow_technique *tia_shadow_technique(enum tia_shadows technique)
{
    switch (technique) {
    case TIA_SHADOWS_RAYS:
        return &tia_shadow_rays;
    case TIA_SHADOWS_ZPASS:
    case TIA_SHADOWS_ZFAIL:
        return &tia_shadow_volumes;
    default:
        return NULL;
    }
}
