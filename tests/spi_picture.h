/* spi_picture.h - pictures of the built-in scene, a panel that receives what has changed of them, and the bytes that
 * this takes, computed from whole pictures. */
#ifndef TESTS_SPI_PICTURE_H
#define TESTS_SPI_PICTURE_H

#include "spi_model.h"

enum { W = 320, H = 240, PIXELS = W * H };

static tia_rgb565 picture[PIXELS], before[PIXELS];
static uint16_t shown[PIXELS];

/* Returns a panel whose strips have `rows` rows of `columns` pixels, and which keeps blocks of `block` pixels. */
static struct tia_spi_panel make_changing(unsigned columns, unsigned rows, unsigned block)
{
    struct tia_spi_panel panel = make_panel(W, H, TIA_SPI_PANEL_FLIP_COLUMNS | TIA_SPI_PANEL_SWAP_AXES);

    panel.columns = (uint16_t)(columns < W ? columns : 0);
    panel.strips_size = (size_t)2 * rows * columns * sizeof *strips;
    panel.shown_memory = shown;
    panel.shown_size = tia_damage_size(W, H, block);
    return panel;
}

/* ---- the picture ---- */

static void draw_picture(const struct tia_light *light)
{
    static uint64_t view_memory[1024], hits_memory[PIXELS + 64];
    const struct tia_tile all = {0, 0, W, H};
    const struct tia_surface surface = {.pixels = picture, .step = 2, .pitch = 2 * W};
    struct tia_view *view;
    struct tia_hits *hits;

    memcpy(before, picture, sizeof before);
    CHECK_EQ(tia_view_init(&view, view_memory, sizeof view_memory, &tia_thesis_scene, 1, W, H, NULL), TIA_OK);
    CHECK_EQ(tia_view_set_lights(view, light, light != NULL), TIA_OK);
    CHECK_EQ(tia_hits_init(&hits, hits_memory, sizeof hits_memory, view, all), TIA_OK);
    CHECK_EQ(tia_view_draw(view, hits, all, &surface, NULL), TIA_OK);
}

/* The picture with a key's light, moved by an arrow along x by -1 to 2 steps; drawn once. */
static void show_key(unsigned key, int moved)
{
    static tia_rgb565 drawn[4][4][PIXELS];
    static bool is_drawn[4][4];
    struct tia_light light = tia_thesis_scene.bindings[key].state;

    light.centre.x += moved * TIA_Q16(1);
    if (is_drawn[key][moved + 1]) {
        memcpy(before, picture, sizeof before);
        memcpy(picture, drawn[key][moved + 1], sizeof picture);
        return;
    }
    draw_picture(&light);
    memcpy(drawn[key][moved + 1], picture, sizeof picture);
    is_drawn[key][moved + 1] = true;
}

static bool is_still(unsigned y, unsigned x, unsigned block)
{
    for (unsigned i = x; i < x + block; i++)
        if (picture[y * W + i] != picture[y * W + x] || before[y * W + i] != picture[y * W + x])
            return false;
    return true;
}

/* Returns the bytes that the pictures' difference takes in strips: two for each pixel of the rectangle around what has
 * changed, and eleven for its place. */
static size_t bytes_of_change(unsigned columns, unsigned rows, unsigned block)
{
    size_t bytes = 0;

    for (unsigned n = 0; n < W / columns * (H / rows); n++) {
        unsigned x0 = n % (W / columns) * columns, y0 = n / (W / columns) * rows;
        unsigned left = W, right = 0, top = H, bottom = 0;
        for (unsigned y = y0; y < y0 + rows; y++)
            for (unsigned x = x0; x < x0 + columns; x += block)
                if (!is_still(y, x, block)) {
                    left = x < left ? x : left;
                    right = x + block > right ? x + block : right;
                    top = y < top ? y : top;
                    bottom = y + 1;
                }
        bytes += bottom ? 11 + 2 * (size_t)(right - left) * (bottom - top) : 0;
    }
    return bytes;
}

/* ---- the panel ---- */

static int send_tile(struct tia_spi_panel *panel, struct tia_tile tile)
{
    struct tia_surface surface;
    int status = tia_spi_panel_changes.acquire(panel, tile, &surface);

    for (unsigned y = 0; y < tile.height && !status; y++)
        for (unsigned x = 0; x < tile.width; x++)
            put_pixel_into(&surface, x, y, picture[(tile.y + y) * W + tile.x + x]);
    return status ? status : tia_spi_panel_changes.submit(panel, tile);
}

static int send_picture(struct tia_spi_panel *panel)
{
    int status = TIA_OK;

    for (unsigned y = 0; y < H; y += panel->rows)
        for (unsigned x = 0; x < W && !status; x += panel->across)
            status = send_tile(panel, (struct tia_tile){(uint16_t)x, (uint16_t)y, panel->across, panel->rows});
    return status ? status : tia_spi_panel_changes.present(panel);
}

/* Compares what the glass shows with the picture. */
static unsigned wrong_pixels(void)
{
    unsigned wrong = 0;

    finish_dma();
    for (unsigned y = 0; y < H; y++)
        for (unsigned x = 0; x < W; x++) /* rows of the picture are columns of the glass, from the right */
            wrong += model.memory[x * MEMORY_WIDTH + (MEMORY_WIDTH - 1 - y)] != picture[y * W + x];
    return wrong;
}

/* Sends the picture; returns the number of bytes. */
static size_t bytes_sent(struct tia_spi_panel *panel)
{
    size_t sent = model.sent;

    CHECK_EQ(send_picture(panel), TIA_OK);
    CHECK_EQ(wrong_pixels(), 0);
    return model.sent - sent;
}

#endif
