/* The hierarchy of faces: each face that hides a light from a point is among the faces that a walk along the segment
 * from the point to the light returns, however far away the point is. Without the hierarchy, each face is tested on its
 * own. */
#include <math.h>

#include "raster/target.h"
#include "shadow/casters.h"
#include "shadow/occluder.h"
#include "shadow_worlds.h"

struct tally {
    unsigned asked, hidden, missed, far, infinite, offered;
};

static struct tia_raster_plane planes[FACES];

/* Makes a plane whose horizon goes through the centres of pixels: the points there are at infinity. */
static void make_sloping_plane(struct world *w, int32_t range, int32_t step)
{
    static const uint8_t halves[2][4] = {{0, 1, 2, 3}, {0, 3, 4, 1}};
    int64_t at[3];

    any_place(w, range, step, at);
    add_point(w, at[0], at[1], at[2], true);
    add_point(w, 1000, 1000, 0, false);
    add_point(w, 0, 0, 1000, false);
    add_point(w, -1000, -1000, 0, false);
    add_point(w, 0, 0, -1000, false);
    add_object(w, halves, 2, 5);
}

static bool is_in_leaf(const struct tia_casters *casters, const struct tia_bvh_node *leaf, uint32_t face)
{
    for (uint32_t i = 0; i < leaf->count; i++)
        if (casters->tree.items[leaf->index + i] == face)
            return true;
    return false;
}

/* Returns the set of faces in the leaves that the walk returns, one bit for each of at most 64 faces; all faces when
 * the point is too far away for a walk. */
static uint64_t offered(const struct world *w, const struct tia_casters *casters, const struct tia_seen *seen,
                        struct tally *t)
{
    struct tia_segment_walk walk;
    const struct tia_bvh_node *leaf;
    uint64_t found = 0;

    switch (tia_segment_init(&walk.segment, casters, seen, &w->flat, &w->light)) {
    case TIA_SEGMENT_MISSES:
        return 0;
    case TIA_SEGMENT_FAR:
        t->far++;
        return UINT64_MAX;
    case TIA_SEGMENT_INSIDE:
        break;
    }
    tia_segment_walk_start(&walk, casters);
    while ((leaf = tia_segment_walk_leaf(&walk)) != NULL)
        for (uint32_t f = 0; f < w->flat.face_count; f++)
            found |= (uint64_t)is_in_leaf(casters, leaf, f) << f;
    return found;
}

static bool is_unbounded(const struct tia_casters *casters, uint32_t face)
{
    for (uint32_t i = 0; i < casters->unbounded_count; i++)
        if (casters->unbounded[i] == face)
            return true;
    return false;
}

static void ask(const struct world *w, const struct tia_casters *casters, const struct tia_seen *seen, struct tally *t)
{
    uint64_t found = offered(w, casters, seen, t);
    struct tia_occluder o;

    t->infinite += seen->nearness == 0;
    for (uint32_t f = 0; f < w->flat.face_count; f++) {
        if (f == seen->of->face || is_unbounded(casters, f))
            continue;
        t->asked++;
        t->offered += (unsigned)(found >> f & 1);
        if (!tia_occluder_init(&o, &w->flat, &w->light, f) || !tia_occluder_hides(&o, seen))
            continue;
        t->hidden++;
        t->missed += !(found >> f & 1);
    }
}

/* Makes the light a direction from the visible point through the middle of a triangle, so that the segment of a distant
 * point crosses the whole scene. In perspective only, and for points not at infinity. */
static void aim_back(struct world *w, const struct tia_seen *seen)
{
    const struct tia_raster_grid *l = &w->flat.grid;
    const int64_t d[3] = {l->x + (int64_t)l->right * seen->x, l->y - (int64_t)l->down * seen->y, l->w};
    const struct tia_raster_vertex *v = &points[3 * below(30)];
    const int64_t sum[3] = {v[0].x + v[1].x + v[2].x, v[0].y + v[1].y + v[2].y, v[0].w + v[1].w + v[2].w};
    double way[3], most = 0;

    for (int k = 0; k < 3; k++) {
        way[k] = (double)sum[k] / 3 - (double)d[k] / ldexp((double)seen->nearness, seen->exponent);
        most = fabs(way[k]) > most ? fabs(way[k]) : most;
    }
    for (int k = 0; k < 3; k++)
        way[k] *= 0x1p30 / most;
    w->light = vertex(w, (int64_t)way[0], (int64_t)way[1], (int64_t)way[2], false);
}

/* Tests points at pixels on the planes of all faces, also outside the faces, where they are in front of the eye. */
static void ask_pixels(struct world *w, const struct tia_casters *casters, struct tally *t, struct tally *back)
{
    bool flat = w->flat.grid.projection == TIA_ORTHOGRAPHIC;

    for (uint32_t f = 0; f < w->flat.face_count; f++) {
        struct tia_seen_face of;
        if (!planes[f].det[0] && !planes[f].det[1])
            continue;
        tia_seen_face_init(&of, &w->flat, f);
        for (int i = 0; i < 40; i++) {
            struct tia_seen seen;
            int x = below(SIZE);
            tia_seen_init(&seen, &of, x, i % 4 ? below(SIZE) : SIZE - 1 - x);
            if (!flat && seen.nearness < 0)
                continue;
            ask(w, casters, &seen, t);
            if (flat || !seen.nearness)
                continue;
            const tia_flat_light light = w->light;
            aim_back(w, &seen);
            ask(w, casters, &seen, back);
            w->light = light;
        }
    }
}

static void check_worlds(enum tia_projection projection, int32_t range, int32_t step, struct tally *t)
{
    struct tally back = {0};

    for (int round = 0; round < 15; round++) {
        struct tia_casters casters;
        struct world w;
        begin(&w, projection);
        make_soup(&w, 30, range, step);
        make_plane(&w, range, step);
        make_sloping_plane(&w, range, step);
        end(&w, range, step);
        for (uint32_t f = 0; f < w.flat.face_count; f++) {
            struct tia_raster_vertex corners[TIA_SIDES];
            unsigned sides = tia_flat_corners(&w.flat, f, corners);
            CHECK(!tia_raster_plane_init(&planes[f], &w.flat.grid, corners, sides));
        }
        w.flat.planes = planes;
        void *memory = malloc(tia_casters_size(w.flat.face_count));
        CHECK(!tia_casters_build(&casters, memory, &w.flat, &never));
        CHECK_EQ(casters.unbounded_count, 4);
        ask_pixels(&w, &casters, t, &back);
        free(memory);
    }
    CHECK_MSG(t->missed == 0, "%u of %u that hide are not found", t->missed, t->hidden);
    CHECK_MSG(back.missed == 0, "%u of %u on the way back", back.missed, back.hidden);
    CHECK_MSG(t->hidden > t->asked / 100 && t->offered < t->asked * 3 / 4, "%u asked, %u hidden, %u found", t->asked,
              t->hidden, t->offered);
}

TEST(perspective)
{
    struct tally t = {0};

    check_worlds(TIA_PERSPECTIVE, 500, 1, &t);
    check_worlds(TIA_PERSPECTIVE, 500, 1 << 20, &t);
    check_worlds(TIA_PERSPECTIVE, 4, 96, &t);
    CHECK_MSG(t.infinite > 100, "%u at infinity", t.infinite);
}

TEST(orthographic)
{
    struct tally t = {0};

    check_worlds(TIA_ORTHOGRAPHIC, 500, 1, &t);
    check_worlds(TIA_ORTHOGRAPHIC, 500, 1 << 20, &t);
    check_worlds(TIA_ORTHOGRAPHIC, 4, 128, &t);
}

int main(void)
{
    RUN_LONG(perspective);
    RUN(orthographic);
    return check_status();
}
