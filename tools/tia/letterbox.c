#include "letterbox.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "ports.h"

/* ---- size and place ---- */

static uint16_t at_most(uint16_t value, uint16_t limit)
{
    return value < limit ? value : limit;
}

/* The picture as large as the user asked, or as large as the screen lets a picture be. */
static void choose_turn(struct stage *stage)
{
    bool swaps = turn_swaps(stage->degrees);
    uint16_t width = at_most(swaps ? stage->mode.height : stage->mode.width, TIA_SIZE_MAX);
    uint16_t height = at_most(swaps ? stage->mode.width : stage->mode.height, TIA_SIZE_MAX);
    stage->turn.degrees = stage->degrees;
    stage->turn.width = stage->width != 0 ? stage->width : width;
    stage->turn.height = stage->height != 0 ? stage->height : height;
}

static int choose_frame(struct stage *stage)
{
    if (!stage->checksum) {
        return TIA_OK;
    }
    free(stage->frame);
    stage->frame = malloc((size_t)stage->place.width * stage->place.height * sizeof *stage->frame);
    if (stage->frame == NULL) {
        (void)snprintf(stage->why, PORT_WHY, "memory: exhausted");
        return TIA_ERR_MEMORY;
    }
    return TIA_OK;
}

static int fit(struct stage *stage)
{
    choose_turn(stage);
    struct turn turned = turn_back(&stage->turn);
    if (turned.width > stage->mode.width || turned.height > stage->mode.height) {
        (void)snprintf(stage->why, PORT_WHY, "%s: a picture of %ux%u does not fit its %ux%u (use a smaller --size)",
                       stage->name, turned.width, turned.height, stage->mode.width, stage->mode.height);
        return TIA_ERR_UNSUPPORTED;
    }
    stage->place = (struct tia_tile){(uint16_t)((stage->mode.width - turned.width) / 2),
                                     (uint16_t)((stage->mode.height - turned.height) / 2), (uint16_t)turned.width,
                                     (uint16_t)turned.height};
    return choose_frame(stage);
}

/* The mode that the viewer sees. */
static void tell_mode(const struct stage *stage, struct tia_mode *mode)
{
    bool swaps = turn_swaps(stage->degrees);
    *mode = stage->mode;
    mode->width = (uint16_t)stage->turn.width;
    mode->height = (uint16_t)stage->turn.height;
    mode->tile_width = swaps ? stage->mode.tile_height : stage->mode.tile_width;
    mode->tile_height = swaps ? stage->mode.tile_width : stage->mode.tile_height;
}

static int stage_open(void *ctx, struct tia_mode *mode)
{
    struct stage *stage = ctx;
    int status = stage->screen->open(stage->screen_ctx, &stage->mode);
    if (status != TIA_OK) {
        return status;
    }
    stage->opened = true;
    status = fit(stage);
    if (status != TIA_OK) {
        stage->screen->close(stage->screen_ctx);
        return status;
    }
    tell_mode(stage, mode);
    return TIA_OK;
}

/* A window that has become too small for the picture shows nothing until it is large enough. */
static int stage_mode(void *ctx, struct tia_mode *mode)
{
    struct stage *stage = ctx;
    struct tia_mode now;
    int status = stage->screen->mode(stage->screen_ctx, &now);
    if (status != TIA_OK) {
        return status;
    }
    bool changed = now.width != stage->mode.width || now.height != stage->mode.height;
    stage->mode = now;
    status = changed || stage->place.width == 0 ? fit(stage) : TIA_OK;
    if (status == TIA_ERR_UNSUPPORTED) {
        stage->place.width = 0;
        return TIA_HIDDEN;
    }
    tell_mode(stage, mode);
    return status;
}

/* ---- pixels ---- */

/* Where a tile of the picture lies on the screen. */
static struct tia_tile on_screen(const struct stage *stage, struct tia_tile tile)
{
    struct tia_tile place = turn_tile(&stage->turn, tile);
    place.x = (uint16_t)(place.x + stage->place.x);
    place.y = (uint16_t)(place.y + stage->place.y);
    return place;
}

/* The frame's own memory under a rectangle of the screen. */
static tia_rgb565 *in_frame(const struct stage *stage, struct tia_tile place)
{
    size_t x = (size_t)(place.x - stage->place.x), y = (size_t)(place.y - stage->place.y);
    return stage->frame + y * stage->place.width + x;
}

static int stage_acquire(void *ctx, struct tia_tile tile, struct tia_surface *surface)
{
    struct stage *stage = ctx;
    struct tia_tile place = on_screen(stage, tile);
    struct tia_surface under;
    if (stage->checksum) {
        under = (struct tia_surface){in_frame(stage, place), sizeof(tia_rgb565),
                                     (ptrdiff_t)(stage->place.width * sizeof(tia_rgb565))};
    } else {
        int status = stage->screen->acquire(stage->screen_ctx, place, &under);
        if (status != TIA_OK) {
            return status;
        }
    }
    *surface = turn_surface(&stage->turn, &under, place.width, place.height);
    return TIA_OK;
}

/* Rows of pixels, or of black where `from` is NULL, into a surface of the screen. */
static void put(const struct tia_surface *surface, struct tia_tile tile, const tia_rgb565 *from, size_t from_width)
{
    for (unsigned y = 0; y < tile.height; y++) {
        char *at = (char *)surface->pixels + (ptrdiff_t)y * surface->pitch;
        for (unsigned x = 0; x < tile.width; x++, at += surface->step) {
            *(tia_rgb565 *)(void *)at = from != NULL ? from[y * from_width + x] : 0;
        }
    }
}

static int put_tile(struct stage *stage, struct tia_tile place, const tia_rgb565 *from)
{
    struct tia_surface surface;
    int status = stage->screen->acquire(stage->screen_ctx, place, &surface);
    if (status != TIA_OK) {
        return status;
    }
    put(&surface, place, from, stage->place.width);
    return stage->screen->submit(stage->screen_ctx, place);
}

static int stage_submit(void *ctx, struct tia_tile tile)
{
    struct stage *stage = ctx;
    struct tia_tile place = on_screen(stage, tile);
    if (stage->checksum) {
        return put_tile(stage, place, in_frame(stage, place));
    }
    return stage->screen->submit(stage->screen_ctx, place);
}

/* ---- the frame ---- */

static int blacken(struct stage *stage, struct tia_tile area)
{
    unsigned tile_width = stage->mode.tile_width != 0 ? stage->mode.tile_width : area.width;
    unsigned tile_height = stage->mode.tile_height != 0 ? stage->mode.tile_height : area.height;
    for (unsigned y = 0; y < area.height; y += tile_height) {
        for (unsigned x = 0; x < area.width; x += tile_width) {
            unsigned width = area.width - x, height = area.height - y;
            struct tia_tile tile = {(uint16_t)(area.x + x), (uint16_t)(area.y + y),
                                    (uint16_t)(width < tile_width ? width : tile_width),
                                    (uint16_t)(height < tile_height ? height : tile_height)};
            int status = put_tile(stage, tile, NULL);
            if (status != TIA_OK) {
                return status;
            }
        }
    }
    return TIA_OK;
}

/* Around the picture, on every frame: what a display's memory holds before is not defined. */
static int draw_border(struct stage *stage)
{
    struct tia_tile place = stage->place;
    unsigned right = (unsigned)place.x + place.width, below = (unsigned)place.y + place.height;
    const struct tia_tile border[] = {
        {0, 0, stage->mode.width, place.y},
        {0, place.y, place.x, place.height},
        {(uint16_t)right, place.y, (uint16_t)(stage->mode.width - right), place.height},
        {0, (uint16_t)below, stage->mode.width, (uint16_t)(stage->mode.height - below)},
    };
    int status = TIA_OK;
    for (unsigned i = 0; i < 4 && status == TIA_OK; i++) {
        status = border[i].width > 0 && border[i].height > 0 ? blacken(stage, border[i]) : TIA_OK;
    }
    return status;
}

static int stage_present(void *ctx)
{
    struct stage *stage = ctx;
    int status = draw_border(stage);
    if (status != TIA_OK) {
        return status;
    }
    if (stage->checksum) {
        stage->crc = tia_crc32(0, stage->frame, (size_t)stage->place.width * stage->place.height);
    }
    return stage->screen->present(stage->screen_ctx);
}

static void stage_close(void *ctx)
{
    struct stage *stage = ctx;
    stage->screen->close(stage->screen_ctx);
    free(stage->frame);
    stage->frame = NULL;
}

const struct tia_display stage_display = {stage_open,   stage_mode,    stage_acquire,
                                          stage_submit, stage_present, stage_close};
