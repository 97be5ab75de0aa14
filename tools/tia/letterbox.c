#include "letterbox.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <tia/debug.h>

#include "common/signals.h"
#include "label.h"
#include "ports.h"

/* ---- size and position ---- */

static uint16_t at_most(uint16_t value, uint16_t limit)
{
    return value < limit ? value : limit;
}

static bool has_frame(const struct letterbox *letterbox)
{
    return letterbox->checksum || letterbox->keeps;
}

/* Chooses the picture's size: the user's, or that of the screen. */
static void choose_rotation(struct letterbox *letterbox)
{
    bool swaps = rotation_swaps(letterbox->degrees);
    uint16_t width = at_most(swaps ? letterbox->mode.height : letterbox->mode.width, TIA_SIZE_MAX);
    uint16_t height = at_most(swaps ? letterbox->mode.width : letterbox->mode.height, TIA_SIZE_MAX);
    letterbox->rotation.degrees = letterbox->degrees;
    letterbox->rotation.width = letterbox->width != 0 ? letterbox->width : width;
    letterbox->rotation.height = letterbox->height != 0 ? letterbox->height : height;
}

static int choose_frame(struct letterbox *letterbox)
{
    if (!has_frame(letterbox))
        return TIA_OK;
    free(letterbox->frame);
    letterbox->shown = false;
    letterbox->frame = malloc((size_t)letterbox->place.width * letterbox->place.height * sizeof *letterbox->frame);
    if (!letterbox->frame) {
        (void)snprintf(letterbox->why, PORT_WHY, "memory: exhausted");
        return TIA_ERR_MEMORY;
    }
    return TIA_OK;
}

static int fit(struct letterbox *letterbox)
{
    choose_rotation(letterbox);
    struct rotation rotated = rotation_inverse(&letterbox->rotation);
    if (rotated.width > letterbox->mode.width || rotated.height > letterbox->mode.height) {
        (void)snprintf(letterbox->why, PORT_WHY, "%s: a picture of %ux%u does not fit its %ux%u (use a smaller --size)",
                       letterbox->name, rotated.width, rotated.height, letterbox->mode.width, letterbox->mode.height);
        return TIA_ERR_UNSUPPORTED;
    }
    letterbox->place = (struct tia_tile){(uint16_t)((letterbox->mode.width - rotated.width) / 2),
                                         (uint16_t)((letterbox->mode.height - rotated.height) / 2),
                                         (uint16_t)rotated.width, (uint16_t)rotated.height};
    return choose_frame(letterbox);
}

/* Gives the mode of the picture, for the viewer. */
static void get_picture_mode(const struct letterbox *letterbox, struct tia_mode *mode)
{
    bool swaps = rotation_swaps(letterbox->degrees);
    *mode = letterbox->mode;
    mode->width = (uint16_t)letterbox->rotation.width;
    mode->height = (uint16_t)letterbox->rotation.height;
    mode->tile_width = swaps ? letterbox->mode.tile_height : letterbox->mode.tile_width;
    mode->tile_height = swaps ? letterbox->mode.tile_width : letterbox->mode.tile_height;
}

static int letterbox_open(void *ctx, struct tia_mode *mode)
{
    struct letterbox *letterbox = ctx;
    int status = letterbox->screen->open(letterbox->screen_ctx, &letterbox->mode);
    if (status)
        return status;
    letterbox->opened = true;
    status = fit(letterbox);
    if (status) {
        letterbox->screen->close(letterbox->screen_ctx);
        return status;
    }
    get_picture_mode(letterbox, mode);
    return TIA_OK;
}

/* Gives the picture's mode. TIA_HIDDEN: a window has become too small for the picture. */
static int letterbox_mode(void *ctx, struct tia_mode *mode)
{
    struct letterbox *letterbox = ctx;
    struct tia_mode now;
    int status = letterbox->screen->mode(letterbox->screen_ctx, &now);
    bool busy = status == TIA_BUSY;
    if (status && !busy)
        return status;
    bool changed = now.width != letterbox->mode.width || now.height != letterbox->mode.height;
    letterbox->mode = now;
    status = changed || letterbox->place.width == 0 ? fit(letterbox) : TIA_OK;
    if (status == TIA_ERR_UNSUPPORTED) {
        letterbox->place.width = 0;
        return TIA_HIDDEN;
    }
    get_picture_mode(letterbox, mode);
    return !status && busy ? TIA_BUSY : status;
}

/* ---- pixels ---- */

/* Returns the rectangle of the screen that shows a tile of the picture. */
static struct tia_tile on_screen(const struct letterbox *letterbox, struct tia_tile tile)
{
    struct tia_tile place = rotation_tile(&letterbox->rotation, tile);
    place.x = (uint16_t)(place.x + letterbox->place.x);
    place.y = (uint16_t)(place.y + letterbox->place.y);
    return place;
}

/* Returns the part of letterbox->frame for a rectangle of the screen. */
static tia_rgb565 *in_frame(const struct letterbox *letterbox, struct tia_tile place)
{
    size_t x = (size_t)(place.x - letterbox->place.x), y = (size_t)(place.y - letterbox->place.y);
    return letterbox->frame + y * letterbox->place.width + x;
}

static int letterbox_acquire(void *ctx, struct tia_tile tile, struct tia_surface *surface)
{
    struct letterbox *letterbox = ctx;
    struct tia_tile place = on_screen(letterbox, tile);
    struct tia_surface under = {.pixels = NULL};
    if (has_frame(letterbox)) {
        under = (struct tia_surface){.pixels = in_frame(letterbox, place),
                                     .step = sizeof(tia_rgb565),
                                     .pitch = (ptrdiff_t)(letterbox->place.width * sizeof(tia_rgb565))};
    } else {
        int status = letterbox->screen->acquire(letterbox->screen_ctx, place, &under);
        if (status)
            return status;
    }
    *surface = rotation_surface(&letterbox->rotation, &under, place.width, place.height);
    return TIA_OK;
}

/* Writes a pixel in the surface's byte order. */
static void put_pixel(const struct tia_surface *surface, char *at, tia_rgb565 pixel)
{
#if TIA_SWAP
    if (surface->swap)
        pixel = (tia_rgb565)(pixel << 8 | pixel >> 8);
#else
    (void)surface;
#endif
    *(tia_rgb565 *)(void *)at = pixel;
}

/* Copies rows of pixels, or black if `from` is NULL, to a surface of the screen. */
static void put(const struct tia_surface *surface, struct tia_tile tile, const tia_rgb565 *from, size_t from_width)
{
    for (unsigned y = 0; y < tile.height; y++) {
        char *at = (char *)surface->pixels + (ptrdiff_t)y * surface->pitch;
        for (unsigned x = 0; x < tile.width; x++, at += surface->step)
            put_pixel(surface, at, from ? from[y * from_width + x] : 0);
    }
}

static int put_tile(struct letterbox *letterbox, struct tia_tile place, const tia_rgb565 *from)
{
    struct tia_surface surface = {.pixels = NULL};
    int status = letterbox->screen->acquire(letterbox->screen_ctx, place, &surface);
    if (status)
        return status;
    put(&surface, place, from, letterbox->place.width);
    return letterbox->screen->submit(letterbox->screen_ctx, place);
}

static int letterbox_submit(void *ctx, struct tia_tile tile)
{
    struct letterbox *letterbox = ctx;
    struct tia_tile place = on_screen(letterbox, tile);
    if (letterbox->drawn)
        letterbox->drawn(letterbox->drawn_ctx, (uint64_t)tile.width * tile.height);
    if (has_frame(letterbox))
        return put_tile(letterbox, place, in_frame(letterbox, place));
    return letterbox->screen->submit(letterbox->screen_ctx, place);
}

/* ---- the frame ---- */

static int blacken(struct letterbox *letterbox, struct tia_tile area)
{
    unsigned tile_width = letterbox->mode.tile_width != 0 ? letterbox->mode.tile_width : area.width;
    unsigned tile_height = letterbox->mode.tile_height != 0 ? letterbox->mode.tile_height : area.height;
    for (unsigned y = 0; y < area.height; y += tile_height) {
        for (unsigned x = 0; x < area.width; x += tile_width) {
            unsigned width = area.width - x, height = area.height - y;
            struct tia_tile tile = {(uint16_t)(area.x + x), (uint16_t)(area.y + y),
                                    (uint16_t)(width < tile_width ? width : tile_width),
                                    (uint16_t)(height < tile_height ? height : tile_height)};
            int status = put_tile(letterbox, tile, NULL);
            if (status)
                return status;
        }
    }
    return TIA_OK;
}

/* Draws black around the picture in every frame, since the display does not preserve its memory between frames. */
static int draw_border(struct letterbox *letterbox)
{
    struct tia_tile place = letterbox->place;
    unsigned right = (unsigned)place.x + place.width, below = (unsigned)place.y + place.height;
    const struct tia_tile border[] = {
        {0, 0, letterbox->mode.width, place.y},
        {0, place.y, place.x, place.height},
        {(uint16_t)right, place.y, (uint16_t)(letterbox->mode.width - right), place.height},
        {0, (uint16_t)below, letterbox->mode.width, (uint16_t)(letterbox->mode.height - below)},
    };
    int status = TIA_OK;
    for (unsigned i = 0; i < 4 && !status; i++)
        status = border[i].width > 0 && border[i].height > 0 ? blacken(letterbox, border[i]) : TIA_OK;
    return status;
}

static int label_tile(struct letterbox *letterbox, struct tia_tile tile)
{
    struct tia_tile place = on_screen(letterbox, tile);
    struct tia_surface under = {.pixels = NULL};
    int status = letterbox->screen->acquire(letterbox->screen_ctx, place, &under);
    if (status)
        return status;
    struct tia_surface surface = rotation_surface(&letterbox->rotation, &under, place.width, place.height);
    struct tia_text text = label_text(letterbox->label, letterbox->rotation.height);
    tia_text_draw(&text, tile, &surface);
    return letterbox->screen->submit(letterbox->screen_ctx, place);
}

/* Draws the label, one row of the picture at a time, in pieces of the screen's tile size. */
static int draw_label(struct letterbox *letterbox)
{
    struct tia_text text = label_text(letterbox->label, letterbox->rotation.height);
    struct tia_tile area = tia_text_area(&text, letterbox->rotation.width, letterbox->rotation.height);
    struct tia_mode mode;
    int status = TIA_OK;

    get_picture_mode(letterbox, &mode);
    unsigned step = mode.tile_width != 0 ? mode.tile_width : area.width;
    for (unsigned y = 0; letterbox->label[0] != '\0' && y < area.height; y++)
        for (unsigned x = 0; x < area.width && !status; x += step) {
            unsigned left = area.width - x;
            status = label_tile(letterbox,
                                (struct tia_tile){(uint16_t)x, (uint16_t)y, (uint16_t)(left < step ? left : step), 1});
        }
    return status;
}

/* Computes the CRC of the frame. The largest frame takes so long that signals must be polled. */
static int compute_crc(struct letterbox *letterbox)
{
    const size_t width = letterbox->place.width;
    uint32_t crc = 0;
    for (size_t y = 0; y < letterbox->place.height; y++) {
        crc = tia_crc32(crc, letterbox->frame + y * width, width);
        if (y % 256 == 255 && signals_asked(NULL))
            return TIA_STOPPED;
    }
    letterbox->crc = crc;
    return TIA_OK;
}

static int letterbox_present(void *ctx)
{
    struct letterbox *letterbox = ctx;
    int status = draw_border(letterbox);
    if (!status && letterbox->checksum)
        status = compute_crc(letterbox);
    if (!status && letterbox->set_text)
        letterbox->set_text(letterbox->screen_ctx, letterbox->text);
    else if (!status)
        status = draw_label(letterbox);
    letterbox->shown = letterbox->shown || !status;
    if (letterbox->drawn)
        letterbox->drawn(letterbox->drawn_ctx, 0);
    return status ? status : letterbox->screen->present(letterbox->screen_ctx);
}

static int letterbox_go_on(void *ctx)
{
    const struct letterbox *letterbox = ctx;
    return letterbox->screen->go_on(letterbox->screen_ctx);
}

static void letterbox_close(void *ctx)
{
    struct letterbox *letterbox = ctx;
    letterbox->screen->close(letterbox->screen_ctx);
    free(letterbox->frame);
    letterbox->frame = NULL;
}

const struct tia_display letterbox_display = {
    .open = letterbox_open,
    .mode = letterbox_mode,
    .acquire = letterbox_acquire,
    .submit = letterbox_submit,
    .present = letterbox_present,
    .close = letterbox_close,
    .go_on = letterbox_go_on,
};
