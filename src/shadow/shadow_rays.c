#include "shadow_rays.h"

#include "kernels.h"
#include "raster/runs.h"
#include "raster/target.h"

static bool hides(struct tia_shadow_rays *rays, uint32_t face, const struct tia_seen *seen)
{
    struct tia_occluder *o = &rays->occluder[face % TIA_OCCLUDERS];

    if (o->face != face)
        (void)tia_occluder_init(o, rays->flat, rays->light, face);
    if (!tia_occluder_hides(o, seen))
        return false;
    rays->last = face;
    return true;
}

static bool any_hides(struct tia_shadow_rays *rays, const uint32_t *faces, uint32_t count, const struct tia_seen *seen)
{
    for (uint32_t i = 0; i < count && !cancelled(rays->cancel, 1); i++)
        if (hides(rays, faces ? faces[i] : i, seen))
            return true;
    return false;
}

static bool is_hidden(struct tia_shadow_rays *rays, const struct tia_seen *seen)
{
    const struct tia_casters *casters = rays->casters;
    const struct tia_bvh_node *leaf;
    struct tia_segment_walk walk;

    if (rays->last != TIA_NO_FACE && hides(rays, rays->last, seen))
        return true;
    if (any_hides(rays, casters->unbounded, casters->unbounded_count, seen))
        return true;
    switch (tia_segment_init(&walk.segment, casters, seen, rays->flat, rays->light)) {
    case TIA_SEGMENT_MISSES:
        return false;
    case TIA_SEGMENT_FAR:
        return any_hides(rays, NULL, rays->flat->face_count, seen);
    case TIA_SEGMENT_INSIDE:
        break;
    }
    tia_segment_walk_start(&walk, casters);
    while ((leaf = tia_segment_walk_leaf(&walk)) != NULL)
        if (any_hides(rays, casters->tree.items + leaf->index, leaf->count, seen))
            return true;
    return false;
}

/* Sets the face of the next pixels. */
static void show_face(struct tia_shadow_rays *rays, uint32_t face)
{
    if (rays->of.face == face)
        return;
    tia_seen_face_init(&rays->of, rays->flat, face);
    rays->turned = tia_flat_is_turned(rays->flat, face, rays->light);
}

void tia_shadow_rays_pixel(struct tia_shadow_rays *rays, int x, int y)
{
    size_t at = target_index(&rays->tile->target, x, y);
    uint32_t face = rays->tile->target.face[at];
    struct tia_seen seen;

    if (face == TIA_NO_FACE)
        return;
    show_face(rays, face);
    if (!rays->turned)
        return;
    tia_seen_init(&seen, &rays->of, x, y);
    if (!is_hidden(rays, &seen))
        rays->tile->lit[at] |= UINT64_C(1) << rays->sample;
}

bool tia_shadow_rays_hides(struct tia_shadow_rays *rays, uint32_t face, int x, int y)
{
    struct tia_seen seen;

    show_face(rays, rays->tile->target.face[target_index(&rays->tile->target, x, y)]);
    tia_seen_init(&seen, &rays->of, x, y);
    return hides(rays, face, &seen);
}

void tia_shadow_rays_light(const struct tia_shadow_view *view, const struct tia_casters *casters,
                           struct tia_shadow_tile *tile, unsigned sample, struct cancel *cancel)
{
    const struct tia_raster_target *t = &tile->target;
    struct tia_shadow_rays rays = {.flat = &view->flat,
                                   .casters = casters,
                                   .light = &view->samples[sample],
                                   .tile = tile,
                                   .sample = sample,
                                   .cancel = cancel,
                                   .last = TIA_NO_FACE};

    rays.of.face = TIA_NO_FACE;
    for (int i = 0; i < TIA_OCCLUDERS; i++)
        rays.occluder[i].face = TIA_NO_FACE;
    if (t->runs && t->runs->shadows && t->runs->shadows->rays(&rays))
        return;
    for (int y = (int)t->area.y; y < target_bottom(t); y++)
        for (int x = (int)t->area.x; x < target_right(t) && !cancelled(cancel, 1); x++)
            tia_shadow_rays_pixel(&rays, x, y);
}
