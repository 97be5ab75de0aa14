#include "drm.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <xf86drm.h>

#include "console/console.h"
#include "console/guardian.h"
#include "console/node.h"
#include "pixels/changes.h"
#include "scanout.h"

struct drm {
    struct port_wish wish;
    struct card card;
    struct scanout scanout;
    const drmModeConnector *connector; /* one of the card's connectors */
    bool direct;                       /* frames are drawn straight into the buffers */
    struct canvas canvas;              /* if not direct: frames are drawn here, then expanded */
    struct changes changes;            /* what the buffers lack of the canvas */
    struct expander expander;
    char format[PIXEL_NAME];
    struct console_listener listener;
    bool lost; /* the screen could not be taken back from another program */
};

/* ---- switching to another console and back ---- */

static void leave(void *arg)
{
    struct drm *d = arg;

    scanout_settle(&d->scanout);
    (void)drmDropMaster(d->card.fd);
}

static void enter(void *arg)
{
    struct drm *d = arg;

    d->lost = drmSetMaster(d->card.fd) != 0 || scanout_relight(&d->scanout) != 0;
    if (d->lost)
        (void)card_failed(&d->card, "the screen cannot be taken back", d->wish.why);
}

/* ---- open and close ---- */

static void drm_close(void *ctx)
{
    struct drm *d = ctx;

    if (d->card.fd < 0)
        return;
    console_ignore(&d->listener);
    scanout_end(&d->scanout);
    (void)drmDropMaster(d->card.fd);
    guardian_forget_card(d->card.fd);
    card_close(&d->card);
    console_close();
    changes_free(&d->changes);
    canvas_free(&d->canvas);
}

/* Opens a card that has a screen, and becomes its master. False with the reason in `why`. */
static bool open_card(struct drm *d, const char *path, char why[PORT_WHY])
{
    const struct drm_parts *parts = &d->card.parts;
    char reason[PORT_WHY];

    if (card_open(&d->card, path, why))
        return false;
    d->connector = pick_connector(parts, d->wish.connector, reason);
    if (!d->connector)
        (void)snprintf(why, PORT_WHY, "%s: %.180s", path, reason);
    else if (pick_crtc(parts, d->connector) == 0)
        (void)snprintf(why, PORT_WHY, "%s: connector %s: no CRTC is free for it", path,
                       pick_name(d->connector, reason));
    else if (!card_become_master(&d->card, why))
        return true;
    card_close(&d->card);
    return false;
}

/* Tries a card; true if it works. wish.why receives the reason for the first failure. */
static bool try_card(void *arg, const char *path)
{
    struct drm *d = arg;
    char why[PORT_WHY];

    if (open_card(d, path, why))
        return true;
    if (d->wish.why[0] == '\0')
        (void)snprintf(d->wish.why, PORT_WHY, "%s", why);
    return false;
}

static int find_card(struct drm *d)
{
    d->wish.why[0] = '\0';
    if (d->wish.device)
        (void)try_card(d, d->wish.device);
    else if (node_each(CARD, CARDS, try_card, d) == 0)
        (void)snprintf(d->wish.why, PORT_WHY, CARD "0: no such device (this kernel has no DRM driver loaded)");
    return d->card.fd >= 0 ? TIA_OK : TIA_ERR_DEVICE;
}

/* Prepares drawing into the buffers or the canvas. DRM's formats are little-endian on every processor. */
static int prepare_drawing(struct drm *d)
{
    const uint16_t one = 1;
    struct pixel_format format = *d->scanout.format.pixel;

    format.swapped = *(const uint8_t *)&one != 1;
    (void)pixel_name(&format, d->format);
    d->direct = pixel_is_rgb565(&format) && !d->scanout.copied;
    expander_init(&d->expander, &format);
    if (!d->direct && (canvas_resize(&d->canvas, d->scanout.mode.hdisplay, d->scanout.mode.vdisplay) ||
                       changes_resize(&d->changes, &d->canvas))) {
        (void)snprintf(d->wish.why, PORT_WHY, "%s: no memory for a frame", d->card.path);
        return TIA_ERR_MEMORY;
    }
    return TIA_OK;
}

static void describe(const struct drm *d, struct tia_mode *mode)
{
    *mode = (struct tia_mode){
        .width = d->scanout.mode.hdisplay,
        .height = d->scanout.mode.vdisplay,
        .concurrent = true,
        .format = d->format,
    };
}

static int drm_open(void *ctx, struct tia_mode *mode)
{
    struct drm *d = ctx;
    int status = find_card(d);

    if (!status)
        status = console_open(false, d->wish.why);
    if (status) {
        card_close(&d->card);
        return status;
    }
    status = scanout_light(&d->scanout, &d->card, d->connector, d->wish.mode, d->wish.why);
    if (!status)
        status = prepare_drawing(d);
    if (status) {
        drm_close(d);
        return status;
    }
    d->lost = false;
    (void)guardian_keep_card(d->card.fd);
    console_listen(&d->listener);
    describe(d, mode);
    return TIA_OK;
}

/* ---- a frame ---- */

/* Checks that the screen is still plugged in. Reads the last state that the kernel knows, since probing the connector
 * takes a while. */
static int check_connector(struct drm *d)
{
    drmModeConnector *c = drmModeGetConnectorCurrent(d->card.fd, d->scanout.connector);
    bool there = c && c->connection != DRM_MODE_DISCONNECTED;
    char name[PICK_NAME];

    if (!there)
        (void)snprintf(d->wish.why, PORT_WHY, "%s: connector %s: its screen was unplugged", d->card.path,
                       pick_name(d->connector, name));
    if (!c && errno == ENODEV)
        (void)card_failed(&d->card, "the device is gone", d->wish.why);
    drmModeFreeConnector(c);
    return there ? TIA_OK : TIA_ERR_DEVICE;
}

static int drm_mode(void *ctx, struct tia_mode *mode)
{
    struct drm *d = ctx;

    /* A program without input never waits, so console switches are handled here. */
    if (d->card.fd < 0 || console_wait(NULL, 0, 0) < 0)
        return TIA_ERR_DEVICE;
    describe(d, mode);
    if (console_state() != CONSOLE_OURS)
        return TIA_HIDDEN;
    return d->lost ? TIA_ERR_DEVICE : check_connector(d);
}

static int drm_acquire(void *ctx, struct tia_tile tile, struct tia_surface *surface)
{
    struct drm *d = ctx;
    const struct card_buffer *b = &d->scanout.buffers[scanout_drawn(&d->scanout)];

    if (d->card.fd < 0)
        return TIA_ERR_DEVICE;
    if (!d->direct)
        return canvas_tile(&d->canvas, tile, surface);
    if (!tile_inside(tile, d->scanout.mode.hdisplay, d->scanout.mode.vdisplay))
        return TIA_ERR_ARGUMENT;
    *surface = (struct tia_surface){.pixels = (tia_rgb565 *)(void *)(b->map + (size_t)tile.y * b->pitch) + tile.x,
                                    .step = sizeof(tia_rgb565),
                                    .pitch = (ptrdiff_t)b->pitch};
    return TIA_OK;
}

static int drm_submit(void *ctx, struct tia_tile tile)
{
    struct drm *d = ctx;

    if (d->card.fd < 0)
        return TIA_ERR_DEVICE;
    return tile_inside(tile, d->scanout.mode.hdisplay, d->scanout.mode.vdisplay) ? TIA_OK : TIA_ERR_ARGUMENT;
}

/* Copies what the buffer lacks of the canvas; returns the number of rectangles. */
static unsigned copy(struct drm *d, drmModeClip clips[CHANGES_BANDS])
{
    int buffer = scanout_drawn(&d->scanout);
    const struct card_buffer *b = &d->scanout.buffers[buffer];
    size_t bytes = pixel_bytes(&d->expander.format);
    struct tia_tile area;
    unsigned count = 0;

    changes_find(&d->changes, &d->canvas);
    for (unsigned band = 0; band < d->changes.bands; band++) {
        if (!changes_take(&d->changes, (unsigned)buffer, band, &area))
            continue;
        uint8_t *to = (uint8_t *)b->map + (size_t)area.y * b->pitch + area.x * bytes;
        const tia_rgb565 *from = d->canvas.pixels + (size_t)area.y * d->canvas.width + area.x;
        for (unsigned y = 0; y < area.height; y++, to += b->pitch, from += d->canvas.width)
            expand_row(&d->expander, to, from, area.width);
        clips[count++] =
            (drmModeClip){area.x, area.y, (uint16_t)(area.x + area.width), (uint16_t)(area.y + area.height)};
    }
    return count;
}

static int drm_present(void *ctx)
{
    struct drm *d = ctx;
    drmModeClip clips[CHANGES_BANDS];
    unsigned count;

    if (d->card.fd < 0)
        return TIA_ERR_DEVICE;
    if (console_state() != CONSOLE_OURS)
        return TIA_HIDDEN;
    if (d->direct)
        return scanout_swap(&d->scanout, NULL, 0, d->wish.why);
    count = copy(d, clips);
    return scanout_swap(&d->scanout, clips, count, d->wish.why);
}

const struct tia_display port_drm_display = {
    .open = drm_open,
    .mode = drm_mode,
    .acquire = drm_acquire,
    .submit = drm_submit,
    .present = drm_present,
    .close = drm_close,
};

void *port_drm_create(const struct port_wish *wish)
{
    struct drm *d = calloc(1, sizeof *d);

    if (!d) {
        (void)snprintf(wish->why, PORT_WHY, "drm: out of memory");
        return NULL;
    }
    d->wish = *wish;
    d->card.fd = -1;
    d->listener = (struct console_listener){.enter = enter, .leave = leave, .arg = d};
    return d;
}

void port_drm_destroy(void *ctx)
{
    drm_close(ctx);
    free(ctx);
}
