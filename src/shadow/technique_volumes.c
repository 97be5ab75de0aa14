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
    uint64_t kept;  /* number of samples for which faces have roles: as many as the scene's own lights have */
    uint8_t *roles; /* of all faces for each of these samples */
};

/* Returns the number of samples of the scene's own lights. */
static unsigned samples_of(const struct tia_scene *scene)
{
    unsigned count = 0;

    for (uint32_t i = 0; i < scene->light_count && count < TIA_SHADOW_SAMPLES_MAX; i++)
        count += tia_flat_light_samples(&scene->lights[i]);
    return count < TIA_SHADOW_SAMPLES_MAX ? count : TIA_SHADOW_SAMPLES_MAX;
}

/* Returns the number of bytes before the roles. */
static uint64_t size_before(uint64_t faces)
{
    return ALIGN(sizeof(struct volumes)) + ALIGN(tia_casters_size(faces));
}

static uint64_t own_size(const struct tia_scene *scene)
{
    uint64_t faces = tia_flat_face_count(scene);

    return size_before(faces) + samples_of(scene) * faces;
}

static int prepare(struct tia_shadow_view *view, struct cancel *cancel)
{
    struct volumes *volumes = view->own;
    uint32_t faces = view->flat.face_count;

    (void)cancel;
    volumes->has_casters = false;
    volumes->kept = faces ? (view->own_size - size_before(faces)) / faces : 0;
    volumes->roles = (uint8_t *)view->own + size_before(faces);
    return TIA_OK;
}

/* Returns the place of the roles for a sample, or NULL. */
static uint8_t *roles_of(const struct tia_shadow_view *view, unsigned sample)
{
    const struct volumes *volumes = view->own;

    return sample < volumes->kept ? volumes->roles + sample * (size_t)view->flat.face_count : NULL;
}

static struct tia_shadow_light light_of(const struct tia_shadow_view *view, unsigned sample)
{
    return (struct tia_shadow_light){&view->samples[sample], roles_of(view, sample)};
}

static struct counted count_ends(const struct tia_shadow_view *view, unsigned sample, struct cancel *cancel)
{
    struct tia_shadow_light light = light_of(view, sample);
    bool before = view->scene->shadows == TIA_SHADOWS_ZPASS;
    uint32_t eye, far;

    if (view->scene->shadows == TIA_SHADOWS_ZPASS_PLAIN)
        return (struct counted){BEFORE, 0};
    for (int i = 0; i < 2; i++, before = !before) {
        if (before && tia_shadow_count_eye(&view->flat, light, &eye, cancel))
            return (struct counted){BEFORE, eye};
        if (!before && tia_shadow_count_far(&view->flat, light, &far, cancel))
            return (struct counted){BEHIND, far};
    }
    return (struct counted){NOT, 0};
}

static int set_lights(struct tia_shadow_view *view, struct cancel *cancel)
{
    struct volumes *volumes = view->own;

    for (unsigned i = 0; i < view->sample_count && !cancelled(cancel, 1); i++) {
        if (roles_of(view, i))
            (void)tia_shadow_keep_roles(roles_of(view, i), &view->flat, &view->samples[i], cancel);
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
    struct tia_shadow_light light = light_of(view, sample);
    uint32_t last = TIA_NO_FACE;
    bool turned = false;

    for (unsigned y = 0; y < area->height; y++)
        for (unsigned x = 0; x < area->width; x++) {
            size_t at = (size_t)y * (size_t)tile->target.pitch + x;
            uint32_t face = tile->target.face[at];
            if (face == TIA_NO_FACE || tile->target.count[at])
                continue;
            if (face != last)
                turned = tia_flat_is_visible(&view->flat, face, tia_shadow_side(&view->flat, face, light));
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
        (void)tia_shadow_zpass(&tile->target, &view->flat, light_of(view, sample), cancel);
    else
        (void)tia_shadow_zfail(&tile->target, &view->flat, light_of(view, sample), cancel);
    keep_lit(view, tile, sample);
}

const struct tia_shadow_technique tia_shadow_volumes = {
    .own_size = own_size, .prepare = prepare, .set_lights = set_lights, .light = light};
