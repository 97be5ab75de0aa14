#include "fbdev.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>

#include "console/console.h"
#include "console/node.h"
#include "pixels/changes.h"
#include "screen.h"

#define DEVICE "/dev/fb"
#define DEVICES 32 /* FB_MAX of the kernel */

struct fbdev {
    const char *device; /* the requested device, or NULL */
    char *why;
    struct fb_screen screen;
    struct expander expander;
    struct console_listener listener;
    struct canvas frame;    /* the frame being drawn */
    struct changes changes; /* what the screen's pages lack of it */
    unsigned page;          /* the page that is shown */
    char format[PIXEL_NAME];
};

/* ---- copying the frame to the screen ---- */

/* Copies what a page lacks. Drivers of slow panels send the parts of the memory that were written. */
static void copy(struct fbdev *f, unsigned page)
{
    const struct fb_screen *s = &f->screen;
    size_t bytes = pixel_bytes(&s->format);
    struct tia_tile area;

    for (unsigned band = 0; band < f->changes.bands; band++) {
        if (!changes_take(&f->changes, page, band, &area))
            continue;
        uint8_t *to = fb_page(s, page) + (size_t)area.y * s->fix.line_length + area.x * bytes;
        const tia_rgb565 *from = f->frame.pixels + (size_t)area.y * f->frame.width + area.x;
        for (unsigned y = 0; y < area.height; y++, to += s->fix.line_length, from += f->frame.width)
            expand_row(&f->expander, to, from, area.width);
    }
}

/* The frame may be half drawn: the next one is copied whole. */
static void enter(void *arg)
{
    struct fbdev *f = arg;

    fb_show_again(&f->screen);
    changes_forget(&f->changes);
    copy(f, f->page);
    changes_forget(&f->changes);
}

/* Called when another program takes the screen. The frame stays in memory; meanwhile fbdev_mode returns TIA_HIDDEN. */
static void leave(void *arg)
{
    (void)arg;
}

/* ---- open and close ---- */

static void fbdev_close(void *ctx)
{
    struct fbdev *f = ctx;

    if (f->screen.fd < 0)
        return;
    console_ignore(&f->listener);
    fb_close(&f->screen, console_state() == CONSOLE_OURS);
    console_close();
    changes_free(&f->changes);
    canvas_free(&f->frame);
}

/* Tries a device; true if it works. f->why receives the reason for the first failure. */
static bool probe(void *arg, const char *path)
{
    struct fbdev *f = arg;
    char why[PORT_WHY];

    if (!fb_probe(&f->screen, path, why))
        return true;
    if (f->why[0] == '\0')
        (void)snprintf(f->why, PORT_WHY, "%s", why);
    return false;
}

static int probe_first(struct fbdev *f)
{
    f->why[0] = '\0';
    if (node_each(DEVICE, DEVICES, probe, f) == 0)
        (void)snprintf(f->why, PORT_WHY, DEVICE "0: no such device (this kernel has no framebuffer driver loaded)");
    return f->screen.fd >= 0 ? TIA_OK : TIA_ERR_DEVICE;
}

static void describe(const struct fbdev *f, struct tia_mode *mode)
{
    *mode = (struct tia_mode){
        .width = (uint16_t)f->screen.var.xres,
        .height = (uint16_t)f->screen.var.yres,
        .concurrent = true,
        .format = f->format,
    };
}

static int fbdev_open(void *ctx, struct tia_mode *mode)
{
    struct fbdev *f = ctx;
    int status = f->device ? fb_probe(&f->screen, f->device, f->why) : probe_first(f);

    if (status)
        return status;
    status = console_open(true, f->why);
    if (status) {
        fb_close(&f->screen, false);
        return status;
    }
    status = canvas_resize(&f->frame, (uint16_t)f->screen.var.xres, (uint16_t)f->screen.var.yres);
    if (!status)
        status = changes_resize(&f->changes, &f->frame);
    if (status)
        (void)snprintf(f->why, PORT_WHY, "%s: no memory for a frame", f->screen.path);
    else
        status = fb_take(&f->screen, f->why);
    if (status) {
        fbdev_close(f);
        return status;
    }
    expander_init(&f->expander, &f->screen.format);
    (void)pixel_name(&f->screen.format, f->format);
    f->page = 0;
    console_listen(&f->listener);
    describe(f, mode);
    return TIA_OK;
}

/* ---- a frame ---- */

static int lost(struct fbdev *f)
{
    char reason[PORT_WHY];

    (void)snprintf(f->why, PORT_WHY, "%s: %.100s", f->screen.path, node_error(errno, reason));
    return TIA_ERR_DEVICE;
}

static int fbdev_mode(void *ctx, struct tia_mode *mode)
{
    struct fbdev *f = ctx;
    struct fb_var_screeninfo now;

    /* A program without input never waits, so console switches are handled here. */
    if (f->screen.fd < 0 || console_wait(NULL, 0, 0) < 0)
        return TIA_ERR_DEVICE;
    describe(f, mode);
    if (console_state() != CONSOLE_OURS)
        return TIA_HIDDEN;
    if (ioctl(f->screen.fd, FBIOGET_VSCREENINFO, &now) != 0)
        return lost(f);
    if (now.xres != f->screen.var.xres || now.yres != f->screen.var.yres ||
        now.bits_per_pixel != f->screen.var.bits_per_pixel) {
        (void)snprintf(f->why, PORT_WHY, "%s: another program changed its mode", f->screen.path);
        return TIA_ERR_DEVICE;
    }
    return TIA_OK;
}

static int fbdev_acquire(void *ctx, struct tia_tile tile, struct tia_surface *surface)
{
    struct fbdev *f = ctx;

    return f->screen.fd < 0 ? TIA_ERR_DEVICE : canvas_tile(&f->frame, tile, surface);
}

static int fbdev_submit(void *ctx, struct tia_tile tile)
{
    struct fbdev *f = ctx;

    if (f->screen.fd < 0)
        return TIA_ERR_DEVICE;
    return tile_inside(tile, f->frame.width, f->frame.height) ? TIA_OK : TIA_ERR_ARGUMENT;
}

static int fbdev_present(void *ctx)
{
    struct fbdev *f = ctx;
    unsigned page = f->screen.pages == 2 ? 1 - f->page : 0;

    if (f->screen.fd < 0)
        return TIA_ERR_DEVICE;
    if (console_state() != CONSOLE_OURS)
        return TIA_HIDDEN;
    changes_find(&f->changes, &f->frame);
    fb_wait(&f->screen);
    copy(f, page);
    if (fb_show(&f->screen, page))
        return lost(f);
    f->page = page;
    return TIA_OK;
}

const struct tia_display port_fbdev_display = {
    .open = fbdev_open,
    .mode = fbdev_mode,
    .acquire = fbdev_acquire,
    .submit = fbdev_submit,
    .present = fbdev_present,
    .close = fbdev_close,
};

/* ---- the row in ports.c ---- */

void *port_fbdev_create(const struct port_wish *wish)
{
    struct fbdev *f = calloc(1, sizeof *f);

    if (!f) {
        (void)snprintf(wish->why, PORT_WHY, "fbdev: no memory");
        return NULL;
    }
    f->device = wish->device;
    f->why = wish->why;
    f->screen.fd = -1;
    f->listener = (struct console_listener){.enter = enter, .leave = leave, .arg = f};
    return f;
}

void port_fbdev_destroy(void *ctx)
{
    fbdev_close(ctx);
    free(ctx);
}

struct list {
    port_line *line;
    void *arg;
};

static bool list_one(void *arg, const char *path)
{
    const struct list *l = arg;
    struct fb_screen s;
    char text[PORT_WHY], why[PORT_WHY], name[PIXEL_NAME];

    if (fb_probe(&s, path, why)) {
        l->line(l->arg, why);
        return false;
    }
    (void)snprintf(text, sizeof text, "%.64s: %.16s, %ux%u, %s%s", path, s.fix.id, s.var.xres, s.var.yres,
                   pixel_name(&s.format, name), fb_can_pan(&s.var, &s.fix) ? ", room for two pages" : "");
    l->line(l->arg, text);
    fb_close(&s, false);
    return false;
}

void port_fbdev_list(port_line *line, void *arg)
{
    struct list list = {line, arg};

    if (node_each(DEVICE, DEVICES, list_one, &list) == 0)
        line(arg, "no " DEVICE "*: this kernel has no framebuffer device (load a driver)");
    else
        console_list(line, arg);
}
