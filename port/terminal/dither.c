#include "dither.h"

#include <stdlib.h>

#define PALETTE 256
#define CANDIDATES 16 /* colours of the palette that mixtures are made of: the nearest ones */
#define LEVELS 64     /* mixtures have n/64 of the second colour */
#define CURVE_BITS 12 /* the curve of CIE Lab is tabulated at multiples of 2^-12 */
#define CURVE (1 << CURVE_BITS)

/* A linear colour, 16 bits a channel. */
struct linear {
    int32_t c[3];
};

/* A colour of CIE Lab but for constants, in units of 1/64. */
struct lab {
    int32_t l, a, b;
};

/* A mixture: `parts` of 64 are `second`. */
struct mixture {
    uint8_t first, second, parts, known;
};

struct dither {
    int64_t weight, hue;   /* see contrast() */
    unsigned first, count; /* indices of the palette's colours */
    struct linear linear[PALETTE];
    struct lab lab[PALETTE];
    uint16_t curve[CURVE + 2]; /* in units of 2^-15 */
    struct mixture mixtures[65536];
};

/* sRGB's transfer function (IEC 61966-2-1) of i/255: 65535 (i/255)/12.92 up to 0.04045, then 65535
 * ((i/255 + 0.055)/1.055)^2.4, rounded. */
static const uint16_t linear_of[256] = {
    0,     20,    40,    60,    80,    99,    119,   139,   159,   179,   199,   219,   241,   264,   288,   313,
    340,   367,   396,   427,   458,   491,   526,   562,   599,   637,   677,   718,   761,   805,   851,   898,
    947,   997,   1048,  1101,  1156,  1212,  1270,  1330,  1391,  1453,  1517,  1583,  1651,  1720,  1790,  1863,
    1937,  2013,  2090,  2170,  2250,  2333,  2418,  2504,  2592,  2681,  2773,  2866,  2961,  3058,  3157,  3258,
    3360,  3464,  3570,  3678,  3788,  3900,  4014,  4129,  4247,  4366,  4488,  4611,  4736,  4864,  4993,  5124,
    5257,  5392,  5530,  5669,  5810,  5953,  6099,  6246,  6395,  6547,  6700,  6856,  7014,  7174,  7335,  7500,
    7666,  7834,  8004,  8177,  8352,  8528,  8708,  8889,  9072,  9258,  9445,  9635,  9828,  10022, 10219, 10417,
    10619, 10822, 11028, 11235, 11446, 11658, 11873, 12090, 12309, 12530, 12754, 12980, 13209, 13440, 13673, 13909,
    14146, 14387, 14629, 14874, 15122, 15371, 15623, 15878, 16135, 16394, 16656, 16920, 17187, 17456, 17727, 18001,
    18277, 18556, 18837, 19121, 19407, 19696, 19987, 20281, 20577, 20876, 21177, 21481, 21787, 22096, 22407, 22721,
    23038, 23357, 23678, 24002, 24329, 24658, 24990, 25325, 25662, 26001, 26344, 26688, 27036, 27386, 27739, 28094,
    28452, 28813, 29176, 29542, 29911, 30282, 30656, 31033, 31412, 31794, 32179, 32567, 32957, 33350, 33745, 34143,
    34544, 34948, 35355, 35764, 36176, 36591, 37008, 37429, 37852, 38278, 38706, 39138, 39572, 40009, 40449, 40891,
    41337, 41785, 42236, 42690, 43147, 43606, 44069, 44534, 45002, 45473, 45947, 46423, 46903, 47385, 47871, 48359,
    48850, 49344, 49841, 50341, 50844, 51349, 51858, 52369, 52884, 53401, 53921, 54445, 54971, 55500, 56032, 56567,
    57105, 57646, 58190, 58737, 59287, 59840, 60396, 60955, 61517, 62082, 62650, 63221, 63795, 64372, 64952, 65535};

/* XYZ over the white point D65 from linear sRGB, in units of 2^-16; rows add up to 1. */
static const int32_t xyz_of[3][3] = {{28439, 24655, 12442}, {13938, 46868, 4730}, {1164, 7174, 57198}};

/* The order of thresholds: Bayer's matrix of 8 x 8. */
static unsigned threshold(unsigned x, unsigned y)
{
    unsigned value = 0;

    for (unsigned bit = 0; bit < 3; bit++) {
        unsigned u = x >> bit & 1, v = y >> bit & 1;
        value |= ((u ^ v) << 1 | v) << (2 * (2 - bit));
    }
    return value;
}

/* ---- CIE Lab ---- */

/* Returns the floor of the cube root. */
static uint32_t cube_root(uint64_t n)
{
    uint32_t root = 0;

    for (uint32_t bit = UINT32_C(1) << 20; bit; bit >>= 1) {
        uint64_t r = root | bit;
        if (r * r * r <= n)
            root |= bit;
    }
    return root;
}

/* Tabulates f(t) of CIE Lab: the cube root above (6/29)^3, below a line, 841/108 t + 4/29. */
static void fill_curve(struct dither *d)
{
    for (uint64_t i = 0; i < CURVE + 2; i++) {
        bool line = i * 24389 <= 216 * CURVE;
        uint64_t f = line ? (i * 841 * 8 / 108) + 32768 * 4 / 29 : cube_root(i << (45 - CURVE_BITS));
        d->curve[i] = (uint16_t)(f > 32768 ? 32768 : f);
    }
}

static int32_t curve_at(const struct dither *d, int32_t t)
{
    int32_t at = t >> (16 - CURVE_BITS), rest = t & ((1 << (16 - CURVE_BITS)) - 1);

    return d->curve[at] + (((int32_t)d->curve[at + 1] - d->curve[at]) * rest >> (16 - CURVE_BITS));
}

static struct lab lab_of(const struct dither *d, const struct linear *linear)
{
    int32_t f[3];

    for (int i = 0; i < 3; i++) {
        int64_t t = 0;
        for (int j = 0; j < 3; j++)
            t += (int64_t)xyz_of[i][j] * linear->c[j];
        f[i] = curve_at(d, (int32_t)(t >> 16));
    }
    return (struct lab){116 * f[1] >> 9, 500 * (f[0] - f[1]) / 512, 200 * (f[1] - f[2]) / 512};
}

static int64_t distance(const struct lab *p, const struct lab *q)
{
    int64_t l = p->l - q->l, a = p->a - q->a, b = p->b - q->b;

    return l * l + a * a + b * b;
}

static struct linear expand(struct rgb8 c)
{
    return (struct linear){{linear_of[c.r], linear_of[c.g], linear_of[c.b]}};
}

/* ---- mixtures ---- */

/* Finds the nearest colours of the palette, the nearest first. Returns their number. */
static unsigned find_candidates(const struct dither *d, const struct lab *want, uint8_t found[CANDIDATES])
{
    int64_t far[CANDIDATES];
    unsigned count = 0;

    for (unsigned i = d->first; i < d->first + d->count; i++) {
        int64_t away = distance(&d->lab[i], want);
        unsigned at = count < CANDIDATES ? count++ : CANDIDATES;
        for (; at > 0 && away < far[at - 1]; at--)
            if (at < CANDIDATES) {
                far[at] = far[at - 1];
                found[at] = found[at - 1];
            }
        if (at < CANDIDATES) {
            far[at] = away;
            found[at] = (uint8_t)i;
        }
    }
    return count;
}

/* Returns the share of q, in 64ths, by which the mixture of p and q is nearest to `want` in linear light. */
static unsigned share(const struct linear *p, const struct linear *q, const struct linear *want)
{
    int64_t along = 0, length = 0;

    for (int i = 0; i < 3; i++) {
        int64_t way = q->c[i] - p->c[i];
        along += way * (want->c[i] - p->c[i]);
        length += way * way;
    }
    if (along <= 0 || length == 0)
        return 0;
    return along >= length ? LEVELS : (unsigned)((along * LEVELS + length / 2) / length);
}

/* Returns the weight of what a mixture's colours differ by: more if they differ in hue than in lightness, and not much
 * less for a few points of one of them in the other, which are seen as points. */
static int64_t contrast(const struct dither *d, struct mixture m)
{
    const struct lab *p = &d->lab[m.first], *q = &d->lab[m.second];
    int64_t l = p->l - q->l, a = p->a - q->a, b = p->b - q->b;
    int64_t both = m.parts * (LEVELS - m.parts);

    if (!both)
        return 0;
    return (l * l + d->hue * (a * a + b * b)) * (4 + both / LEVELS) * d->weight / (LEVELS * LEVELS);
}

/* Returns the error of a mixture in the units of distance(). */
static int64_t error_of(const struct dither *d, struct mixture m, const struct lab *want)
{
    const struct linear *p = &d->linear[m.first], *q = &d->linear[m.second];
    struct linear mean;

    for (int i = 0; i < 3; i++)
        mean.c[i] = (p->c[i] * (LEVELS - m.parts) + q->c[i] * m.parts) / LEVELS;
    struct lab lab = lab_of(d, &mean);
    return distance(&lab, want) + contrast(d, m);
}

static struct mixture find_mixture(const struct dither *d, tia_rgb565 pixel)
{
    struct linear want = expand(colour_expand(pixel));
    struct lab lab = lab_of(d, &want);
    uint8_t found[CANDIDATES] = {0};
    unsigned count = find_candidates(d, &lab, found);
    struct mixture best = {found[0], found[0], 0, 1};
    int64_t least = error_of(d, best, &lab);

    for (unsigned i = 0; i < count; i++)
        for (unsigned j = 0; j < count; j++) {
            struct mixture m = {found[i], found[j], 0, 1};
            if (d->lab[m.first].l >= d->lab[m.second].l)
                continue; /* the first one is the darker one, so that patterns of similar colours fit */
            m.parts = (uint8_t)share(&d->linear[m.first], &d->linear[m.second], &want);
            int64_t error = error_of(d, m, &lab);
            if (error < least) {
                least = error;
                best = m;
            }
        }
    return best;
}

struct dither *dither_new(enum colours colours)
{
    struct dither *d = calloc(1, sizeof *d);

    if (!d)
        return NULL;
    fill_curve(d);
    d->weight = colours == COLOURS_256 ? 32 : 3; /* both chosen by looking; 16 colours are far apart */
    d->hue = colours == COLOURS_256 ? 2 : 1;
    d->first = colours == COLOURS_256 ? 16 : 0; /* users can redefine the first 16 */
    d->count = colours == COLOURS_256 ? 240 : 16;
    for (unsigned i = d->first; i < d->first + d->count; i++) {
        d->linear[i] = expand(colour_indexed(colours, i));
        d->lab[i] = lab_of(d, &d->linear[i]);
    }
    return d;
}

uint8_t dither_pixel(struct dither *dither, tia_rgb565 pixel, unsigned x, unsigned y)
{
    struct mixture *m = &dither->mixtures[pixel];

    if (!m->known)
        *m = find_mixture(dither, pixel);
    return threshold(x, y) < m->parts ? m->second : m->first;
}
