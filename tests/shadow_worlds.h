/* shadow_worlds.h - random scenes of few faces, small enough for shadow_oracle.h. */
#ifndef TESTS_SHADOW_WORLDS_H
#define TESTS_SHADOW_WORLDS_H

#include <stdlib.h>

#include "check.h"
#include "random.h"
#include "shadow_oracle.h"

static struct cancel never;

#define FACES 64
#define POINTS (3 * FACES)

static int32_t below(int32_t n)
{
    return (int32_t)(random_bits() % (uint64_t)n);
}

static struct tia_flat_face faces[FACES];
static struct tia_flat_object objects[FACES];
static struct tia_raster_vertex points[POINTS];
static uint32_t across[TIA_SIDES * FACES];
static struct tia_flat_rows rows[FACES];

/* Returns a point or a direction. In orthographic views, w and h have swapped their roles. */
static struct tia_raster_vertex vertex(const struct world *w, int64_t x, int64_t y, int64_t z, bool point)
{
    if (w->flat.eye.projection == TIA_ORTHOGRAPHIC)
        return (struct tia_raster_vertex){x, y, point ? INT64_C(1) << w->flat.grid.fraction : 0, z};
    return (struct tia_raster_vertex){x, y, z, point};
}

static void begin(struct world *w, enum tia_projection projection)
{
    *w = (struct world){.flat = {.objects = objects, .faces = faces, .across = across, .points = points, .rows = rows}};
    w->flat.eye.projection = projection;
    CHECK(!tia_raster_grid_init(&w->flat.grid, projection, SIZE, SIZE, 1, 0, projection == TIA_ORTHOGRAPHIC ? 20 : 5));
}

/* Chooses a position whose coordinates are multiples of `step`, up to `range` steps in each direction. Its depth can be
 * slightly behind the eye. */
static void any_place(const struct world *w, int32_t range, int32_t step, int64_t at[3])
{
    for (int k = 0; k < 3; k++)
        at[k] = (int64_t)(below(2 * range + 1) - (k == 2 ? range / 3 : range)) * step;
    if (w->flat.eye.projection == TIA_ORTHOGRAPHIC)
        at[2] = -at[2];
}

static void add_point(struct world *w, int64_t x, int64_t y, int64_t z, bool point)
{
    points[w->flat.point_count++] = vertex(w, x, y, z, point);
}

/* Adds an object of `count` faces. Its points are the last `point_count` points of the scene. */
static void add_object(struct world *w, const uint8_t (*corners)[4], uint32_t count, uint32_t point_count)
{
    struct tia_flat_scene *f = &w->flat;
    struct tia_flat_object *o = &objects[f->object_count++];
    uint32_t first = f->point_count - point_count;

    *o = (struct tia_flat_object){.first_face = f->face_count, .face_count = count};
    for (uint32_t i = 0; i < count; i++)
        for (int k = 0; k < TIA_SIDES; k++)
            faces[f->face_count + i].corner[k] =
                k == 3 && !corners[i][3] ? TIA_NO_CORNER : first + corners[i][k]; /* a fourth corner of 0 means that
                                                                                     there is none */
    f->face_count += count;
    for (int k = 0; k < 3; k++) {
        o->low[k] = INT64_MAX;
        o->high[k] = INT64_MIN;
    }
    for (uint32_t i = first; i < f->point_count; i++) {
        int64_t p[3];
        tia_flat_affine(f, &points[i], p);
        for (int k = 0; k < 3; k++) {
            o->low[k] = p[k] < o->low[k] ? p[k] : o->low[k];
            o->high[k] = p[k] > o->high[k] ? p[k] : o->high[k];
        }
    }
}

static void end(struct world *w, int32_t range, int32_t step)
{
    void *room = malloc(tia_edges_room(w->flat.face_count));
    int64_t at[3];

    (void)tia_edges_join(across, faces, w->flat.face_count, room, &never);
    free(room);
    for (uint32_t f = 0; f < w->flat.face_count; f++)
        rows[f] = (struct tia_flat_rows){0, SIZE};
    for (uint32_t i = 0; i < w->flat.object_count; i++) {
        struct tia_flat_object *o = &objects[i];
        o->closed = true;
        for (uint32_t e = TIA_SIDES * o->first_face; e < TIA_SIDES * (o->first_face + o->face_count); e++)
            o->closed = o->closed && (e % TIA_SIDES == 3 || across[e] != TIA_NO_EDGE);
    }
    any_place(w, range, step, at);
    bool point = below(4) != 0;
    w->light = vertex(w, at[0], at[1], at[2] + (!point && !at[0] && !at[1] && !at[2]), point);
}

static void make_soup(struct world *w, uint32_t count, int32_t range, int32_t step)
{
    static const uint8_t triangle[1][4] = {{0, 1, 2}};

    for (uint32_t i = 0; i < count; i++) {
        for (int k = 0; k < 3; k++) {
            int64_t at[3];
            any_place(w, range, step, at);
            add_point(w, at[0], at[1], at[2], true);
        }
        add_object(w, triangle, 1, 3);
    }
}

/* Adds boxes whose corners are displaced by up to `jitter`. */
static void make_solids(struct world *w, uint32_t count, int32_t range, int32_t step, int32_t jitter)
{
    static const uint8_t box[12][4] = {{0, 6, 4}, {0, 2, 6}, {1, 5, 7}, {1, 7, 3}, {0, 5, 1}, {0, 4, 5},
                                       {2, 7, 6}, {2, 3, 7}, {0, 1, 3}, {0, 3, 2}, {4, 7, 5}, {4, 6, 7}};

    for (uint32_t i = 0; i < count; i++) {
        int64_t low[3], size[3];
        any_place(w, range, step, low);
        any_place(w, range, step, size);
        for (int k = 0; k < 8; k++) {
            int64_t at[3];
            for (int c = 0; c < 3; c++)
                at[c] = low[c] + (k >> c & 1 ? llabs(size[c]) + step : 0) + below(jitter + 1);
            add_point(w, at[0], at[1], at[2], true);
        }
        add_object(w, box, 12, 8);
    }
}

/* Makes one object of the last `count` objects. */
static void join_objects(struct world *w, uint32_t count)
{
    struct tia_flat_object *o = &objects[w->flat.object_count -= count - 1] - 1;

    for (uint32_t i = 1; i < count; i++) {
        o->face_count += o[i].face_count;
        for (int k = 0; k < 3; k++) {
            o->low[k] = o[i].low[k] < o->low[k] ? o[i].low[k] : o->low[k];
            o->high[k] = o[i].high[k] > o->high[k] ? o[i].high[k] : o->high[k];
        }
    }
}

/* Adds an infinite plane through a random point, in two halves. */
static void make_plane(struct world *w, int32_t range, int32_t step)
{
    static const uint8_t halves[2][4] = {{0, 1, 2, 3}, {0, 3, 4, 1}};
    int64_t at[3], a[3], b[3];

    any_place(w, range, step, at);
    any_place(w, range, step, a);
    any_place(w, range, step, b);
    add_point(w, at[0], at[1], at[2], true);
    add_point(w, a[0], a[1], a[2], false);
    add_point(w, b[0], b[1], b[2], false);
    add_point(w, -a[0], -a[1], -a[2], false);
    add_point(w, -b[0], -b[1], -b[2], false);
    add_object(w, halves, 2, 5);
    objects[w->flat.object_count - 1].kind = TIA_PLANE;
}

/* JOINED: an object of several solids. SMALL: a few solids, a plane and a light, at a distance that is large for their
 * size. */
enum contents { SOUP, SOLIDS, JOINED, CROOKED, MIXED, SMALL };

static inline void make(struct world *w, enum contents contents, int32_t range, int32_t step)
{
    if (contents == SOUP || contents == MIXED)
        make_soup(w, 1 + (uint32_t)below(contents == MIXED ? 5 : 13), range, step);
    if (contents == SMALL)
        make_solids(w, 2 + (uint32_t)below(3), range / 25, step, 0);
    else if (contents != SOUP)
        make_solids(w, 2 + (uint32_t)below(3), range * 2 / 3, step, contents == CROOKED ? range / 5 : 0);
    if (contents == JOINED)
        join_objects(w, w->flat.object_count);
    if (contents == MIXED || contents == SMALL)
        make_plane(w, range, step);
}

#endif
