/* raster_random.h - random polygons and states, and a target to compare with the oracle's. */
#ifndef TESTS_RASTER_RANDOM_H
#define TESTS_RASTER_RANDOM_H

#include <stdlib.h>
#include <tia/raster.h>

#include "check.h"
#include "oracle/raster.h"
#include "random.h"

struct random_polygon {
    struct tia_raster_vertex v[TIA_RASTER_CORNERS];
    unsigned count;
};

static inline int64_t random_below(uint64_t n)
{
    return (int64_t)(random_bits() % n);
}

/* Returns a random number in -most..most. */
static inline int64_t random_size(int64_t most)
{
    return random_below(2 * (uint64_t)most + 1) - most;
}

/* Returns a coordinate: any number; or, with `grid`, one of a few, so that corners, edges and planes coincide. */
static inline int64_t random_coordinate(bool grid, int64_t most)
{
    return grid ? random_size(4) * (most / 4) : random_size(most);
}

static inline struct tia_raster_vertex random_vertex(bool grid, int64_t most, bool flat)
{
    struct tia_raster_vertex v;

    v.x = random_coordinate(grid, most);
    v.y = random_coordinate(grid, most);
    v.w = flat ? most : random_below(4) ? llabs(random_coordinate(grid, most)) : random_coordinate(grid, most);
    v.h = flat ? random_coordinate(grid, most) : 1;
    return v;
}

/* Returns a point at the centre of a pixel of the area, or a little outside the area. Often it is slightly off the
 * centre, or in the same row as other points. */
static inline struct tia_raster_vertex random_centre(const struct tia_raster_grid *l, struct tia_tile area,
                                                     int64_t most)
{
    int64_t i = area.x + random_size(area.width), j = area.y + random_size(random_below(2) ? area.height : 1);
    struct tia_raster_vertex v = {l->x + i * l->right, l->y - j * l->down, l->w, 1};
    int64_t size = llabs(v.x) > llabs(v.y) ? llabs(v.x) : llabs(v.y), off = random_below(2);
    int64_t times = (most - 1) / (size > v.w ? size : v.w);

    if (times < 1)
        return random_vertex(true, most, false);
    times = 1 + random_below((uint64_t)times);
    return (struct tia_raster_vertex){v.x * times + random_size(off), v.y * times + random_size(off),
                                      v.w * times + random_size(off), 1};
}

/* Returns a - b, a direction. */
static inline struct tia_raster_vertex difference(struct tia_raster_vertex a, struct tia_raster_vertex b)
{
    return (struct tia_raster_vertex){a.x - b.x, a.y - b.y, a.w - b.w, a.h - b.h};
}

/* Makes the side of a shadow volume: corners a and b, and the directions from a point l to each. */
static inline void random_quad(struct random_polygon *p, bool grid, int64_t most, bool flat)
{
    struct tia_raster_vertex l = random_vertex(grid, most, flat);

    p->count = 4;
    p->v[0] = random_vertex(grid, most, flat);
    p->v[1] = random_vertex(grid, most, flat);
    p->v[2] = difference(p->v[1], l);
    p->v[3] = difference(p->v[0], l);
}

/* Makes a convex polygon of 3..8 corners in the plane through three points. */
static inline void random_flat_polygon(struct random_polygon *p, bool grid, int64_t most, bool flat)
{
    static const int8_t octagon[8][2] = {{2, 1}, {1, 2}, {-1, 2}, {-2, 1}, {-2, -1}, {-1, -2}, {1, -2}, {2, -1}};
    struct tia_raster_vertex o = random_vertex(grid, most / 5, flat), u = random_vertex(grid, most / 5, flat);
    struct tia_raster_vertex v = random_vertex(grid, most / 5, flat);
    unsigned left_out = random_u32();

    p->count = 0;
    u = difference(u, o);
    v = difference(v, o);
    for (unsigned i = 0; i < 8; i++) {
        if (left_out >> i & 1 && p->count + 8 - i > 3)
            continue;
        int64_t a = octagon[i][0], b = octagon[i][1];
        p->v[p->count++] = (struct tia_raster_vertex){o.x + a * u.x / 2 + b * v.x / 2, o.y + a * u.y / 2 + b * v.y / 2,
                                                      o.w + a * u.w / 2 + b * v.w / 2, o.h + a * u.h / 2 + b * v.h / 2};
    }
}

/* Makes a random polygon that is exactly planar. Coordinates of points are up to `most`, a multiple of 40. p->count
 * must be 0 before the first call. */
static inline void random_polygon(struct random_polygon *p, const struct tia_raster_grid *l, struct tia_tile area,
                                  int64_t most)
{
    bool grid = random_bits() & 1, flat = l->projection == TIA_ORTHOGRAPHIC;

    switch (random_below(5)) {
    case 0:
        random_quad(p, grid, most, flat);
        break;
    case 1:
        random_flat_polygon(p, true, most, flat);
        break;
    case 2: /* often shares an edge with the previous triangle */
        for (unsigned i = p->count == 3 && random_below(2) ? 2 : 0; i < 3; i++)
            p->v[i] = flat ? random_vertex(grid, most, flat) : random_centre(l, area, most);
        p->count = 3;
        break;
    default:
        p->count = 3;
        for (int i = 0; i < 3; i++) {
            p->v[i] = random_vertex(grid, most, flat);
            if (!flat && random_below(12) == 0)
                p->v[i].h = 0;
        }
    }
}

static inline struct tia_stencil random_stencil(void)
{
    struct tia_stencil s = {(enum tia_compare)random_below(8), (uint8_t)random_below(256), 255, 255, 0, 0, 0};

    if (random_below(2))
        s.test = TIA_COMPARE_ALWAYS;
    if (random_below(2))
        s.mask = (uint8_t)random_bits();
    if (random_below(2))
        s.write = (uint8_t)random_bits();
    s.fail = (enum tia_stencil_op)random_below(8);
    s.zfail = (enum tia_stencil_op)random_below(8);
    s.zpass = (enum tia_stencil_op)random_below(8);
    if (random_below(3) == 0) { /* operations as for shadow volumes */
        s.zfail = TIA_STENCIL_KEEP;
        s.zpass = random_below(2) ? TIA_STENCIL_INCR_WRAP : TIA_STENCIL_DECR_WRAP;
    } else if (random_below(2) == 0) {
        s.zfail = random_below(2) ? TIA_STENCIL_INCR_WRAP : TIA_STENCIL_DECR_WRAP;
        s.zpass = TIA_STENCIL_KEEP;
    }
    return s;
}

static inline struct tia_raster_state random_state_of_all(void)
{
    struct tia_raster_state s = {.depth = (enum tia_compare)random_below(8), .depth_write = random_below(2)};

    if (random_below(2))
        s.depth = TIA_COMPARE_LESS;
    s.ties_by_face = random_below(2);
    s.skip_front = random_below(8) == 0;
    s.skip_back = random_below(8) == 0;
    s.front = random_stencil();
    s.back = random_stencil();
    bool coloured = random_below(2);
    for (int c = 0; c < 3; c++) {
        s.colour_write[c] = coloured && random_below(2);
        s.colour[c] = (uint16_t)random_bits();
    }
    return s;
}

static inline void *allocated(size_t size)
{
    void *p = calloc(1, size);

    if (!p)
        abort();
    return p;
}

/* Returns a target. *memory receives its memory, to be freed by the caller. */
static inline struct tia_raster_target target_of(const struct tia_raster_grid *grid, struct tia_tile area,
                                                 unsigned buffers, uint32_t faces, void **memory)
{
    size_t size = tia_raster_size(area, buffers, faces);
    struct tia_raster_target target = {0};

    *memory = allocated(size);
    CHECK_EQ(tia_raster_init(&target, *memory, size, grid, area, buffers, faces), TIA_OK);
    return target;
}

#endif
