/* denoise_picture.c - converts sums of samples to light, which is radiance divided by albedo, and back. */
#include "denoise_data.h"

#include <tia/debug.h>

#include "math/align.h"
#include "math/integer.h"

#define FLOOR 512                    /* least albedo: 2^-7, Q16.16 */
#define MEAN_MAX (INT64_C(1) << 38)  /* largest mean of samples: 2^14, in units of 2^-24 */
#define DEPTH_MAX (INT64_C(1) << 54) /* limit of a sum of depths: times 256, it is below 2^63 */

size_t tia_denoise_size(unsigned width, unsigned height)
{
    uint64_t pixels = (uint64_t)width * height;
    uint64_t size = ALIGN(sizeof(struct tia_denoiser)) + 2 * ALIGN(pixels * sizeof(struct light)) +
                    ALIGN(pixels * sizeof(struct feature)) + ALIGN(pixels * sizeof(struct colour));

    return width <= TIA_SIZE_MAX && height <= TIA_SIZE_MAX && size < SIZE_MAX ? (size_t)size : SIZE_MAX;
}

int tia_denoise_init(struct tia_denoiser **denoiser, void *memory, size_t size, unsigned width, unsigned height)
{
    struct tia_denoiser *d = memory;

    if (!denoiser || !memory_is_usable(memory) || !width || !height || width > TIA_SIZE_MAX || height > TIA_SIZE_MAX)
        return TIA_ERR_ARGUMENT;
    if (size < tia_denoise_size(width, height))
        return TIA_ERR_MEMORY;
    size_t pixels = (size_t)width * height;
    char *at = (char *)memory + ALIGN(sizeof *d);
    *d = (struct tia_denoiser){.width = width, .height = height};
    for (int i = 0; i < 2; i++, at += ALIGN(pixels * sizeof(struct light)))
        d->light[i] = (struct light *)(void *)at;
    d->features = (struct feature *)(void *)at;
    d->filtered = (struct colour *)(void *)(at + ALIGN(pixels * sizeof(struct feature)));
    for (size_t i = 0; i < pixels; i++) {
        d->light[0][i] = d->light[1][i] = (struct light){{0, 0, 0}, 0};
        d->features[i] = (struct feature){.depth = 0};
        d->filtered[i] = (struct colour){{0, 0, 0}};
    }
    *denoiser = d;
    return TIA_OK;
}

bool tia_denoise_has(const struct tia_denoiser *d, struct tia_tile tile)
{
    return d && tile_is_inside(tile, (struct tia_tile){0, 0, (uint16_t)d->width, (uint16_t)d->height});
}

/* Returns sum/count, rounded to nearest; sum >= 0. */
static uint64_t mean(int64_t sum, uint32_t count)
{
    return ((uint64_t)sum + count / 2) / count;
}

/* Derivation: the variance of samples is n (mean of squares - square of the mean)/(n - 1). The variance of their mean
 * is 1/n of the samples' variance.
 */
uint32_t tia_standard_error(const struct tia_sum *sum, uint64_t squares, uint32_t count)
{
    if (!sum || !count)
        return 0;
    uint64_t all = (uint64_t)sum->rgb[0] + 2 * (uint64_t)sum->rgb[1] + (uint64_t)sum->rgb[2];
    uint64_t whole = all / ((uint64_t)count * 4), most = whole >> 32 ? UINT64_MAX : whole * whole >> 16;

    if (whole >> 32) /* whole * whole would overflow */
        most = (whole >> 8) * (whole >> 8);
    if (count == 1)
        return tia_sqrt64(most);
    uint64_t spread = squares / count;
    return spread > most ? tia_sqrt64((spread - most) / (count - 1)) : 0;
}

/* Stores a channel's albedo and light. The divisor is raised so that the quotient, the light, is below 2^16. */
static void put_channel(struct light *light, struct feature *feature, int c, uint64_t radiance, uint64_t albedo)
{
    uint64_t divisor = (albedo + 128) >> 8, least = radiance >> 24;

    divisor = divisor < FLOOR ? FLOOR : divisor;
    divisor = divisor < least ? least : divisor;
    uint64_t quotient = ((radiance << 8) + divisor / 2) / divisor;
    light->rgb[c] = quotient > UINT32_MAX ? UINT32_MAX : (uint32_t)quotient;
    feature->albedo[c] = (uint32_t)divisor;
}

/* Stores the normalised mean of the normals, or 0. Components are reduced below 2^30, so that squares do not
 * overflow. */
static void put_normal(struct feature *feature, const int64_t sum[3])
{
    int64_t n[3];
    uint64_t most = 0;
    unsigned down = 0;

    for (int c = 0; c < 3; c++)
        most |= sum[c] < 0 ? 0 - (uint64_t)sum[c] : (uint64_t)sum[c];
    while (most >> down >= UINT64_C(1) << 30)
        down++;
    for (int c = 0; c < 3; c++)
        n[c] = sum[c] / (INT64_C(1) << down);
    uint32_t length = tia_sqrt64((uint64_t)(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]));
    for (int c = 0; c < 3; c++)
        feature->normal[c] = (int16_t)(length ? n[c] * 16384 / length : 0);
    feature->normal[3] = 0;
}

static void put_pixel(struct light *light, struct feature *feature, const struct tia_gathered *g, size_t at,
                      uint32_t count)
{
    const struct tia_guide *guide = &g->guides[at];

    for (int c = 0; c < 3; c++)
        put_channel(light, feature, c, mean(g->sums[at].rgb[c], count), mean(guide->albedo[c], count));
    put_normal(feature, guide->normal);
    uint64_t depth = mean(guide->depth, count);
    feature->depth = depth > UINT32_MAX ? UINT32_MAX : (uint32_t)depth;
    uint64_t error = tia_standard_error(&g->sums[at], g->squares[at], count), by = luminance(feature->albedo);
    error = (error << 16) / by;
    light->error = error > UINT32_MAX ? UINT32_MAX : (uint32_t)error;
}

static bool is_whole(const struct tia_gathered *g)
{
    return g && g->sums && g->guides && g->squares;
}

int tia_denoise_put(struct tia_denoiser *d, struct tia_tile tile, const struct tia_gathered *gathered, uint32_t count)
{
    if (!tia_denoise_has(d, tile) || !is_whole(gathered) || !count || count > TIA_SPP_MAX)
        return TIA_ERR_ARGUMENT;
    for (size_t y = 0; y < tile.height; y++)
        for (size_t x = 0; x < tile.width; x++) {
            size_t at = (tile.y + y) * d->width + tile.x + x;
            put_pixel(&d->light[0][at], &d->features[at], gathered, y * gathered->pitch + x, count);
            for (int c = 0; c < 3; c++)
                d->filtered[at].rgb[c] = d->light[0][at].rgb[c];
        }
    return TIA_OK;
}

/* Returns a channel of the filtered light, plus the mean of the light that was removed from surrounding pixels. */
static uint32_t light_of(const struct tia_denoiser *d, size_t at, int c)
{
    int64_t light = (int64_t)d->filtered[at].rgb[c] + d->light[TIA_DENOISE_PASSES & 1][at].rgb[c] - NONE_TAKEN;

    return light < 0 ? 0 : light > UINT32_MAX ? UINT32_MAX : (uint32_t)light;
}

int tia_denoise_get(const struct tia_denoiser *d, struct tia_tile tile, uint32_t count, struct tia_sum *sums,
                    size_t pitch)
{
    if (!tia_denoise_has(d, tile) || !sums || !count || count > TIA_SPP_MAX)
        return TIA_ERR_ARGUMENT;
    for (size_t y = 0; y < tile.height; y++)
        for (size_t x = 0; x < tile.width; x++) {
            size_t at = (tile.y + y) * d->width + tile.x + x;
            for (int c = 0; c < 3; c++) {
                uint64_t product = (uint64_t)light_of(d, at, c) * d->features[at].albedo[c];
                int64_t radiance = (int64_t)((product + 128) >> 8);
                sums[y * pitch + x].rgb[c] = (radiance < MEAN_MAX ? radiance : MEAN_MAX) * count;
            }
        }
    return TIA_OK;
}

/* ---- pictures of the guides ---- */

const char *tia_shown_guide_name(unsigned shown)
{
    static const char *const names[] = {"normal", "depth", "albedo", "error"};

    return shown && shown <= sizeof names / sizeof *names ? names[shown - 1] : NULL;
}

static bool has_guide(const struct tia_gathered *g, enum tia_shown_guide shown)
{
    return g && g->sums && g->guides && (shown != TIA_SHOW_ERROR || g->squares);
}

struct tia_sum tia_guide_shown(enum tia_shown_guide shown, const struct tia_gathered *g, size_t at, uint32_t count)
{
    struct tia_sum sum = {{0, 0, 0}};

    if (!has_guide(g, shown) || !count || count > TIA_SPP_MAX)
        return sum;
    const struct tia_guide *guide = &g->guides[at];
    uint32_t error = shown == TIA_SHOW_ERROR ? tia_standard_error(&g->sums[at], g->squares[at], count) : 0;
    for (int c = 0; c < 3; c++)
        sum.rgb[c] = shown == TIA_SHOW_NORMAL  ? (guide->normal[c] + (int64_t)count * (INT64_C(1) << 24)) / 2
                     : shown == TIA_SHOW_DEPTH ? (guide->depth < DEPTH_MAX ? guide->depth : DEPTH_MAX) * 256
                     : shown == TIA_SHOW_ERROR ? (int64_t)error * 256 * count
                                               : guide->albedo[c];
    return sum;
}
