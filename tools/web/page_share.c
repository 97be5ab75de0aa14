/* page_share.c - shares the work of a slow picture: helpers, workers of their own, draw its rows from the bottom up
 * (page_rows.c), while the viewer draws it coarse to fine. Pixels of a row that a helper has delivered are copied, and
 * since every worker draws the same bits, it does not matter which ones. Samples are shared in parts
 * (idle_samples.c). */
#include "page.h"

#include <stdlib.h>
#include <string.h>

enum { SLOW_US = 100000 }; /* time after which helpers are asked */

static struct {
    const struct tia_drawing *base;
    struct web_share share;
    uint8_t *traced; /* for each pixel, 1: its hit is known, since it was drawn here */
    size_t pixels;   /* room in these arrays */
    uint64_t begun_us;
    bool asked;
    uint32_t copied; /* pixels of this frame */
} now;

uint32_t share_copied(void)
{
    return (uint32_t)(((uint64_t)now.copied << 16) / ((uint32_t)session.screen.width * session.screen.height));
}

void share_end(void)
{
    if (now.asked)
        web_share(NULL);
    now.asked = false;
}

static bool get_memory(size_t pixels)
{
    if (now.pixels < pixels) {
        free(now.share.pixels);
        free(now.share.have);
        free(now.traced);
        now.share.pixels = malloc(pixels * sizeof *now.share.pixels);
        now.share.have = malloc(pixels);
        now.traced = malloc(pixels);
        now.pixels = now.share.pixels && now.share.have && now.traced ? pixels : 0;
    }
    return now.pixels;
}

/* True if the settings and the state are ones that a helper has as well. */
static bool is_shared(void)
{
    const struct settings *settings = &session.settings;

    return settings->arithmetic != ARITHMETIC_DIFFERENCE && settings->view == VIEW_COLOUR && !settings->rays;
}

/* True if, in addition, pixels do not depend on each other, and the frame's time is known while it is drawn. */
static bool shares_rows(void)
{
    return is_shared() && !tia_scene_moves(&session.scene) && seat.base->draws_by_pixel &&
           seat.base->draws_by_pixel(seat.base, &session.variant);
}

void share_begin(void)
{
    share_end();
    now.copied = 0;
    now.begun_us = shares_rows() && get_memory((size_t)session.screen.width * session.screen.height)
                       ? web_clock.now_us(NULL)
                       : UINT64_MAX;
    if (now.begun_us != UINT64_MAX)
        memset(now.share.have, 0, session.screen.height);
}

static void ask(void)
{
    if (now.asked || now.begun_us == UINT64_MAX || web_clock.now_us(NULL) < now.begun_us + SLOW_US)
        return;
    now.asked = true;
    now.share.samples = session.spp ? 1 : 0;
    now.share.state_size = session_keep(&now.share.state);
    web_share(&now.share);
}

void share_samples(void)
{
    struct web_share share = {.pixels = NULL};

    now.asked = is_shared();
    if (now.asked) {
        share.state_size = session_keep(&share.state);
        web_share(&share);
    }
}

static bool has_rows(struct tia_tile tile)
{
    bool has = now.asked;

    for (unsigned y = 0; y < tile.height && has; y++)
        has = now.share.have[tile.y + y];
    return has;
}

static void mark(struct tia_tile tile, uint8_t traced)
{
    for (unsigned y = 0; y < tile.height && now.begun_us != UINT64_MAX; y++)
        memset(now.traced + (size_t)(tile.y + y) * session.screen.width + tile.x, traced, tile.width);
}

static void copy(struct tia_tile tile, const struct tia_surface *surface)
{
    for (unsigned y = 0; y < tile.height; y++) {
        const tia_rgb565 *from = now.share.pixels + (size_t)(tile.y + y) * session.screen.width + tile.x;
        char *to = (char *)surface->pixels + (ptrdiff_t)y * surface->pitch;
        for (unsigned x = 0; x < tile.width; x++)
            *(tia_rgb565 *)(void *)(to + (ptrdiff_t)x * surface->step) = from[x];
    }
    now.copied += (uint32_t)tile.width * tile.height;
}

static int render(const struct tia_view *view, struct tia_hits *hits, struct tia_tile tile,
                  const struct tia_surface *surface, const struct tia_options *options)
{
    ask();
    bool copies = has_rows(tile);

    mark(tile, !copies);
    if (!copies)
        return now.base->render(view, hits, tile, surface, options);
    copy(tile, surface);
    return TIA_OK;
}

static bool is_traced(struct tia_tile tile)
{
    bool traced = true;

    for (unsigned y = 0; y < tile.height && now.begun_us != UINT64_MAX && traced; y++)
        traced = !memchr(now.traced + (size_t)(tile.y + y) * session.screen.width + tile.x, 0, tile.width);
    return traced;
}

/* Lights a tile whose hits are known; traces the pixels again that were copied. */
static int light(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile,
                 const struct tia_surface *surface, const struct tia_options *options)
{
    return is_traced(tile) ? now.base->light(view, hits, tile, surface, options)
                           : render(view, (struct tia_hits *)(uintptr_t)hits, tile, surface, options);
}

void share_wrap(const struct tia_drawing *base, struct tia_drawing *drawing)
{
    now.base = base;
    now.begun_us = UINT64_MAX;
    drawing->render = render;
    drawing->light = light;
}
