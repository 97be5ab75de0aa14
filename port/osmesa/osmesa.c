/* osmesa.c - the display: a frame in memory that present() draws through GL. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <GL/gl.h>

#include "gl.h"
#include "osmesa.h"
#include "pixels/canvas.h"

#define DEFAULT_WIDTH 640
#define DEFAULT_HEIGHT 480

/* Platforms in the order of trial. */
static const struct gl_platform *const platforms[] = {
#ifdef TIA_HAVE_LIBOSMESA
    &gl_mesa,
#endif
#ifdef TIA_HAVE_EGL
    &gl_egl,
#endif
};
#define PLATFORMS (sizeof platforms / sizeof platforms[0])

struct osmesa {
    struct gl_screen screen;
    const struct gl_platform *chosen; /* NULL: the first that opens */
    struct canvas frame;              /* the frame that present draws; its pixels are NULL while closed */
};

#define ROW(type, name, arguments) GL_ROW(gl_common, "gl", name),
static const struct gl_row rows[] = {GL_COMMON(ROW)};

void *port_osmesa_create(const struct port_wish *wish)
{
    const struct gl_platform *chosen = NULL;
    struct osmesa *osmesa;

    for (size_t i = 0; wish->device && i < PLATFORMS; i++)
        if (!strcmp(wish->device, platforms[i]->name))
            chosen = platforms[i];
    if (wish->device && !chosen) {
        (void)snprintf(wish->why, PORT_WHY, "osmesa:%s: no such library in this build", wish->device);
        return NULL;
    }
    osmesa = calloc(1, sizeof *osmesa);
    if (!osmesa) {
        (void)snprintf(wish->why, PORT_WHY, "osmesa: out of memory");
        return NULL;
    }
    osmesa->chosen = chosen;
    osmesa->screen.why = wish->why;
    osmesa->screen.width = wish->width ? wish->width : DEFAULT_WIDTH;
    osmesa->screen.height = wish->height ? wish->height : DEFAULT_HEIGHT;
    return osmesa;
}

void port_osmesa_destroy(void *ctx)
{
    free(ctx);
}

/* Sets all state that present relies on, once. The unpack alignment is 2, since rows have no padding and GL's default
 * is 4. Raster position and zoom put the first row at the top. */
static int prepare(struct gl_screen *screen)
{
    const struct gl_common *gl = &screen->gl;
    GLint largest[2] = {0, 0};

    if (!gl_load(screen, &screen->gl, rows, sizeof rows / sizeof rows[0]))
        return TIA_ERR_UNSUPPORTED;
    gl->PixelStorei(GL_UNPACK_ALIGNMENT, 2);
    gl->PixelStorei(GL_PACK_ALIGNMENT, 2);
    gl->GetIntegerv(GL_MAX_VIEWPORT_DIMS, largest);
    if (screen->width > largest[0] || screen->height > largest[1]) {
        return gl_fail(screen, TIA_ERR_UNSUPPORTED, "%ux%u: larger than %dx%d", screen->width, screen->height,
                       largest[0], largest[1]);
    }
    gl->Viewport(0, 0, screen->width, screen->height);
    gl->Disable(GL_DITHER);
    gl->RasterPos2f(-1, 1);
    gl->PixelZoom(1, -1);
    return TIA_OK;
}

static int open_platform(struct gl_screen *screen, const struct gl_platform *platform)
{
    int status;

    screen->platform = platform;
    status = platform->open(screen);
    if (!status)
        status = prepare(screen);
    if (status)
        platform->close(screen);
    return status;
}

static int osmesa_mode(void *ctx, struct tia_mode *mode)
{
    const struct osmesa *osmesa = ctx;

    if (!osmesa->frame.pixels)
        return TIA_ERR_ARGUMENT;
    *mode = (struct tia_mode){
        .width = osmesa->screen.width, .height = osmesa->screen.height, .concurrent = true, .format = "RGB565"};
    return TIA_OK;
}

static void osmesa_close(void *ctx)
{
    struct osmesa *osmesa = ctx;

    if (osmesa->screen.state)
        osmesa->screen.platform->close(&osmesa->screen);
    free(osmesa->screen.pixels);
    osmesa->screen.pixels = NULL;
    canvas_free(&osmesa->frame);
}

static int open_any(struct osmesa *osmesa)
{
    int status = TIA_ERR_UNSUPPORTED;

    for (size_t i = 0; i < PLATFORMS && status; i++)
        if (!osmesa->chosen || osmesa->chosen == platforms[i])
            status = open_platform(&osmesa->screen, platforms[i]);
    return status;
}

static int osmesa_open(void *ctx, struct tia_mode *mode)
{
    struct osmesa *osmesa = ctx;
    struct gl_screen *screen = &osmesa->screen;
    int status;

    if (osmesa->frame.pixels) {
        (void)snprintf(screen->why, PORT_WHY, "osmesa: already open");
        return TIA_ERR_ARGUMENT;
    }
    status = canvas_resize(&osmesa->frame, screen->width, screen->height);
    screen->pixels = calloc((size_t)screen->width * screen->height, sizeof *screen->pixels);
    if (status || !screen->pixels) {
        (void)snprintf(screen->why, PORT_WHY, "osmesa: out of memory for %ux%u", screen->width, screen->height);
        status = TIA_ERR_MEMORY;
    } else {
        status = open_any(osmesa);
    }
    if (status) {
        osmesa_close(ctx);
        return status;
    }
    return osmesa_mode(ctx, mode);
}

static int osmesa_acquire(void *ctx, struct tia_tile tile, struct tia_surface *surface)
{
    return canvas_tile(&((struct osmesa *)ctx)->frame, tile, surface);
}

static int osmesa_submit(void *ctx, struct tia_tile tile)
{
    const struct canvas *frame = &((struct osmesa *)ctx)->frame;

    return tile_inside(tile, frame->width, frame->height) ? TIA_OK : TIA_ERR_ARGUMENT;
}

static int osmesa_present(void *ctx)
{
    struct osmesa *osmesa = ctx;
    struct gl_screen *screen = &osmesa->screen;
    GLenum error;

    if (!osmesa->frame.pixels)
        return TIA_ERR_ARGUMENT;
    if (!screen->platform->make_current(screen))
        return gl_fail(screen, TIA_ERR_DEVICE, "cannot make the context current");
    screen->gl.DrawPixels(screen->width, screen->height, GL_RGB, GL_UNSIGNED_SHORT_5_6_5, osmesa->frame.pixels);
    screen->gl.Finish();
    error = screen->gl.GetError();
    return error == GL_NO_ERROR ? TIA_OK : gl_fail(screen, TIA_ERR_DEVICE, "GL error 0x%x", error);
}

const struct tia_display port_osmesa_display = {
    osmesa_open, osmesa_mode, osmesa_acquire, osmesa_submit, osmesa_present, osmesa_close, NULL};

const tia_rgb565 *port_osmesa_read(void *ctx)
{
    struct osmesa *osmesa = ctx;
    struct gl_screen *screen = &osmesa->screen;

    if (!osmesa->frame.pixels || !screen->platform->make_current(screen))
        return NULL;
    screen->gl.Finish();
    screen->platform->read(screen);
    return screen->gl.GetError() == GL_NO_ERROR ? screen->pixels : NULL;
}

gl_proc port_osmesa_proc(void *ctx, const char *name)
{
    struct osmesa *osmesa = ctx;

    return osmesa->frame.pixels ? osmesa->screen.platform->proc(&osmesa->screen, name) : NULL;
}

void port_osmesa_list(port_line *line, void *arg)
{
    for (size_t i = 0; i < PLATFORMS; i++) {
        char why[PORT_WHY], text[2 * PORT_WHY];
        struct port_wish wish = {.device = platforms[i]->name, .width = 1, .height = 1, .why = why};
        struct osmesa *osmesa = port_osmesa_create(&wish);
        struct tia_mode mode;

        if (osmesa && !osmesa_open(osmesa, &mode)) {
            (void)snprintf(text, sizeof text, "osmesa:%s: any size, RGB565 (%s)", platforms[i]->name,
                           (const char *)osmesa->screen.gl.GetString(GL_RENDERER));
            osmesa_close(osmesa);
        } else {
            (void)snprintf(text, sizeof text, "%s", why);
        }
        line(arg, text);
        port_osmesa_destroy(osmesa);
    }
}
