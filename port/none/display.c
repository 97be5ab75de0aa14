/* display.c - draws frames into memory and discards them: for checksums, statistics and tests. */
#include <stdio.h>
#include <stdlib.h>

#include "none.h"
#include "pixels/canvas.h"

#define DEFAULT_WIDTH 640
#define DEFAULT_HEIGHT 480

struct none_display {
    struct canvas canvas;
    uint16_t width, height;
    char *why;
};

static int none_mode(void *ctx, struct tia_mode *mode)
{
    struct none_display *none = ctx;

    *mode = (struct tia_mode){none->width, none->height, .concurrent = true, .format = "RGB565"};
    return TIA_OK;
}

static int none_open(void *ctx, struct tia_mode *mode)
{
    struct none_display *none = ctx;

    if (canvas_resize(&none->canvas, none->width, none->height)) {
        (void)snprintf(none->why, PORT_WHY, "none: no memory for %ux%u pixels", none->width, none->height);
        return TIA_ERR_MEMORY;
    }
    return none_mode(ctx, mode);
}

static int none_acquire(void *ctx, struct tia_tile tile, struct tia_surface *surface)
{
    return canvas_tile(&((struct none_display *)ctx)->canvas, tile, surface);
}

static int none_submit(void *ctx, struct tia_tile tile)
{
    const struct none_display *none = ctx;

    return tile_inside(tile, none->canvas.width, none->canvas.height) ? TIA_OK : TIA_ERR_ARGUMENT;
}

static int none_present(void *ctx)
{
    return ((struct none_display *)ctx)->canvas.pixels ? TIA_OK : TIA_ERR_ARGUMENT;
}

static void none_close(void *ctx)
{
    canvas_free(&((struct none_display *)ctx)->canvas);
}

const struct tia_display port_none_display = {
    .open = none_open,
    .mode = none_mode,
    .acquire = none_acquire,
    .submit = none_submit,
    .present = none_present,
    .close = none_close,
};

void *port_none_create(const struct port_wish *wish)
{
    struct none_display *none = calloc(1, sizeof *none);

    if (!none) {
        (void)snprintf(wish->why, PORT_WHY, "none: out of memory");
        return NULL;
    }
    none->width = wish->width ? wish->width : DEFAULT_WIDTH;
    none->height = wish->height ? wish->height : DEFAULT_HEIGHT;
    none->why = wish->why;
    return none;
}

void port_none_destroy(void *ctx)
{
    free(ctx);
}

void port_none_list(port_line *line, void *arg)
{
    line(arg, "any size, RGB565, shown nowhere");
}
