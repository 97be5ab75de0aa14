#include "map_look.h"

#include "math/wide.h"

#define WIDEST 8 /* a search or filter reaches at most 1/WIDEST of a map's size to each side */
#define STEPS 4  /* number of taps to each side when texels are skipped */

unsigned tia_map_border(enum tia_filter filter)
{
    switch (filter) {
    case TIA_FILTER_NONE:
        return 1;
    case TIA_FILTER_7X7:
    case TIA_FILTER_POISSON:
        return 4;
    case TIA_FILTER_PCSS:
        return 8;
    default:
        return 3;
    }
}

unsigned tia_map_part(uint32_t lit, uint32_t taps)
{
    return (unsigned)((2 * lit * TIA_SHARE_ALL + taps) / (2 * taps));
}

/* Returns the share by four taps, row by row, with the point fu and fv of 256 parts from the first of them. */
static unsigned blend(const uint32_t lit[4], unsigned fu, unsigned fv)
{
    uint32_t above = lit[0] * (256 - fu) + lit[1] * fu, below = lit[2] * (256 - fu) + lit[3] * fu;

    return (unsigned)((above * (256 - fv) + below * fv + 1) / 2);
}

static unsigned bilinear(const struct tia_map_point *p)
{
    int64_t u = p->spot.u - 32768, v = p->spot.v - 32768, i = u >> 16, j = v >> 16;
    const uint32_t lit[4] = {tia_map_tap(p, i, j), tia_map_tap(p, i + 1, j), tia_map_tap(p, i, j + 1),
                             tia_map_tap(p, i + 1, j + 1)};

    return blend(lit, (unsigned)(u >> 8) & 255, (unsigned)(v >> 8) & 255);
}

/* Returns the number of texels at or above `least`, of side x side with the upper left corner at (i, j), all inside the
 * view. */
static inline unsigned count_lit(const struct tia_map *map, const struct tia_map_view *view, int64_t i, int64_t j,
                                 unsigned side, uint32_t least)
{
    const uint32_t *row = view->distance + (size_t)j * map->size + (size_t)i;
    unsigned lit = 0;

    for (unsigned y = 0; y < side; y++, row += map->size)
        for (unsigned x = 0; x < side; x++)
            lit += row[x] >= least;
    return lit;
}

/* True if side x side texels with the upper left corner at (i, j) are inside the map. */
static bool is_inside(const struct tia_map *map, int64_t i, int64_t j, unsigned side)
{
    int64_t last = (int64_t)map->size - side;

    return i >= 0 && j >= 0 && i <= last && j <= last;
}

static unsigned square(const struct tia_map_point *p, int half)
{
    unsigned lit = 0, side = 2 * (unsigned)half + 1;
    int64_t i = (p->spot.u >> 16) - half, j = (p->spot.v >> 16) - half;

    if (!p->of && is_inside(p->map, i, j, side))
        return tia_map_part(count_lit(p->map, p->spot.view, i, j, side, tia_map_least(p->map, p->limit)), side * side);
    for (int y = -half; y <= half; y++)
        for (int x = -half; x <= half; x++)
            lit += tia_map_tap(p, (p->spot.u >> 16) + x, (p->spot.v >> 16) + y);
    return tia_map_part(lit, side * side);
}

/* Gives tap i of 16 in a disc with a radius of 3 texels, rotated by a multiple of 45 degrees: Q.16 texels from the
 * point. Both tables are Q.6. */
static void poisson_tap(int i, unsigned turn, int64_t off[2])
{
    static const int16_t disc[16][2] = {{26, 31},    {-93, -3},  {-25, -94},  {88, -60},   {-63, 96},  {118, 44},
                                        {43, 150},   {185, -20}, {71, -172},  {-187, -21}, {-41, 184}, {-173, 76},
                                        {-64, -179}, {132, 139}, {157, -110}, {-141, -130}};
    static const int8_t turns[8][2] = {{64, 0},  {45, 45},   {0, 64},  {-45, 45},
                                       {-64, 0}, {-45, -45}, {0, -64}, {45, -45}};
    const int8_t *r = turns[turn % 8];
    int32_t x = disc[i][0], y = disc[i][1];

    off[0] = (x * r[0] - y * r[1]) * 16;
    off[1] = (x * r[1] + y * r[0]) * 16;
}

static unsigned poisson(const struct tia_map_point *p, unsigned turn)
{
    unsigned lit = 0;

    for (int i = 0; i < 16; i++) {
        int64_t off[2];
        poisson_tap(i, turn, off);
        lit += tia_map_tap(p, (p->spot.u + off[0]) >> 16, (p->spot.v + off[1]) >> 16);
    }
    return tia_map_part(lit, 16);
}

static int64_t smaller(int64_t a, int64_t b)
{
    return a < b ? a : b;
}

/* Returns the mean distance of the blockers: texels at most `reach` columns and rows away that shadow the point.
 * Returns -1 without blockers. */
static int64_t find_blocker(const struct tia_map_point *p, int64_t reach)
{
    int64_t step = reach > STEPS ? reach / STEPS : 1, sum = 0, count = 0;

    for (int64_t y = -reach; y <= reach; y += step)
        for (int64_t x = -reach; x <= reach; x += step)
            if (!tia_map_tap(p, (p->spot.u >> 16) + x, (p->spot.v >> 16) + y)) {
                sum += tia_map_read(p, (p->spot.u >> 16) + x, (p->spot.v >> 16) + y);
                count++;
            }
    return count ? sum / count : -1;
}

static unsigned disc(const struct tia_map_point *p, int64_t k)
{
    int64_t step = k > STEPS ? k / STEPS : 1;
    unsigned lit = 0, taps = 0;

    for (int64_t y = -k; y <= k; y += step)
        for (int64_t x = -k; x <= k; x += step)
            if (x * x + y * y <= k * (k + 1)) {
                lit += tia_map_tap(p, (p->spot.u >> 16) + x, (p->spot.v >> 16) + y);
                taps++;
            }
    return tia_map_part(lit, taps);
}

/* Returns the share by a filter as wide as the penumbra. Blockers are sought within R of the point, R being the light's
 * radius. With a blocker at the distance b, the penumbra at the point's distance w has the radius R (w - b)/b. */
static unsigned pcss(const struct tia_map_point *p, int64_t radius)
{
    int64_t widest = p->map->size / WIDEST, texels = wide_quotient(radius, p->spot.texel, 16); /* texels, Q.16 */

    if (!radius)
        return bilinear(p);
    int64_t blocker = find_blocker(p, smaller(widest, (texels >> 16) + 1));
    if (blocker < 0)
        return TIA_SHARE_ALL;
    int64_t beyond = p->spot.distance - blocker;
    int64_t spread = blocker && beyond > 0 ? wide_quotient(beyond, blocker, 16) : 0;
    int64_t k = wide_bits(wide_product(texels, spread)) > 60 ? widest : tia_round_shift(texels * spread, 32);
    return k < 1 ? bilinear(p) : disc(p, smaller(widest, k));
}

unsigned tia_map_share(const struct tia_map_point *point, enum tia_filter filter, int64_t radius, unsigned turn)
{
    switch (filter) {
    case TIA_FILTER_BILINEAR:
        return bilinear(point);
    case TIA_FILTER_3X3:
        return square(point, 1);
    case TIA_FILTER_5X5:
        return square(point, 2);
    case TIA_FILTER_7X7:
        return square(point, 3);
    case TIA_FILTER_POISSON:
        return poisson(point, turn);
    case TIA_FILTER_PCSS:
        return pcss(point, radius);
    default:
        return TIA_SHARE_ALL * tia_map_tap(point, point->spot.u >> 16, point->spot.v >> 16);
    }
}

/* ---- bounds ---- */

#define TAPS_ASIDE 8 /* more texels than any filter but PCSS reaches from a point */

/* True if all taps of a filter are outside a single view, where all is lit. */
static bool is_beyond(const struct tia_map *map, const struct tia_map_bounds *b)
{
    int64_t low = -((int64_t)TAPS_ASIDE << 16), high = (int64_t)(map->size + TAPS_ASIDE) << 16;

    return map->view_count == 1 && (b->u[1] < low || b->v[1] < low || b->u[0] > high || b->v[0] > high);
}

/* Gives a coordinate in units of 2^places; false if its bounds do not agree. */
static inline bool agree(const int64_t bounds[2], int64_t off, unsigned places, int64_t *at)
{
    *at = (bounds[0] + off) >> places;
    return *at == (bounds[1] + off) >> places;
}

static inline unsigned square_within(const struct tia_map *map, const struct tia_map_bounds *b, int half)
{
    unsigned side = 2 * (unsigned)half + 1;
    int64_t i, j;

    if (!agree(b->u, 0, 16, &i) || !agree(b->v, 0, 16, &j) || !is_inside(map, i - half, j - half, side))
        return TIA_SHARE_UNSURE;
    unsigned lit = count_lit(map, b->view, i - half, j - half, side, b->least[0]);
    if (b->least[1] != b->least[0] && count_lit(map, b->view, i - half, j - half, side, b->least[1]) != lit)
        return TIA_SHARE_UNSURE;
    return tia_map_part(lit, side * side);
}

static unsigned bilinear_within(const struct tia_map *map, const struct tia_map_bounds *b)
{
    unsigned share[2];
    int64_t u, v;

    if (!agree(b->u, -32768, 8, &u) || !agree(b->v, -32768, 8, &v) || !is_inside(map, u >> 8, v >> 8, 2))
        return TIA_SHARE_UNSURE;
    const uint32_t *at = b->view->distance + (size_t)(v >> 8) * map->size + (size_t)(u >> 8);
    for (int k = 0; k < 2; k++) {
        const uint32_t lit[4] = {at[0] >= b->least[k], at[1] >= b->least[k], at[map->size] >= b->least[k],
                                 at[map->size + 1] >= b->least[k]};
        share[k] = blend(lit, (unsigned)u & 255, (unsigned)v & 255);
    }
    return share[0] == share[1] ? share[0] : TIA_SHARE_UNSURE;
}

static unsigned poisson_within(const struct tia_map *map, const struct tia_map_bounds *b, unsigned turn)
{
    unsigned lit[2] = {0, 0};

    for (int n = 0; n < 16; n++) {
        int64_t off[2], i, j;
        poisson_tap(n, turn, off);
        if (!agree(b->u, off[0], 16, &i) || !agree(b->v, off[1], 16, &j) || !is_inside(map, i, j, 1))
            return TIA_SHARE_UNSURE;
        uint32_t there = b->view->distance[(size_t)j * map->size + (size_t)i];
        lit[0] += there >= b->least[0];
        lit[1] += there >= b->least[1];
    }
    return lit[0] == lit[1] ? tia_map_part(lit[0], 16) : TIA_SHARE_UNSURE;
}

unsigned tia_map_share_within(const struct tia_map *map, const struct tia_map_bounds *b, enum tia_filter filter,
                              unsigned turn)
{
    if (is_beyond(map, b) && filter != TIA_FILTER_PCSS)
        return TIA_SHARE_ALL;
    switch (filter) {
    case TIA_FILTER_NONE:
        return square_within(map, b, 0);
    case TIA_FILTER_BILINEAR:
        return bilinear_within(map, b);
    case TIA_FILTER_3X3:
        return square_within(map, b, 1);
    case TIA_FILTER_5X5:
        return square_within(map, b, 2);
    case TIA_FILTER_7X7:
        return square_within(map, b, 3);
    case TIA_FILTER_POISSON:
        return poisson_within(map, b, turn);
    default:
        return TIA_SHARE_UNSURE;
    }
}
