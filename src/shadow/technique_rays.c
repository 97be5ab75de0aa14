/* technique_rays.c - shadows by exact rays. */
#include "math/align.h"
#include "shadow_rays.h"

static uint64_t own_size(const struct tia_scene *scene)
{
    return ALIGN(sizeof(struct tia_casters)) + tia_casters_size(tia_flat_face_count(scene));
}

static int prepare(struct tia_shadow_view *view, struct cancel *cancel)
{
    struct tia_casters *casters = view->own;

    return tia_casters_build(casters, (char *)view->own + ALIGN(sizeof *casters), &view->flat, cancel);
}

static int set_lights(struct tia_shadow_view *view, struct cancel *cancel)
{
    (void)view;
    (void)cancel;
    return TIA_OK;
}

static void light(const struct tia_shadow_view *view, struct tia_shadow_tile *tile, unsigned sample,
                  struct cancel *cancel)
{
    tia_shadow_rays_light(view, view->own, tile, sample, cancel);
}

const struct tia_shadow_technique tia_shadow_rays = {
    .own_size = own_size, .prepare = prepare, .set_lights = set_lights, .light = light};
