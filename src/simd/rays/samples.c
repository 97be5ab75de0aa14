/* samples.c - sampled pixels: blocks of samples go to the SIMD kernels, undecided samples to the fixed-point path. */
#include "bounds.h"
#include "gather.h"
#include "render/path/path.h"
#include "simd/simd.h"

struct drawing {
    const struct tia_view *view;
    const struct tia_gathered *gathered;
    struct tia_tile tile;
    uint64_t all, unsure;
    struct sure_gather block;
};

static size_t room(const struct tia_simd *simd)
{
    return simd_room(sizeof(struct drawing), simd->sure->gather_memory);
}

/* Rounds a colour to units of 2^-24, see num_q24. False if the bound e allows several results. */
static bool rounded(double c, double e, int64_t *q24)
{
    double low = c - e, high = c + e;

    low = low < 0 ? 0 : low > 16384 ? 16384 : low;
    high = high < 0 ? 0 : high > 16384 ? 16384 : high;
    *q24 = (int64_t)(low * 16777216 + 0.5);
    return *q24 == (int64_t)(high * 16777216 + 0.5);
}

static size_t place_of(const struct drawing *d, int x, int y)
{
    return (size_t)(y - (int)d->tile.y) * d->gathered->pitch + (size_t)(x - (int)d->tile.x);
}

static struct tia_gathered pixel_of(const struct drawing *d, int x, int y)
{
    size_t at = place_of(d, x, y);
    const struct tia_gathered *g = d->gathered;

    return (struct tia_gathered){&g->sums[at], g->guides ? &g->guides[at] : NULL, g->squares ? &g->squares[at] : NULL,
                                 1};
}

/* Adds samples first..end - 1 of a pixel by the fixed-point path. */
static void sample_exactly(const struct drawing *d, int x, int y, uint32_t first, uint32_t end)
{
    const struct tia_gathered pixel = pixel_of(d, x, y);

    d->view->renderer->sample(d->view, (struct tia_tile){(uint16_t)x, (uint16_t)y, 1, 1}, first, end, &pixel);
}

/* Adds an undecided sample by the fixed-point path, from the hits that are certain. */
static void finish_exactly(const struct drawing *d, int i)
{
    const struct sure_gather *b = &d->block;
    struct tia_gathered pixel;

    if (d->view->scene->integration.integrator != TIA_PATHS) {
        sample_exactly(d, b->x[i], b->y[i], b->index[i], b->index[i] + 1);
        return;
    }
    pixel = pixel_of(d, b->x[i], b->y[i]);
    estimate_resume(d->view, b->x[i], b->y[i], b->index[i], &b->known[i], &pixel, path_radiance);
}

static void finish_sample(struct drawing *d, int i)
{
    const struct sure_gather *b = &d->block;
    size_t at = place_of(d, b->x[i], b->y[i]);
    double e = b->error[i] + sure_most3(b->colour[i]) * BOUND(SUMMED);
    int64_t rgb[3];
    bool sure = !b->unsure[i];

    for (int c = 0; c < 3 && sure; c++)
        sure = rounded(b->colour[i][c], e, &rgb[c]);
    d->all++;
    if (!sure) {
        if (cancelled(&d->block.cancel, CANCEL_INTERVAL)) /* a fixed-point sample may take a while */
            return;
        d->unsure++;
        finish_exactly(d, i);
        return;
    }
    for (int c = 0; c < 3; c++)
        d->gathered->sums[at].rgb[c] += rgb[c];
    if (d->gathered->squares)
        estimate_add_square(rgb, &d->gathered->squares[at]);
}

static void finish_block(struct drawing *d)
{
    struct sure_gather *b = &d->block;
    const struct sure_kernels *kernels = d->view->simd->sure;

    if (!b->count)
        return;
    if (d->view->scene->integration.integrator == TIA_PATHS)
        kernels->walk(b, simd_kernels_room(d, sizeof *d));
    else
        kernels->occlude(b, simd_kernels_room(d, sizeof *d));
    for (int i = 0; i < b->count && !d->block.cancel.stopped; i++)
        finish_sample(d, i);
    b->count = 0;
}

/* True unless more than half of the samples so far were undecided: doubles then waste time. */
static bool pays(const struct drawing *d)
{
    return d->unsure * 2 <= d->all;
}

static void add_pixel(struct drawing *d, int x, int y, uint32_t first, uint32_t end)
{
    struct sure_gather *b = &d->block;

    for (uint32_t i = first; i < end && !d->block.cancel.stopped; i++) {
        if (!b->count && !pays(d)) {
            sample_exactly(d, x, y, i, end);
            return;
        }
        b->x[b->count] = x;
        b->y[b->count] = y;
        b->index[b->count++] = i;
        if (b->count == SURE_GATHERED)
            finish_block(d);
    }
}

/* Adds samples. Guides are data of the samples' first hits: if they are requested, the fixed-point path adds all
 * samples. */
static void sample(const struct tia_view *view, struct tia_tile tile, uint32_t first, uint32_t end,
                   const struct tia_gathered *gathered, void *memory)
{
    struct drawing *d = memory;

    if (gathered->guides || tia_sure_scene(view)->fixed_only) {
        view->renderer->sample(view, tile, first, end, gathered);
        return;
    }
    d->view = view;
    d->gathered = gathered;
    d->tile = tile;
    d->all = d->unsure = 0;
    d->block.cancel = view_cancel(view);
    d->block.scene = tia_sure_scene(view);
    d->block.count = 0;
    for (int y = (int)tile.y; y < tile_bottom(tile) && !view_stops(view); y++)
        for (int x = (int)tile.x; x < tile_right(tile) && !d->block.cancel.stopped; x++)
            add_pixel(d, x, y, first, end);
    finish_block(d);
}

#define PIECE 64 /* number of a row's pixels that are drawn at once */

static void light(const struct tia_view *view, struct tia_tile tile, const struct tia_surface *surface,
                  const struct tia_options *options, void *memory)
{
    uint32_t spp = view->scene->integration.spp;

    if (options_debug(options).path_hash || options_debug(options).lit) {
        tia_simd_light_plain(view, tile, surface, options);
        return;
    }
    spp = spp ? spp : TIA_SPP_DEFAULT;
    for (int y = 0; y < (int)tile.height && !view_stops(view); y++)
        for (int x = 0; x < (int)tile.width && !view_stops(view); x += PIECE) {
            int left = (int)tile.width - x;
            struct tia_tile piece = {(uint16_t)(tile.x + x), (uint16_t)(tile.y + y),
                                     (uint16_t)(left < PIECE ? left : PIECE), 1};
            struct tia_sum sums[PIECE] = {{{0, 0, 0}}};
            sample(view, piece, 0, spp, &(struct tia_gathered){.sums = sums, .pitch = PIECE}, memory);
            char *out = (char *)surface->pixels + (ptrdiff_t)y * surface->pitch + (ptrdiff_t)x * surface->step;
            struct tia_surface part = *surface;
            part.pixels = (tia_rgb565 *)(void *)out;
            estimate_show(view, piece, sums, spp, &part, options->dither);
        }
}

/* True if the SIMD kernels draw the view. The fixed-point path draws scenes without a hierarchy, scenes in which a
 * sampling strategy is turned off, and light fields, whose neighbouring pixels have different eyes. */
static bool draws(const struct tia_view *view)
{
    return view->scene->bvh && !view->scene->integration.without && !view->scene->field;
}

const struct simd_renderer tia_simd_samples = {
    tia_gather_size, draws, tia_gather_prepare, tia_gather_set_lights, room, light, sample, NULL};
