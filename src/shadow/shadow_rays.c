#include "shadow_rays.h"

#include "raster/target.h"

#define OCCLUDERS 16

/* Data shared between neighbouring pixels, which mostly have the same occluder. */
struct rays {
    const struct tia_flat_scene *flat;
    const struct tia_casters *casters;
    const tia_flat_light *light;
    struct cancel *cancel;
    struct tia_seen_face of;
    bool turned;
    uint32_t last;                           /* last face that hid the light */
    struct tia_occluder occluder[OCCLUDERS]; /* a cache: face f has its occluder at f mod OCCLUDERS */
};

static bool hides(struct rays *rays, uint32_t face, const struct tia_seen *seen)
{
    struct tia_occluder *o = &rays->occluder[face % OCCLUDERS];

    if (o->face != face)
        (void)tia_occluder_init(o, rays->flat, rays->light, face);
    if (!tia_occluder_hides(o, seen))
        return false;
    rays->last = face;
    return true;
}

static bool any_hides(struct rays *rays, const uint32_t *faces, uint32_t count, const struct tia_seen *seen)
{
    for (uint32_t i = 0; i < count && !cancelled(rays->cancel, 1); i++)
        if (hides(rays, faces ? faces[i] : i, seen))
            return true;
    return false;
}

static bool is_hidden(struct rays *rays, const struct tia_seen *seen)
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

static bool is_lit(struct rays *rays, uint32_t face, int x, int y)
{
    struct tia_seen seen;

    if (rays->of.face != face) {
        tia_seen_face_init(&rays->of, rays->flat, face);
        rays->turned = tia_flat_is_turned(rays->flat, face, rays->light);
    }
    if (!rays->turned)
        return false;
    tia_seen_init(&seen, &rays->of, x, y);
    return !is_hidden(rays, &seen);
}

void tia_shadow_rays_light(const struct tia_shadow_view *view, const struct tia_casters *casters,
                           struct tia_shadow_tile *tile, unsigned sample, struct cancel *cancel)
{
    const struct tia_raster_target *t = &tile->target;
    struct rays rays = {.flat = &view->flat,
                        .casters = casters,
                        .light = &view->samples[sample],
                        .cancel = cancel,
                        .last = TIA_NO_FACE};

    rays.of.face = TIA_NO_FACE;
    for (int i = 0; i < OCCLUDERS; i++)
        rays.occluder[i].face = TIA_NO_FACE;
    for (int y = (int)t->area.y; y < target_bottom(t); y++)
        for (int x = (int)t->area.x; x < target_right(t) && !cancelled(cancel, 1); x++) {
            size_t at = target_index(t, x, y);
            uint32_t face = t->face[at];
            if (face != TIA_NO_FACE && is_lit(&rays, face, x, y))
                tile->lit[at] |= UINT64_C(1) << sample;
        }
}
