/* mesa.c - OSMesa, Mesa's interface for rendering into the caller's memory. */
#include <stdlib.h>

#include <GL/osmesa.h>

#include "osmesa/gl.h"

#define OSMESA_FUNCTIONS(F)                                                                                            \
    F(OSMesaContext, CreateContextExt, (GLenum, GLint, GLint, GLint, OSMesaContext))                                   \
    F(void, DestroyContext, (OSMesaContext))                                                                           \
    F(GLboolean, MakeCurrent, (OSMesaContext, void *, GLenum, GLsizei, GLsizei))                                       \
    F(void, PixelStore, (GLint, GLint))                                                                                \
    F(OSMESAproc, GetProcAddress, (const char *))

struct mesa {
    OSMESA_FUNCTIONS(GL_MEMBER)
    OSMesaContext context;
};

#define ROW(type, name, arguments) GL_ROW(mesa, "OSMesa", name),
static const struct gl_row rows[] = {OSMESA_FUNCTIONS(ROW)};

static bool mesa_make_current(struct gl_screen *screen)
{
    struct mesa *mesa = screen->state;

    return mesa->MakeCurrent(mesa->context, screen->pixels, GL_UNSIGNED_SHORT_5_6_5, screen->width, screen->height);
}

static int mesa_open(struct gl_screen *screen)
{
    struct mesa *mesa = calloc(1, sizeof *mesa);
    void *library;

    screen->state = mesa;
    if (!mesa)
        return gl_fail(screen, TIA_ERR_MEMORY, "out of memory");
    library = gl_library(screen, "libOSMesa.so.8", "libosmesa6");
    if (!library)
        return TIA_ERR_DEVICE;
    if (!gl_symbols(screen, library, mesa, rows, sizeof rows / sizeof rows[0]))
        return TIA_ERR_UNSUPPORTED;
    mesa->context = mesa->CreateContextExt(OSMESA_RGB_565, 0, 0, 0, NULL);
    if (!mesa->context || !mesa_make_current(screen))
        return gl_fail(screen, TIA_ERR_DEVICE, "cannot make an RGB565 context");
    mesa->PixelStore(OSMESA_Y_UP, 0);
    return TIA_OK;
}

static gl_proc mesa_proc(struct gl_screen *screen, const char *name)
{
    return ((struct mesa *)screen->state)->GetProcAddress(name);
}

/* Nothing to do: glFinish has copied the frame to the caller's memory. */
static void mesa_read(struct gl_screen *screen)
{
    (void)screen;
}

static void mesa_close(struct gl_screen *screen)
{
    struct mesa *mesa = screen->state;

    if (mesa && mesa->context) {
        (void)mesa->MakeCurrent(NULL, NULL, 0, 0, 0);
        mesa->DestroyContext(mesa->context);
    }
    free(mesa);
    screen->state = NULL;
}

const struct gl_platform gl_mesa = {"osmesa", mesa_open, mesa_make_current, mesa_proc, mesa_read, mesa_close};
