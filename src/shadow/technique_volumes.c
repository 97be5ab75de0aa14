/* technique_volumes.c - each light's shadows are shadow volumes, counted in the stencil buffer. */
#include "technique.h"

/* How the volumes of a sample are counted. */
struct volumes {
    bool pass;    /* before what is seen, not behind it */
    uint8_t none; /* what the stencil buffer has where light arrives */
};

static uint64_t own_size(const struct tia_scene *scene)
{
    (void)scene;
    return TIA_SHADOW_SAMPLES * sizeof(struct volumes);
}

static int prepare(struct tia_shadow_view *view, struct asker *asker)
{
    (void)view;
    (void)asker;
    return TIA_OK;
}

static int set_lights(struct tia_shadow_view *view, struct asker *asker)
{
    struct volumes *volumes = view->own;

    for (unsigned i = 0; i < view->sample_count && !asker_stops(asker, view->flat.face_count); i++) {
        uint32_t eye, far;
        bool knows_eye = tia_shadow_count_eye(&view->flat, &view->samples[i], &eye);
        bool knows_far = tia_shadow_count_far(&view->flat, &view->samples[i], &far);

        volumes[i].pass = view->scene->shadows == TIA_SHADOWS_ZPASS ? knows_eye || !knows_far : !knows_far && knows_eye;
        volumes[i].none = (uint8_t)(0 - (volumes[i].pass ? eye : far));
    }
    return asker->stopped ? TIA_STOPPED : TIA_OK;
}

/* A face is dark where it is turned away from the light, and where volumes hold it. */
static void keep_lit(const struct tia_shadow_view *view, struct tia_shadow_tile *tile, unsigned sample, uint8_t none)
{
    const struct tia_tile *area = &tile->target.area;
    const tia_flat_light *light = &view->samples[sample];
    uint32_t last = TIA_NO_FACE;
    bool turned = false;

    for (unsigned y = 0; y < area->height; y++)
        for (unsigned x = 0; x < area->width; x++) {
            size_t at = (size_t)y * (size_t)tile->target.pitch + x;
            uint32_t face = tile->target.face[at];
            if (face == TIA_NO_FACE || tile->target.stencil[at] != none)
                continue;
            if (face != last)
                turned = tia_flat_is_turned(&view->flat, face, light);
            last = face;
            tile->lit[at] |= (uint64_t)turned << sample;
        }
}

static void light(const struct tia_shadow_view *view, struct tia_shadow_tile *tile, unsigned sample,
                  struct asker *asker)
{
    const struct volumes *volumes = (const struct volumes *)view->own + sample;

    (void)asker;

    tia_clear_stencil(&tile->target, 0, 255);
    if (volumes->pass)
        (void)tia_shadow_zpass(&tile->target, &view->flat, &view->samples[sample]);
    else
        (void)tia_shadow_zfail(&tile->target, &view->flat, &view->samples[sample]);
    keep_lit(view, tile, sample, volumes->none);
}

const struct tia_shadow_technique tia_shadow_volumes = {own_size, prepare, set_lights, light};
