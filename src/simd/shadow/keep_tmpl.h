/* keep_tmpl.h - the distances at a shadow map's texels.
 *
 * Parameters: the doubles of isa/isa.h. Defines: keep_band(). */
#ifndef TIA_SIMD_SHADOW_KEEP_TMPL_H
#define TIA_SIMD_SHADOW_KEEP_TMPL_H

#include "bounds/maps.h"
#include "raster/target.h"
#include "shadow/map.h"
#include "simd/rays/vector_tmpl.h"

#define NEAREST 6755399441055744.0 /* 1.5 2^52: a double above has no fraction bits */
#define WHOLE_BITS 52              /* bits of integers that are converted by their place in a double */
#define QUOTIENT_BITS 32           /* bits of f that plain C divides by */
#define KEPT_FACES 64
#define FARTHEST 4294967296.0 /* distances from here on are TIA_MAP_FAR */

static double magnitude(double a)
{
    return a < 0 ? -a : a;
}

static int least_int(int a, int b)
{
    return a < b ? a : b;
}

LANE_OP vd lane_numbers(void)
{
    static const double numbers[8] = {0, 1, 2, 3, 4, 5, 6, 7};

    return vload(numbers);
}

/* Returns integers in 0..2^52 as doubles. */
LANE_OP vd whole_doubles(vi a)
{
    const double base = 0x1p52;
    int64_t bits;

    __builtin_memcpy(&bits, &base, sizeof bits);
    return as_doubles(a + bits) - vset(base);
}

/* Returns 2^exponent; false if that is far from 1. */
static bool two_to(int exponent, double *power)
{
    uint64_t bits = (uint64_t)(1023 + exponent) << 52;

    __builtin_memcpy(power, &bits, sizeof bits);
    return exponent > -500 && exponent < 500;
}

/* A plane along a run of texels. With parallel rays the distance at the first texel is v, and `step` is its step.
 * Otherwise it is v over f, which has at most 52 bits above `cut`; where f < cuts it is rounded down, as plain C's
 * quotient then has no fraction bits, and where 2 f < cuts to an even number, as this has only its upper 31 bits. */
struct kept_run {
    double v, step, cuts;
    int64_t f, df;
    int cut;
};

static int bit_count(int64_t a)
{
    return a ? 64 - __builtin_clzll((unsigned long long)a) : 0;
}

/* Prepares a run of `count` texels from f on. False: plain C must compute the distances. */
static bool start_run(struct kept_run *r, const struct tia_map *map, const struct tia_map_plane *plane, int64_t f,
                      int count)
{
    int64_t end = f + (count - 1) * plane->x, low = f < end ? f : end, high = f < end ? end : f;

    if (map->parallel) {
        double scale;
        if (high >= 0 || plane->places < 1 || plane->places > 126 || !two_to(-plane->places, &scale))
            return false;
        scale *= -(double)plane->factor;
        r->v = scale * (double)f;
        r->step = scale * (double)plane->x;
        return scale * (double)low < FARTHEST;
    }
    int bits = bit_count(high);
    r->cut = bits > WHOLE_BITS ? bits - WHOLE_BITS : 0;
    r->f = f;
    r->df = plane->x;
    bool known = low > 0 && (!r->cut || bit_count(low) - r->cut >= QUOTIENT_BITS);
    if (!known || !two_to(-plane->places - r->cut, &r->v))
        return false;
    r->cuts = r->v * 0x1p31;
    r->v *= (double)plane->factor;
    return true;
}

/* Distances at LANES texels: v is rounded to a multiple of `step`, to nearest or down. */
struct distances {
    vd v, step;
    vm down;
};

/* Returns the distances at LANES texels from f on. Plain C divides by the upper 32 bits of f; its quotient, in
 * 2^30..2^32, has places + bits(f) - 31 fraction bits. Where that is -2 or less, v is at least FARTHEST. */
LANE_OP struct distances central_distances(const struct kept_run *r, vi f)
{
    vi whole = as_integers(whole_doubles(f >> r->cut));
    vd upper = as_doubles(whole & ~((INT64_C(1) << (WHOLE_BITS - QUOTIENT_BITS + 1)) - 1));
    vd step = vsel(vlt(2 * upper, vset(r->cuts)), vset(2), vset(1));

    return (struct distances){vset(r->v) / upper, step, vlt(upper, vset(r->cuts))};
}

LANE_OP void put_words(uint32_t *to, vi a)
{
#if LANES == 1
    *to = (uint32_t)a;
#else
    typedef uint32_t words __attribute__((vector_size(4 * LANES)));
    words low = __builtin_convertvector(a, words);

    __builtin_memcpy(to, &low, sizeof low);
#endif
}

/* Stores distances. Returns the lanes that are undecided. */
LANE_OP unsigned put_distances(uint32_t *to, const struct distances *d)
{
    vd parts = vmin(d->v, vset(FARTHEST)) * vsel(vlt(d->step, vset(2)), vset(1), vset(.5));
    vd given = parts - vsel(d->down, vset(.5), vset(0)), whole = (given + vset(NEAREST)) - vset(NEAREST);
    vm sure = mor(vle(vset(FARTHEST), d->v), vlt(vabs(given - whole), vset(.5 - BOUND(MAP_DISTANCE))));

    put_words(to, whole_words(vmin(whole * d->step, vset(TIA_MAP_FAR))));
    return mbits(mnot(sure));
}

static void keep_plain(const struct tia_map *map, const struct tia_map_plane *plane, int i, int j, int count,
                       uint32_t *to)
{
    for (int k = 0; k < count; k++)
        to[k] = tia_map_distance(map, plane, i + k, j);
}

static void keep_same(uint32_t *to, uint32_t distance, int count)
{
    const vi both = (vi){0} + (int64_t)((uint64_t)distance << 32 | distance);

    for (; count >= 2 * LANES; count -= 2 * LANES, to += 2 * LANES)
        __builtin_memcpy(to, &both, sizeof both);
    while (count-- > 0)
        *to++ = distance;
}

/* Stores the distances of a plane at texels (i, j), (i + 1, j) ..., which `to` has LANES more of. Floors and walls
 * often have one distance along the rows of a view. If it is a whole number, doubles cannot decide how it is rounded
 * down. */
static void keep_run(const struct tia_map *map, const struct tia_map_plane *plane, int i, int j, int count,
                     uint32_t *to)
{
    int64_t lane[LANES];
    struct kept_run r = {.step = 0};
    vi f, step = {0};
    vm none = vlt(vset(0), vset(0));

    if (!plane->x) {
        keep_same(to, tia_map_distance(map, plane, i, j), count);
        return;
    }
    if (!start_run(&r, map, plane, plane->c + plane->x * i + plane->y * j, count)) {
        keep_plain(map, plane, i, j, count, to);
        return;
    }
    for (int k = 0; k < LANES; k++)
        lane[k] = r.f + k * r.df;
    __builtin_memcpy(&f, lane, sizeof f);
    step += LANES * r.df;
    for (int k = 0; k < count; k += LANES, f += step) {
        uint32_t some[LANES];
        struct distances d = {vset(r.v) + (lane_numbers() + (double)k) * r.step, vset(1), none};
        unsigned live = count - k < LANES ? (1u << (count - k)) - 1 : (1u << LANES) - 1;
        uint32_t *at = count - k < LANES ? some : to + k;
        if (!map->parallel)
            d = central_distances(&r, f);
        unsigned open = put_distances(at, &d) & live;
        for (int n = 0; n < count - k && at == some; n++)
            to[k + n] = some[n];
        for (; open; open &= open - 1)
            keep_plain(map, plane, i + k + __builtin_ctz(open), j, 1, to + k + __builtin_ctz(open));
    }
}

struct kept_face {
    uint32_t face;
    struct tia_map_plane plane;
};

/* Returns the number of texels from the first on that have its face, at most `most`. */
static int same_faces(const uint32_t *face, int most)
{
    uint64_t two = (uint64_t)face[0] << 32 | face[0], next[4];
    int count = 1;

    for (; count + 8 <= most; count += 8) {
        __builtin_memcpy(next, face + count, sizeof next);
        if (((next[0] ^ two) | (next[1] ^ two) | (next[2] ^ two) | (next[3] ^ two)) != 0)
            break;
    }
    while (count < most && face[count] == face[0])
        count++;
    return count;
}

static void keep_row(const struct tia_map *map, const struct tia_map_view *view, const struct tia_raster_target *t,
                     int y, struct kept_face kept[KEPT_FACES])
{
    int width = t->area.width;
    const uint32_t *face = t->face + (size_t)(y - t->area.y) * (size_t)width;
    uint32_t *to = view->distance + (size_t)y * map->size + t->area.x;

    for (int x = 0, count; x < width; x += count) {
        count = same_faces(face + x, width - x);
        if (face[x] == TIA_NO_FACE) {
            __builtin_memset(to + x, 255, (size_t)count * sizeof *to);
            continue;
        }
        struct kept_face *own = &kept[face[x] % KEPT_FACES];
        if (own->face != face[x])
            tia_map_plane_init(&own->plane, map, view, &t->planes[face[x]]);
        own->face = face[x];
        keep_run(map, &own->plane, t->area.x + x, y, count, to + x);
    }
}

/* Stores the distances of the faces in a band of a view. */
static void keep_band(const struct tia_map *map, const struct tia_map_view *view, const struct tia_raster_target *t,
                      struct cancel *cancel)
{
    struct kept_face kept[KEPT_FACES];

    for (int i = 0; i < KEPT_FACES; i++)
        kept[i].face = TIA_NO_FACE;
    for (int y = t->area.y; y < target_bottom(t) && !cancelled(cancel, t->area.width); y++)
        keep_row(map, view, t, y, kept);
}

#endif
