/* spi_panel.c - see spi_panel.h. Commands and pauses follow the ILI9341's data sheet (8.2); the ST7735 and ST7789
 * have the same. */
#include "spi_panel.h"

enum {
    SWRESET = 0x01,
    SLPIN = 0x10,
    SLPOUT = 0x11,
    INVON = 0x21,
    DISPOFF = 0x28,
    DISPON = 0x29,
    CASET = 0x2a,
    PASET = 0x2b,
    RAMWR = 0x2c,
    MADCTL = 0x36,
    COLMOD = 0x3a,
    COLMOD_RGB565 = 0x55,
    RESET_MS = 120, /* from SWRESET to SLPOUT */
    WAKE_MS = 120   /* from SLPOUT until the supplies are stable */
};

static int failed(struct tia_spi_panel *panel, const char *why)
{
    panel->why = why;
    return TIA_ERR_DEVICE;
}

static int send_command(struct tia_spi_panel *panel, uint8_t command)
{
    if (panel->ops->command(panel->bus, command) != 0)
        return failed(panel, "spi panel: the bus refused a command (check its wiring)");
    return TIA_OK;
}

static int send_data(struct tia_spi_panel *panel, const uint8_t *bytes, size_t count)
{
    if (count && panel->ops->data(panel->bus, bytes, count) != 0)
        return failed(panel, "spi panel: the bus refused data (check its wiring)");
    return TIA_OK;
}

static int send(struct tia_spi_panel *panel, uint8_t command, const uint8_t *parameters, size_t count)
{
    int status = send_command(panel, command);
    return !status ? send_data(panel, parameters, count) : status;
}

static void pause_ms(const struct tia_spi_panel *panel, unsigned ms)
{
    uint64_t start = panel->clock->now_us(panel->clock_ctx);
    while (panel->clock->now_us(panel->clock_ctx) - start < (uint64_t)ms * 1000) {
    }
}

/* Sends CASET or PASET with the first and the last column or row, high byte first. The bytes are in *panel, not on the
 * stack, because the bus may still be sending them when this returns. They are changed only after `command`, which
 * waits for the previous data. */
static int send_range(struct tia_spi_panel *panel, uint8_t command, unsigned first, unsigned count)
{
    unsigned last = first + count - 1;
    int status = send_command(panel, command);
    if (status)
        return status;
    panel->range[0] = (uint8_t)(first >> 8);
    panel->range[1] = (uint8_t)first;
    panel->range[2] = (uint8_t)(last >> 8);
    panel->range[3] = (uint8_t)last;
    return send_data(panel, panel->range, sizeof panel->range);
}

static int send_setup(struct tia_spi_panel *panel)
{
    const uint8_t *next = panel->setup, *end = next ? next + panel->setup_size : next;
    int status = TIA_OK;
    while (!status && end - next >= 2) {
        if (end - next - 2 < next[1]) {
            panel->why = "spi panel: the setup table ends inside a command";
            return TIA_ERR_ARGUMENT;
        }
        status = send(panel, next[0], next + 2, next[1]);
        next += 2 + next[1];
    }
    return status;
}

static int wake(struct tia_spi_panel *panel)
{
    static const uint8_t format = COLMOD_RGB565;
    int status = send(panel, SWRESET, NULL, 0);
    pause_ms(panel, RESET_MS);
    if (!status)
        status = send(panel, SLPOUT, NULL, 0);
    pause_ms(panel, WAKE_MS);
    if (!status)
        status = send(panel, COLMOD, &format, 1);
    if (!status)
        status = send(panel, MADCTL, &panel->orientation, 1);
    if (!status && panel->inverted)
        status = send(panel, INVON, NULL, 0);
    return !status ? send_setup(panel) : status;
}

static int panel_mode(void *ctx, struct tia_mode *mode)
{
    const struct tia_spi_panel *panel = ctx;
    *mode = (struct tia_mode){
        .width = panel->width,
        .height = panel->height,
        .tile_width = panel->across,
        .tile_height = panel->rows,
        .format = "RGB565 big-endian",
    };
    return TIA_OK;
}

static int panel_open(void *ctx, struct tia_mode *mode)
{
    struct tia_spi_panel *panel = ctx;
    uint16_t across = panel->columns && panel->columns < panel->width ? panel->columns : panel->width;
    size_t rows = across ? panel->strips_size / 2 / (2u * across) : 0;
    if (rows == 0 || panel->height == 0) {
        panel->why = "spi panel: no room for two rows (give more strips_size)";
        return TIA_ERR_ARGUMENT;
    }
    panel->across = across;
    panel->rows = rows < panel->height ? (uint16_t)rows : panel->height;
    panel->strip = 0;
    panel->shown = false;
    panel->awake = true;
    int status = wake(panel);
    return !status ? panel_mode(ctx, mode) : status;
}

static tia_rgb565 *strip(const struct tia_spi_panel *panel)
{
    return panel->strips + (size_t)panel->strip * panel->rows * panel->across;
}

static bool inside(const struct tia_spi_panel *panel, struct tia_tile tile)
{
    return tile.width && tile.height && tile.width <= panel->across && tile.x + tile.width <= panel->width &&
           tile.height <= panel->rows && tile.y + tile.height <= panel->height;
}

/* True if the processor's order is not the panel's. */
static bool is_low_first(void)
{
    const uint16_t one = 1;
    return *(const uint8_t *)&one == 1;
}

static int panel_acquire(void *ctx, struct tia_tile tile, struct tia_surface *surface)
{
    struct tia_spi_panel *panel = ctx;
    if (!inside(panel, tile)) {
        panel->why = "spi panel: the tile is larger than a strip or leaves the picture";
        return TIA_ERR_ARGUMENT;
    }
    *surface = (struct tia_surface){.pixels = strip(panel), .step = 2, .pitch = (ptrdiff_t)(2u * tile.width)};
#if TIA_SWAP
    surface->swap = is_low_first();
#endif
    return TIA_OK;
}

/* Puts pixels into the panel's byte order, high byte first, where tia has not written them so. */
static void put_in_order(tia_rgb565 *pixels, size_t count)
{
    if (TIA_SWAP || !is_low_first())
        return;
    for (size_t i = 0; i < count; i++)
        pixels[i] = (tia_rgb565)(pixels[i] << 8 | pixels[i] >> 8);
}

/* Sends pixels of the strip, which is not used until they are sent. The first command waits until the previous strip
 * has been sent, so that its buffer is free for the next acquire. */
static int send_pixels(struct tia_spi_panel *panel, struct tia_tile area, tia_rgb565 *pixels)
{
    put_in_order(pixels, (size_t)area.width * area.height);
    int status = send_range(panel, CASET, (unsigned)panel->left + area.x, area.width);
    if (!status)
        status = send_range(panel, PASET, (unsigned)panel->top + area.y, area.height);
    if (!status)
        status = send(panel, RAMWR, (const uint8_t *)pixels, (size_t)2 * area.width * area.height);
    if (!status)
        panel->strip ^= 1;
    return status;
}

static int panel_submit(void *ctx, struct tia_tile tile)
{
    struct tia_spi_panel *panel = ctx;
    return send_pixels(panel, tile, strip(panel));
}

/* Switches the panel on once it has a whole frame. */
static int panel_present(void *ctx)
{
    struct tia_spi_panel *panel = ctx;
    if (panel->shown)
        return TIA_OK;
    panel->shown = true;
    return send(panel, DISPON, NULL, 0);
}

static void panel_close(void *ctx)
{
    struct tia_spi_panel *panel = ctx;
    if (!panel->awake)
        return;
    panel->awake = false;
    (void)send(panel, DISPOFF, NULL, 0);
    (void)send(panel, SLPIN, NULL, 0);
}

const struct tia_display tia_spi_panel_display = {panel_open,    panel_mode,  panel_acquire, panel_submit,
                                                  panel_present, panel_close, NULL};

/* ---- only what has changed ---- */

static int changes_open(void *ctx, struct tia_mode *mode)
{
    struct tia_spi_panel *panel = ctx;
    panel->torn = false;
    if (tia_damage_init(&panel->damage, panel->shown_memory, panel->shown_size, panel->width, panel->height)) {
        panel->why = "spi panel: no memory for what is shown (give more shown_size)";
        return TIA_ERR_ARGUMENT;
    }
    return panel_open(ctx, mode);
}

/* Moves the pixels of an area together, which are rows of the tile. */
static tia_rgb565 *gather(tia_rgb565 *pixels, struct tia_tile tile, struct tia_tile area)
{
    const tia_rgb565 *from = pixels + (size_t)(area.y - tile.y) * tile.width + (area.x - tile.x);
    tia_rgb565 *to = pixels;
    if (area.width == tile.width)
        return pixels + (from - pixels);
    for (unsigned y = 0; y < area.height; y++, from += tile.width)
        for (unsigned x = 0; x < area.width; x++)
            *to++ = from[x];
    return pixels;
}

/* One area of a strip is sent, not several: before a second one the bus would wait for the first, and the next strip
 * would be drawn later. */
static int changes_submit(void *ctx, struct tia_tile tile)
{
    struct tia_spi_panel *panel = ctx;
    const struct tia_surface surface = {.pixels = strip(panel), .step = 2, .pitch = (ptrdiff_t)(2u * tile.width)};
    struct tia_tile area;
    if (!tia_damage_update(&panel->damage, tile, &surface, &area))
        return TIA_OK;
    int status = send_pixels(panel, area, gather(surface.pixels, tile, area));
    if (status) {
        tia_damage_forget(&panel->damage);
        panel->torn = true;
    }
    return status;
}

static int changes_present(void *ctx)
{
    struct tia_spi_panel *panel = ctx;
    if (!panel->torn)
        tia_damage_complete(&panel->damage);
    panel->torn = false;
    return panel_present(ctx);
}

const struct tia_display tia_spi_panel_changes = {changes_open,    panel_mode,  panel_acquire, changes_submit,
                                                  changes_present, panel_close, NULL};
