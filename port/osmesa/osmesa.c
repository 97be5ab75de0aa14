/* osmesa.c - the display port: a frame in memory that present() draws through GL. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <GL/gl.h>

#include "osmesa/gl.h"
#include "osmesa/osmesa.h"

#define DEFAULT_WIDTH 640
#define DEFAULT_HEIGHT 480

/* In the order in which they are tried. */
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
    tia_rgb565 *frame;                /* what present draws; NULL while closed */
};

#define ROW(type, name, arguments) GL_ROW(gl_common, "gl", name),
static const struct gl_row rows[] = {GL_COMMON(ROW)};

void *osmesa_create(const struct port_wish *wish)
{
    const struct gl_platform *chosen = NULL;
    struct osmesa *osmesa;

    for (size_t i = 0; wish->device && i < PLATFORMS; i++) {
        if (!strcmp(wish->device, platforms[i]->name)) {
            chosen = platforms[i];
        }
    }
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

void osmesa_destroy(void *ctx)
{
    free(ctx);
}

/* All state that present relies on, set once. The alignment comes first: rows of an odd number
 * of pixels have no padding here, and GL's own default is 4. The picture's first row is drawn at
 * the top, downwards. */
static int prepare(struct gl_screen *screen)
{
    const struct gl_common *gl = &screen->gl;
    GLint largest[2] = {0, 0};

    if (!gl_load(screen, &screen->gl, rows, sizeof rows / sizeof rows[0])) {
        return TIA_ERR_UNSUPPORTED;
    }
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
    if (status == TIA_OK) {
        status = prepare(screen);
    }
    if (status != TIA_OK) {
        platform->close(screen);
    }
    return status;
}

static int osmesa_mode(void *ctx, struct tia_mode *mode)
{
    const struct osmesa *osmesa = ctx;

    *mode = (struct tia_mode){
        .width = osmesa->screen.width, .height = osmesa->screen.height, .concurrent = true, .format = "RGB565"};
    return TIA_OK;
}

static void osmesa_close(void *ctx)
{
    struct osmesa *osmesa = ctx;

    if (osmesa->screen.state) {
        osmesa->screen.platform->close(&osmesa->screen);
    }
    free(osmesa->screen.pixels);
    free(osmesa->frame);
    osmesa->screen.pixels = osmesa->frame = NULL;
}

static int osmesa_open(void *ctx, struct tia_mode *mode)
{
    struct osmesa *osmesa = ctx;
    struct gl_screen *screen = &osmesa->screen;
    size_t count = (size_t)screen->width * screen->height;
    int status = TIA_ERR_MEMORY;

    osmesa->frame = calloc(count, sizeof *osmesa->frame);
    screen->pixels = calloc(count, sizeof *screen->pixels);
    if (!osmesa->frame || !screen->pixels) {
        (void)snprintf(screen->why, PORT_WHY, "osmesa: out of memory for %ux%u", screen->width, screen->height);
    } else if (osmesa->chosen) {
        status = open_platform(screen, osmesa->chosen);
    } else {
        for (size_t i = 0; i < PLATFORMS && status != TIA_OK; i++) {
            status = open_platform(screen, platforms[i]);
        }
    }
    if (status != TIA_OK) {
        osmesa_close(ctx);
        return status;
    }
    return osmesa_mode(ctx, mode);
}

static bool inside(const struct gl_screen *screen, struct tia_tile tile)
{
    return tile.x + tile.width <= screen->width && tile.y + tile.height <= screen->height;
}

static int osmesa_acquire(void *ctx, struct tia_tile tile, struct tia_surface *surface)
{
    struct osmesa *osmesa = ctx;

    if (!osmesa->frame || !inside(&osmesa->screen, tile)) {
        return TIA_ERR_ARGUMENT;
    }
    *surface = (struct tia_surface){osmesa->frame + (size_t)tile.y * osmesa->screen.width + tile.x, 2,
                                    2 * (ptrdiff_t)osmesa->screen.width};
    return TIA_OK;
}

static int osmesa_submit(void *ctx, struct tia_tile tile)
{
    struct osmesa *osmesa = ctx;

    return osmesa->frame && inside(&osmesa->screen, tile) ? TIA_OK : TIA_ERR_ARGUMENT;
}

static int osmesa_present(void *ctx)
{
    struct osmesa *osmesa = ctx;
    struct gl_screen *screen = &osmesa->screen;
    GLenum error;

    if (!osmesa->frame) {
        return TIA_ERR_ARGUMENT;
    }
    if (!screen->platform->make_current(screen)) {
        return gl_fail(screen, TIA_ERR_DEVICE, "cannot make the context current");
    }
    screen->gl.DrawPixels(screen->width, screen->height, GL_RGB, GL_UNSIGNED_SHORT_5_6_5, osmesa->frame);
    screen->gl.Finish();
    error = screen->gl.GetError();
    return error == GL_NO_ERROR ? TIA_OK : gl_fail(screen, TIA_ERR_DEVICE, "GL error 0x%x", error);
}

const struct tia_display osmesa_display = {osmesa_open,   osmesa_mode,    osmesa_acquire,
                                           osmesa_submit, osmesa_present, osmesa_close};

const tia_rgb565 *osmesa_read(void *ctx)
{
    struct osmesa *osmesa = ctx;
    struct gl_screen *screen = &osmesa->screen;

    if (!osmesa->frame || !screen->platform->make_current(screen)) {
        return NULL;
    }
    screen->gl.Finish();
    screen->platform->read(screen);
    return screen->gl.GetError() == GL_NO_ERROR ? screen->pixels : NULL;
}

gl_proc osmesa_proc(void *ctx, const char *name)
{
    struct osmesa *osmesa = ctx;

    return osmesa->frame ? osmesa->screen.platform->proc(&osmesa->screen, name) : NULL;
}

const char *osmesa_library(void *ctx)
{
    return ((struct osmesa *)ctx)->screen.platform->name;
}

void osmesa_list(port_line *line, void *arg)
{
    for (size_t i = 0; i < PLATFORMS; i++) {
        char why[PORT_WHY], text[2 * PORT_WHY];
        struct port_wish wish = {.device = platforms[i]->name, .width = 1, .height = 1, .why = why};
        struct osmesa *osmesa = osmesa_create(&wish);
        struct tia_mode mode;

        if (osmesa && osmesa_open(osmesa, &mode) == TIA_OK) {
            (void)snprintf(text, sizeof text, "osmesa:%s: any size, RGB565 (%s)", platforms[i]->name,
                           (const char *)osmesa->screen.gl.GetString(GL_RENDERER));
            osmesa_close(osmesa);
        } else {
            (void)snprintf(text, sizeof text, "%s", why);
        }
        line(arg, text);
        osmesa_destroy(osmesa);
    }
}
