/* denoise_pass.c - a pass of the denoiser's wavelet filter. */
#include "denoise_data.h"

#include "math/integer.h"

/* Tolerances: the best of 500 settings on a Cornell box of 128x128 pixels with 4, 16 and 64 samples per pixel. ROOM
 * includes a fraction of the depth, since surfaces may be curved. SPREAD includes 2^-12, since means may have no
 * noise. */
#define SPREAD(error) (3 * (uint64_t)(error) + 16)
#define ROOM(slope, pixels, depth) ((uint64_t)(slope) * (pixels) / 8 + (depth) / 512)
#define ALBEDO_WEIGHT 4
#define NORMAL_SQUARINGS 3

/* A pixel, and the values with which neighbours are compared. */
struct middle {
    const struct tia_denoiser *d;
    const struct light *light; /* light of the whole picture */
    int x, y, step;
    bool stops; /* the pass stops at edges of the light */
    struct feature feature;
    uint32_t luminance;
    uint64_t spread;      /* tolerance of the luminance for noise, Q.16 */
    int64_t across, down; /* change of the depth to the next pixel, Q.16 */
    uint32_t slope;       /* the larger of |across| and |down| */
};

struct total {
    uint64_t weight, rgb[3], squares;
};

static const int filter[5] = {1, 4, 6, 4, 1};

static uint32_t apart(uint32_t a, uint32_t b)
{
    return a > b ? a - b : b - a;
}

/* Returns 2^-x, within 0.2 %, by a parabola between powers of two. x and the result have 16 fractional bits. */
static uint32_t fade(uint64_t x)
{
    uint32_t f = (uint32_t)(x & 0xffff);

    if (x >> 20)
        return 0;
    return (65535 - (uint32_t)((uint64_t)f * (43975 - (f * (uint64_t)11207 >> 16)) >> 16)) >> (x >> 16);
}

static uint64_t ratio(uint64_t a, uint64_t b)
{
    return b ? (a << 16) / b : a ? UINT32_MAX : 0;
}

/* Returns (a.b)^8, with 16 fractional bits, for two normals; 0 if a.b is negative. */
static uint32_t alike(const int16_t a[3], const int16_t b[3])
{
    int32_t dot = 0;
    uint32_t power;

    for (int c = 0; c < 3; c++)
        dot += ((int32_t)a[c] * b[c]) / 4096;
    if (dot <= 0)
        return 0;
    power = dot > 65535 ? 65535 : (uint32_t)dot;
    for (int i = 0; i < NORMAL_SQUARINGS; i++)
        power = (uint32_t)(((uint64_t)power * power) >> 16);
    return power;
}

/* Returns the deviation of a neighbour's depth from the middle pixel's plane, relative to the tolerance, with 16
 * fractional bits. */
static uint64_t off_plane(const struct middle *m, uint32_t depth, int dx, int dy)
{
    int64_t off = (int64_t)depth - (int64_t)m->feature.depth - (m->across * dx + m->down * dy);
    unsigned away = (unsigned)((dx < 0 ? -dx : dx) + (dy < 0 ? -dy : dy));

    return ratio((uint64_t)(off < 0 ? -off : off), ROOM(m->slope, away, m->feature.depth));
}

/* Returns the edge-stopping weight of a neighbour, without the filter's own weight, Q.16. */
static uint32_t weight(const struct middle *m, size_t at, int dx, int dy)
{
    const struct feature *f = &m->d->features[at];
    uint32_t same = alike(m->feature.normal, f->normal);

    if (!same)
        return 0;
    uint64_t x = off_plane(m, f->depth, dx, dy);
    if (m->stops)
        x += ratio(apart(m->luminance, luminance(m->light[at].rgb)), m->spread);
    for (int c = 0; c < 3; c++)
        x += ALBEDO_WEIGHT * (uint64_t)apart(m->feature.albedo[c], f->albedo[c]);
    return (uint32_t)((uint64_t)same * fade(x) >> 16);
}

static void add(struct total *total, const struct light *light, uint32_t weight, int factor)
{
    uint64_t w = (uint64_t)weight * (unsigned)factor, we = w * light->error >> 19;

    total->weight += w;
    for (int c = 0; c < 3; c++)
        total->rgb[c] += w * light->rgb[c];
    total->squares += we * we;
}

/* Returns the standard error of a pixel's mean, smoothed over 3x3 pixels. */
static uint32_t error_around(const struct middle *m)
{
    uint64_t sum = 0, weights = 0;

    for (int j = -1; j <= 1; j++)
        for (int i = -1; i <= 1; i++) {
            int x = m->x + i, y = m->y + j;
            if (x < 0 || y < 0 || x >= (int)m->d->width || y >= (int)m->d->height)
                continue;
            uint64_t w = (i ? 1u : 2u) * (j ? 1u : 2u);
            uint32_t e = m->light[(size_t)y * m->d->width + (size_t)x].error;
            sum += w * ((uint64_t)e * e >> 4);
            weights += w;
        }
    uint64_t mean = sum / weights;
    return mean >> 60 ? UINT32_MAX : tia_sqrt64(mean << 4);
}

static int64_t depth_at(const struct tia_denoiser *d, int x, int y)
{
    x = x < 0 ? 0 : x >= (int)d->width ? (int)d->width - 1 : x;
    y = y < 0 ? 0 : y >= (int)d->height ? (int)d->height - 1 : y;
    return d->features[(size_t)y * d->width + (size_t)x].depth;
}

static uint32_t size_of(int64_t x)
{
    return (uint32_t)(x < 0 ? -x : x);
}

static void begin(struct middle *m, const struct tia_denoiser *d, unsigned pass, int x, int y)
{
    size_t at = (size_t)y * d->width + (size_t)x;

    *m = (struct middle){.d = d, .light = d->light[pass & 1], .x = x, .y = y, .feature = d->features[at]};
    m->stops = pass < EDGE_PASSES;
    m->step = 1 << (m->stops ? pass : pass - EDGE_PASSES);
    m->luminance = luminance(m->light[at].rgb);
    m->spread = m->stops ? SPREAD(error_around(m)) : 0;
    m->across = (depth_at(d, x + 1, y) - depth_at(d, x - 1, y)) / 2;
    m->down = (depth_at(d, x, y + 1) - depth_at(d, x, y - 1)) / 2;
    m->slope = size_of(m->across) > size_of(m->down) ? size_of(m->across) : size_of(m->down);
}

static struct light filtered(const struct middle *m)
{
    const struct tia_denoiser *d = m->d;
    size_t own = (size_t)m->y * d->width + (size_t)m->x;
    struct total total = {0, {0, 0, 0}, 0};
    struct light result;

    for (int j = -2; j <= 2; j++)
        for (int i = -2; i <= 2; i++) {
            int dx = i * m->step, dy = j * m->step, x = m->x + dx, y = m->y + dy;
            if (x < 0 || y < 0 || x >= (int)d->width || y >= (int)d->height)
                continue;
            size_t at = (size_t)y * d->width + (size_t)x;
            add(&total, &m->light[at], at == own ? 65536 : weight(m, at, dx, dy), filter[i + 2] * filter[j + 2]);
        }
    for (int c = 0; c < 3; c++)
        result.rgb[c] = (uint32_t)((total.rgb[c] + total.weight / 2) / total.weight);
    uint64_t error = ((uint64_t)tia_sqrt64(total.squares) << 19) / total.weight;
    result.error = error > UINT32_MAX ? UINT32_MAX : (uint32_t)error;
    return result;
}

/* Stores the filtered light, and sets *light to the part that the filter removed. */
static void take(struct tia_denoiser *d, size_t at, struct light *light)
{
    for (int c = 0; c < 3; c++) {
        int64_t taken = (int64_t)d->filtered[at].rgb[c] - light->rgb[c] + NONE_TAKEN;
        d->filtered[at].rgb[c] = light->rgb[c];
        light->rgb[c] = taken < 0 ? 0 : taken > UINT32_MAX ? UINT32_MAX : (uint32_t)taken;
    }
}

int tia_denoise_pass(struct tia_denoiser *d, unsigned pass, struct tia_tile tile)
{
    struct middle m;

    if (pass >= TIA_DENOISE_PASSES || !tia_denoise_has(d, tile))
        return TIA_ERR_ARGUMENT;
    for (int y = (int)tile.y; y < (int)tile.y + (int)tile.height; y++)
        for (int x = (int)tile.x; x < (int)tile.x + (int)tile.width; x++) {
            size_t at = (size_t)y * d->width + (size_t)x;
            begin(&m, d, pass, x, y);
            struct light light = filtered(&m);
            if (pass == EDGE_PASSES - 1)
                take(d, at, &light);
            d->light[(pass + 1) & 1][at] = light;
        }
    return TIA_OK;
}
