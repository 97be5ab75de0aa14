/* technique_volumes.c - shadows by shadow volumes, counted at each pixel. */
#include "math/align.h"
#include "shadow_rays.h"

/* Ways to count a sample's volumes: behind the visible point, or in front of it. If both are undecided, NOT: rays
 * decide. */
enum counts { BEHIND, BEFORE, NOT };

struct counted {
    enum counts where;
    uint32_t start; /* initial value of the count; light arrives where the final count is 0 */
};

struct volumes {
    struct counted sample[TIA_SHADOW_SAMPLES_MAX];
    struct tia_casters casters; /* faces for rays, built when first needed */
    bool has_casters;
};

static uint64_t own_size(const struct tia_scene *scene)
{
    return ALIGN(sizeof(struct volumes)) + tia_casters_size(tia_flat_face_count(scene));
}

static int prepare(struct tia_shadow_view *view, struct cancel *cancel)
{
    struct volumes *volumes = view->own;

    (void)cancel;
    volumes->has_casters = false;
    return TIA_OK;
}

static struct counted count_ends(const struct tia_shadow_view *view, unsigned sample, struct cancel *cancel)
{
    const tia_flat_light *light = &view->samples[sample];
    uint32_t eye, far;

    if (view->scene->shadows == TIA_SHADOWS_ZPASS_PLAIN)
        return (struct counted){BEFORE, 0};
    bool knows_eye = tia_shadow_count_eye(&view->flat, light, &eye, cancel);
    bool knows_far = tia_shadow_count_far(&view->flat, light, &far, cancel);

    if (knows_eye && (view->scene->shadows == TIA_SHADOWS_ZPASS || !knows_far))
        return (struct counted){BEFORE, eye};
    return (struct counted){knows_far ? BEHIND : NOT, far};
}

static int set_lights(struct tia_shadow_view *view, struct cancel *cancel)
{
    struct volumes *volumes = view->own;

    for (unsigned i = 0; i < view->sample_count && !cancelled(cancel, 1); i++) {
        volumes->sample[i] = count_ends(view, i, cancel);
        if (volumes->sample[i].where != NOT || volumes->has_casters)
            continue;
        void *memory = (char *)view->own + ALIGN(sizeof *volumes);
        volumes->has_casters = !tia_casters_build(&volumes->casters, memory, &view->flat, cancel);
    }
    return cancel->stopped ? TIA_STOPPED : TIA_OK;
}

/* Sets the sample's bit in the lit pixels: their points are in no volume, and their faces are turned to the light. */
static void keep_lit(const struct tia_shadow_view *view, struct tia_shadow_tile *tile, unsigned sample)
{
    const struct tia_tile *area = &tile->target.area;
    const tia_flat_light *light = &view->samples[sample];
    uint32_t last = TIA_NO_FACE;
    bool turned = false;

    for (unsigned y = 0; y < area->height; y++)
        for (unsigned x = 0; x < area->width; x++) {
            size_t at = (size_t)y * (size_t)tile->target.pitch + x;
            uint32_t face = tile->target.face[at];
            if (face == TIA_NO_FACE || tile->target.count[at])
                continue;
            if (face != last)
                turned = tia_flat_is_turned(&view->flat, face, light);
            last = face;
            tile->lit[at] |= (uint64_t)turned << sample;
        }
}

static void light(const struct tia_shadow_view *view, struct tia_shadow_tile *tile, unsigned sample,
                  struct cancel *cancel)
{
    const struct volumes *volumes = view->own;
    const struct counted *counted = &volumes->sample[sample];

    if (counted->where == NOT) {
        tia_shadow_rays_light(view, &volumes->casters, tile, sample, cancel);
        return;
    }
    tia_raster_clear_count(&tile->target, counted->start);
    if (counted->where == BEFORE)
        (void)tia_shadow_zpass(&tile->target, &view->flat, &view->samples[sample], cancel);
    else
        (void)tia_shadow_zfail(&tile->target, &view->flat, &view->samples[sample], cancel);
    keep_lit(view, tile, sample);
}

const struct tia_shadow_technique tia_shadow_volumes = {
    .own_size = own_size, .prepare = prepare, .set_lights = set_lights, .light = light};
