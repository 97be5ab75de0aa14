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

static unsigned part(uint32_t lit, uint32_t taps)
{
    return (unsigned)((2 * lit * TIA_SHARE_ALL + taps) / (2 * taps));
}

static unsigned bilinear(const struct tia_map_point *p)
{
    int64_t u = p->spot.u - 32768, v = p->spot.v - 32768, i = u >> 16, j = v >> 16;
    unsigned fu = (unsigned)(u >> 8) & 255, fv = (unsigned)(v >> 8) & 255;
    uint32_t above = tia_map_tap(p, i, j) * (256 - fu) + tia_map_tap(p, i + 1, j) * fu;
    uint32_t below = tia_map_tap(p, i, j + 1) * (256 - fu) + tia_map_tap(p, i + 1, j + 1) * fu;

    return (unsigned)((above * (256 - fv) + below * fv + 1) / 2);
}

static unsigned square(const struct tia_map_point *p, int half)
{
    unsigned lit = 0, side = 2 * (unsigned)half + 1;

    for (int y = -half; y <= half; y++)
        for (int x = -half; x <= half; x++)
            lit += tia_map_tap(p, (p->spot.u >> 16) + x, (p->spot.v >> 16) + y);
    return part(lit, side * side);
}

/* Returns the share by 16 taps in a disc with a radius of 3 texels, rotated by a multiple of 45 degrees. Both tables
 * are Q.6. */
static unsigned poisson(const struct tia_map_point *p, unsigned turn)
{
    static const int16_t disc[16][2] = {{26, 31},    {-93, -3},  {-25, -94},  {88, -60},   {-63, 96},  {118, 44},
                                        {43, 150},   {185, -20}, {71, -172},  {-187, -21}, {-41, 184}, {-173, 76},
                                        {-64, -179}, {132, 139}, {157, -110}, {-141, -130}};
    static const int8_t turns[8][2] = {{64, 0},  {45, 45},   {0, 64},  {-45, 45},
                                       {-64, 0}, {-45, -45}, {0, -64}, {45, -45}};
    const int8_t *r = turns[turn % 8];
    unsigned lit = 0;

    for (int i = 0; i < 16; i++) {
        int32_t x = disc[i][0], y = disc[i][1];
        int64_t u = p->spot.u + (x * r[0] - y * r[1]) * 16;
        int64_t v = p->spot.v + (x * r[1] + y * r[0]) * 16;
        lit += tia_map_tap(p, u >> 16, v >> 16);
    }
    return part(lit, 16);
}

static int64_t least(int64_t a, int64_t b)
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
    return part(lit, taps);
}

/* Returns the share by a filter as wide as the penumbra. Blockers are sought within R of the point, R being the light's
 * radius. With a blocker at the distance b, the penumbra at the point's distance w has the radius R (w - b)/b. */
static unsigned pcss(const struct tia_map_point *p, int64_t radius)
{
    int64_t widest = p->map->size / WIDEST, texels = wide_quotient(radius, p->spot.texel, 16); /* texels, Q.16 */

    if (!radius)
        return bilinear(p);
    int64_t blocker = find_blocker(p, least(widest, (texels >> 16) + 1));
    if (blocker < 0)
        return TIA_SHARE_ALL;
    int64_t beyond = p->spot.distance - blocker;
    int64_t spread = blocker && beyond > 0 ? wide_quotient(beyond, blocker, 16) : 0;
    int64_t k = wide_bits(wide_product(texels, spread)) > 60 ? widest : tia_round_shift(texels * spread, 32);
    return k < 1 ? bilinear(p) : disc(p, least(widest, k));
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
