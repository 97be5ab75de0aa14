/* shares_tmpl.h - the shares of light that reach a tile's pixels, found with a shadow map. Plain C finds those that
 * bounds leave undecided.
 *
 * Parameters: the doubles of isa/isa.h. Defines: light_tile(). */
#ifndef TIA_SIMD_SHADOW_SHARES_TMPL_H
#define TIA_SIMD_SHADOW_SHARES_TMPL_H

#include "spots_tmpl.h"

#define PACKETS 4 /* packets that are prepared at once: their loads and divisions overlap */
#define BLOCK 64  /* a tile is lit in blocks of this size, in which the faces of a row return in the next */

/* ---- faces ---- */

static void set_slope(const struct spot_map *s, struct lit_face *face)
{
    vd slope[2];

    find_slope(s, face->normal, v3_set(face->normal), vset(0), slope);
    face->slope[0] = lane_of(slope[0], 0);
    face->slope[1] = lane_of(slope[1], 0);
}

static const struct lit_face *face_of(struct spot_map *s, uint32_t face)
{
    const struct tia_flat_scene *flat = &s->l->view->flat;
    const tia_flat_light *light = &s->l->view->samples[s->l->sample];
    struct lit_face *own = &s->face[face % LIT_FACES];
    struct sure_seen_face seen = {.object = 0};

    if (own->face == face)
        return own;
    own->face = face;
    own->turned = tia_flat_is_turned(flat, face, light);
    if (!own->turned)
        return own;
    tia_sure_set_plane(&seen, &flat->planes[face], &flat->grid);
    own->known = seen.object != TIA_NO_OBJECT;
    tia_map_face(&s->l->point, light, face);
    s->l->turned = true;
    set_three(own->normal, s->l->point.normal, P2M(62));
    for (int i = 0; i < 3; i++)
        own->inverse[i] = seen.inverse[i];
    set_slope(s, own);
    return own;
}

/* ---- pixels ---- */

/* Bounds of LANES points; `sure`: these hold. In the `square` lanes, all texels of a square filter are known: `first`
 * is the index of the first. */
struct spot_bounds {
    double u[2][LANES], v[2][LANES];
    int64_t least[2][LANES], view[LANES], first[LANES];
    unsigned sure, square;
};

LANE_OP void put_whole(int64_t to[LANES], vd a)
{
    vi words = whole_words(a);

    __builtin_memcpy(to, &words, sizeof words);
}

/* Returns the first texel of a lane's square. */
LANE_OP const uint32_t *square_at_lane(const struct spot_map *s, const struct spot_bounds *b, int k)
{
    return s->texels[b->view[k]] + b->first[k];
}

/* Finds the squares of texels around the points. */
LANE_OP void find_squares(const struct spot_map *s, const struct spot *spot, struct spot_bounds *b)
{
    vd i = vfloor(spot->u - spot->eu), j = vfloor(spot->v - spot->ev), half = vset(s->side / 2);
    vm one = mand(vle(vfloor(spot->u + spot->eu), i), vle(vfloor(spot->v + spot->ev), j));
    vd last = vset((double)s->map->size) - (s->side > 3 ? 8 : 4);

    i -= half;
    j -= half;
    one = mand(one, mand(vle(vset(0), vmin(i, j)), vle(vmax(i, j), last)));
    put_whole(b->first, j * (double)s->map->size + i);
    b->square = s->side ? b->sure & mbits(one) : 0;
}

static void find_bounds(const struct spot_map *s, const struct lit_face *face, int x, int y, struct spot_bounds *b)
{
    vd column = lane_numbers() + (double)x, row = vset(y), e, least[2];
    struct sight z = sight_of(s->orthographic, v3_set(face->inverse), column, row);
    struct v3 d = points_at(s, &z, column, row, &e);
    struct spot spot = find_limits(s, face, d, e, least);

    vstore(b->u[0], spot.u - spot.eu);
    vstore(b->u[1], spot.u + spot.eu);
    vstore(b->v[0], spot.v - spot.ev);
    vstore(b->v[1], spot.v + spot.ev);
    put_whole(b->least[0], least[0]);
    put_whole(b->least[1], least[1]);
    put_whole(b->view, spot.number);
    vm seen = mand(z.fine, mand(vlt(vset(0), z.z), vlt(z.z + z.e, vset(65536))));
    vm narrow = mand(vlt(spot.eu, vset(1)), vlt(spot.ev, vset(1)));
    b->sure = mbits(mand(mand(seen, narrow), spot.sure));
    find_squares(s, &spot, b);
}

/* Returns the number of texels at or above `least`, of side x side from `at` on, of which 4 or 8 columns are there. */
LANE_OP unsigned count_square(const uint32_t *at, unsigned size, unsigned side, uint32_t least)
{
    typedef uint32_t four __attribute__((vector_size(16)));
    typedef uint32_t eight __attribute__((vector_size(32)));
    unsigned lit = 0;

    if (side == 3) {
        four rows[3];
        __builtin_memcpy(&rows[0], at, sizeof rows[0]);
        __builtin_memcpy(&rows[1], at + size, sizeof rows[1]);
        __builtin_memcpy(&rows[2], at + 2 * (size_t)size, sizeof rows[2]);
        four sum = (four)(rows[0] >= least) + (four)(rows[1] >= least) + (four)(rows[2] >= least);
        return 0 - (sum[0] + sum[1] + sum[2]);
    }
    if (side == 1)
        return *at >= least;
    eight sum = {0}, row;
    for (unsigned y = 0; y < side; y++, at += size) {
        __builtin_memcpy(&row, at, sizeof row);
        sum -= (eight)(row >= least);
    }
    for (unsigned x = 0; x < side; x++)
        lit += sum[x];
    return lit;
}

/* Returns the share of a point whose texels are known. */
LANE_OP unsigned square_share(const struct spot_map *s, const struct spot_bounds *b, int k, unsigned side)
{
    const uint32_t *at = square_at_lane(s, b, k);
    uint32_t least = (uint32_t)b->least[0][k], most = (uint32_t)b->least[1][k];
#ifdef WORDS_GE
    if (side == 3) {
        unsigned bits = WORDS_GE(at, least, most) | WORDS_GE(at + s->map->size, least, most) << 8 |
                        WORDS_GE(at + 2 * (size_t)s->map->size, least, most) << 16;
        int some = __builtin_popcount(bits & 0x070707), all = __builtin_popcount(bits & 0x707070);
        return some == all ? s->shares[some] : TIA_SHARE_UNSURE;
    }
#endif
    unsigned lit = count_square(at, s->map->size, side, least);

    return least == most || count_square(at, s->map->size, side, most) == lit ? s->shares[lit] : TIA_SHARE_UNSURE;
}

static int64_t floor_of(double a)
{
    int64_t whole = (int64_t)a;

    return whole - (a < (double)whole);
}

static unsigned share_at(const struct spot_map *s, const struct spot_bounds *b, int k, unsigned turn)
{
    struct tia_map_bounds bounds = {.view = &s->map->view[b->view[k]]};

    for (int i = 0; i < 2; i++) {
        bounds.u[i] = floor_of(b->u[i][k] * 65536);
        bounds.v[i] = floor_of(b->v[i][k] * 65536);
        bounds.least[i] = (uint32_t)b->least[i][k];
    }
    return tia_map_share_within(s->map, &bounds, s->l->look->filter, turn);
}

/* Finds the shares of the first `count` lanes, TIA_SHARE_UNSURE where they are undecided. Returns true if none is. */
LANE_OP bool find_shares(const struct spot_map *s, const struct spot_bounds *b, int count, unsigned side,
                         unsigned share[LANES])
{
    bool sure = true;

    for (int k = 0; k < count; k++) {
        share[k] = b->square >> k & 1 ? square_share(s, b, k, side) : TIA_SHARE_UNSURE;
        sure = sure && share[k] != TIA_SHARE_UNSURE;
    }
    return sure;
}

/* Finds the shares of lanes without a square. */
static __attribute__((noinline)) void find_others(const struct spot_map *s, const struct spot_bounds *b, int x, int y,
                                                  int count, unsigned share[LANES])
{
    for (int k = 0; k < count; k++)
        if ((b->sure & ~b->square) >> k & 1)
            share[k] = share_at(s, b, k, (unsigned)(x + k + 3 * y));
}

/* Lights the first `count` of LANES pixels from (x, y) on. */
LANE_OP void light_lanes(const struct spot_map *s, const struct spot_bounds *b, int x, int y, int count)
{
    struct tia_map_lighting *l = s->l;
    size_t at = target_index(&l->tile->target, x, y), shares = l->shares;
    uint64_t *lit = l->tile->lit + at;
    tia_share *to = shares ? (tia_share *)l->tile->more + at * shares + l->sample : NULL;
    unsigned share[LANES];

    if (!(s->side == 3 ? find_shares(s, b, count, 3, share) : find_shares(s, b, count, s->side, share)))
        find_others(s, b, x, y, count, share);
    for (int k = 0; k < count; k++) {
        if (share[k] == TIA_SHARE_UNSURE) {
            tia_map_light_pixel(l, x + k, y);
            continue;
        }
        lit[k] |= (uint64_t)(share[k] > 0) << l->sample;
        if (to)
            to[(size_t)k * shares] = (tia_share)share[k];
    }
}

/* Lights pixels x0..x1-1 of row y, which show one face. */
static void light_run(struct spot_map *s, const struct lit_face *face, int y, int x0, int x1)
{
    struct spot_bounds packet[PACKETS];

    for (int x = x0; x < x1 && !face->known; x++)
        tia_map_light_pixel(s->l, x, y);
    for (int x = x0; x < x1 && face->known; x += PACKETS * LANES) {
        int count = least_int(PACKETS, (x1 - x + LANES - 1) / LANES);
        for (int i = 0; i < count; i++)
            find_bounds(s, face, x + i * LANES, y, &packet[i]);
        for (int i = 0; i < count; i++)
            light_lanes(s, &packet[i], x + i * LANES, y, least_int(LANES, x1 - x - i * LANES));
    }
}

static void light_block(struct spot_map *s, int x0, int y0, int x1, int y1)
{
    const struct tia_raster_target *t = &s->l->tile->target;

    for (int y = y0; y < y1; y++)
        for (int x = x0, count = 0; x < x1 && !cancelled(s->l->cancel, TIA_MAP_PIXEL_WORK * (unsigned)count);
             x += count) {
            const uint32_t *face = &t->face[target_index(t, x, y)];
            count = same_faces(face, x1 - x);
            if (*face == TIA_NO_FACE)
                continue;
            const struct lit_face *own = face_of(s, *face);
            if (own->turned)
                light_run(s, own, y, x, x + count);
        }
}

static void light_tile(struct tia_map_lighting *l)
{
    const struct tia_raster_target *t = &l->tile->target;
    struct spot_map s;

    open_map(&s, l);
    for (int y = t->area.y; y < target_bottom(t); y += BLOCK)
        for (int x = t->area.x; x < target_right(t) && !l->cancel->stopped; x += BLOCK)
            light_block(&s, x, y, least_int(x + BLOCK, target_right(t)), least_int(y + BLOCK, target_bottom(t)));
}

#endif
