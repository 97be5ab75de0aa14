/* web.c - the display, input and clock of a page. */
#include "web.h"

#define HOST(name) __attribute__((import_module("host"), import_name(name)))

/* An event, in the layout that the script writes. */
struct host_event {
    int32_t kind, key, shift, drag, x, y;
    double time_us; /* time by host_now */
};

HOST("now") double host_now(void); /* returns microseconds */
HOST("look") int32_t host_look(void);
HOST("rest") int32_t host_rest(int32_t timeout_ms); /* returns 1 if the browser cannot suspend WebAssembly */
HOST("take") int32_t host_take(struct host_event *event);
HOST("show") void host_show(const tia_rgb565 *pixels, uint32_t width, uint32_t height, const struct web_frame *frame);
HOST("lines") void host_lines(const struct web_line *lines, uint32_t count);
HOST("share") void host_share(const struct web_share *share);
HOST("file_size") int32_t host_file_size(const char *name, uint32_t length);
HOST("file_read") void host_file_read(const char *name, uint32_t length, void *bytes);

/* ---- display ---- */

static int web_mode(void *ctx, struct tia_mode *mode)
{
    const struct web_screen *screen = ctx;

    *mode = (struct tia_mode){.width = screen->width, .height = screen->height, .format = "RGB565"};
    return TIA_OK;
}

static int web_acquire(void *ctx, struct tia_tile tile, struct tia_surface *surface)
{
    const struct web_screen *screen = ctx;
    ptrdiff_t pitch = (ptrdiff_t)(screen->width * sizeof *screen->pixels);

    *surface = (struct tia_surface){.pixels = screen->pixels + (size_t)tile.y * screen->width + tile.x,
                                    .step = sizeof *screen->pixels,
                                    .pitch = pitch};
    return TIA_OK;
}

static int web_submit(void *ctx, struct tia_tile tile)
{
    (void)ctx;
    (void)tile;
    return TIA_OK;
}

/* Does nothing: web_show passes the picture to the script, with its data. */
static int web_present(void *ctx)
{
    (void)ctx;
    return TIA_OK;
}

static void web_close(void *ctx)
{
    (void)ctx;
}

const struct tia_display web_display = {web_mode, web_mode, web_acquire, web_submit, web_present, web_close, NULL};

/* ---- input ---- */

static int web_open(void *ctx)
{
    (void)ctx;
    return TIA_OK;
}

/* Gives the next event. If there is none, host_look lets the script run, which may add one. */
static int web_poll(void *ctx, struct tia_event *event)
{
    struct host_event got;

    (void)ctx;
    if (!host_take(&got) && (!host_look() || !host_take(&got)))
        return 0;
    *event = (struct tia_event){.kind = (enum tia_event_kind)got.kind,
                                .key = (uint16_t)got.key,
                                .shift = got.shift != 0,
                                .drag = got.drag != 0,
                                .time_us = (uint64_t)got.time_us,
                                .x = got.x,
                                .y = got.y};
    return 1;
}

static int web_wait(void *ctx, int timeout_ms)
{
    struct web_screen *screen = ctx;

    screen->stays = host_rest(timeout_ms) != 0;
    return screen->stays ? TIA_STOPPED : TIA_OK;
}

const struct tia_input web_input = {web_open, web_poll, web_wait, web_close};

/* ---- clock, files, pictures ---- */

static uint64_t now_us(void *ctx)
{
    (void)ctx;
    return (uint64_t)host_now();
}

const struct tia_clock web_clock = {now_us};

bool web_look(void)
{
    return host_look() != 0;
}

void web_show(const struct web_screen *screen, const struct web_frame *frame)
{
    host_show(screen->pixels, screen->width, screen->height, frame);
}

void web_draw_lines(const struct web_line *lines, unsigned count)
{
    host_lines(lines, count);
}

void web_share(const struct web_share *share)
{
    host_share(share);
}

int32_t web_file_size(const char *name, uint32_t length)
{
    return host_file_size(name, length);
}

void web_file_read(const char *name, uint32_t length, void *bytes)
{
    host_file_read(name, length, bytes);
}
