/* volume_ends.c - counts of the volumes that contain the ends of rays from the eye. */
#include "volume.h"

struct end_count {
    const struct tia_flat_scene *flat;
    const tia_flat_light *light;
    int end; /* end of the rays: -1 is the eye; 1 is the opposite point, where all rays of an orthographic view end */
    uint32_t count;
    bool unsure;
};

/* Returns the side of an edge on which the line from the eye to the light passes: the sign of det(a, b, light, eye). If
 * all four are at infinity, the determinant is 0, and the edge belongs to a half plane. Then any result is correct that
 * is the same for both half planes. */
static int passes(const struct end_count *e, const struct tia_raster_vertex *a, const struct tia_raster_vertex *b)
{
    const int64_t p[3] = {a->x, a->y, a->w}, q[3] = {b->x, b->y, b->w};
    const int64_t l[3] = {e->light->x, e->light->y, e->light->w};

    return p[2] || q[2] || l[2] || e->flat->eye.projection != TIA_ORTHOGRAPHIC ? tia_flat_orientation(p, q, l) : 1;
}

/* Counts a volume if it contains the end: then the segment from the end to the light crosses the cap, that is, passes
 * all edges on the same side. If the segment meets edges and passes the others on the same side, or if the end is in
 * the cap's plane, the end is on the volume's surface. */
static int count_end(void *ctx, const struct tia_volume_caster *c, uint32_t face)
{
    struct end_count *e = ctx;
    int side = e->end * tia_flat_side_of_eye(e->flat, c->face) * (c->turned ? -1 : 1);
    bool left = false, right = false, met = side == 0;

    (void)face;
    for (unsigned k = 0; k < c->sides; k++) {
        int pass = passes(e, tia_face_corner(e->flat, c->face, k),
                          tia_face_corner(e->flat, c->face, k + 1 < c->sides ? k + 1 : 0));
        left = left || pass > 0;
        right = right || pass < 0;
        met = met || pass == 0;
    }
    if ((left && right) || side < 0)
        return TIA_OK;
    e->unsure = e->unsure || met;
    e->count++;
    return TIA_OK;
}

bool tia_shadow_count_eye(const struct tia_flat_scene *flat, struct tia_shadow_light light, uint32_t *count,
                          struct cancel *cancel)
{
    struct end_count e = {.flat = flat, .light = light.at, .end = -1};

    (void)tia_volume_casters(flat, light, false, count_end, &e, cancel);
    *count = e.count;
    return !e.unsure;
}

bool tia_shadow_count_far(const struct tia_flat_scene *flat, struct tia_shadow_light light, uint32_t *count,
                          struct cancel *cancel)
{
    struct end_count e = {.flat = flat, .light = light.at, .end = 1};

    if (flat->eye.projection == TIA_ORTHOGRAPHIC)
        (void)tia_volume_casters(flat, light, false, count_end, &e, cancel);
    *count = e.count;
    return !e.unsure;
}
