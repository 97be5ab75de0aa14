/* egl.c - EGL without a window system (EGL_MESA_platform_surfaceless). Such a context has no default frame buffer;
 * it renders into a frame buffer object. */
#include <stdlib.h>
#include <string.h>

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>

#include "osmesa/gl.h"

#define EGL_FUNCTIONS(F)                                                                                               \
    F(EGLBoolean, BindAPI, (EGLenum))                                                                                  \
    F(EGLContext, CreateContext, (EGLDisplay, EGLConfig, EGLContext, const EGLint *))                                  \
    F(EGLBoolean, DestroyContext, (EGLDisplay, EGLContext))                                                            \
    F(EGLint, GetError, (void))                                                                                        \
    F(gl_proc, GetProcAddress, (const char *))                                                                         \
    F(EGLBoolean, Initialize, (EGLDisplay, EGLint *, EGLint *))                                                        \
    F(EGLBoolean, MakeCurrent, (EGLDisplay, EGLSurface, EGLSurface, EGLContext))                                       \
    F(const char *, QueryString, (EGLDisplay, EGLint))

#define FRAMEBUFFER_FUNCTIONS(F)                                                                                       \
    F(void, BindFramebuffer, (GLenum, GLuint))                                                                         \
    F(void, BindRenderbuffer, (GLenum, GLuint))                                                                        \
    F(GLenum, CheckFramebufferStatus, (GLenum))                                                                        \
    F(void, FramebufferRenderbuffer, (GLenum, GLenum, GLenum, GLuint))                                                 \
    F(void, GenFramebuffers, (GLsizei, GLuint *))                                                                      \
    F(void, GenRenderbuffers, (GLsizei, GLuint *))                                                                     \
    F(void, ReadPixels, (GLint, GLint, GLsizei, GLsizei, GLenum, GLenum, void *))                                      \
    F(void, RenderbufferStorage, (GLenum, GLenum, GLsizei, GLsizei))

struct egl {
    EGL_FUNCTIONS(GL_MEMBER)
    FRAMEBUFFER_FUNCTIONS(GL_MEMBER)
    EGLDisplay display;
    EGLContext context;
};

#define EGL_ROW(type, name, arguments) GL_ROW(egl, "egl", name),
static const struct gl_row egl_rows[] = {EGL_FUNCTIONS(EGL_ROW)};
#define FRAMEBUFFER_ROW(type, name, arguments) GL_ROW(egl, "gl", name),
static const struct gl_row framebuffer_rows[] = {FRAMEBUFFER_FUNCTIONS(FRAMEBUFFER_ROW)};

static bool egl_make_current(struct gl_screen *screen)
{
    struct egl *egl = screen->state;

    return egl->MakeCurrent(egl->display, EGL_NO_SURFACE, EGL_NO_SURFACE, egl->context);
}

static gl_proc egl_proc(struct gl_screen *screen, const char *name)
{
    return ((struct egl *)screen->state)->GetProcAddress(name);
}

static int find_display(struct gl_screen *screen, struct egl *egl)
{
    const char *extensions = egl->QueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    PFNEGLGETPLATFORMDISPLAYEXTPROC get_platform_display;
    gl_proc proc = egl->GetProcAddress("eglGetPlatformDisplayEXT");

    if (!extensions || !strstr(extensions, "EGL_MESA_platform_surfaceless") || !proc)
        return gl_fail(screen, TIA_ERR_UNSUPPORTED, "no EGL_MESA_platform_surfaceless (install libegl-mesa0)");
    memcpy(&get_platform_display, &proc, sizeof proc);
    egl->display = get_platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
    if (egl->display == EGL_NO_DISPLAY || !egl->Initialize(egl->display, NULL, NULL)) {
        egl->display = EGL_NO_DISPLAY;
        return gl_fail(screen, TIA_ERR_DEVICE, "cannot initialise: error 0x%x (install libgl1-mesa-dri)",
                       (unsigned)egl->GetError());
    }
    return TIA_OK;
}

static int make_context(struct gl_screen *screen, struct egl *egl)
{
    if (egl->BindAPI(EGL_OPENGL_API))
        egl->context = egl->CreateContext(egl->display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, NULL);
    if (egl->context == EGL_NO_CONTEXT || !egl_make_current(screen))
        return gl_fail(screen, TIA_ERR_UNSUPPORTED, "no OpenGL context: error 0x%x", (unsigned)egl->GetError());
    if (!gl_load(screen, egl, framebuffer_rows, sizeof framebuffer_rows / sizeof framebuffer_rows[0]))
        return TIA_ERR_UNSUPPORTED;
    return TIA_OK;
}

static int make_framebuffer(struct gl_screen *screen, struct egl *egl)
{
    GLuint framebuffer, pixels;

    egl->GenRenderbuffers(1, &pixels);
    egl->BindRenderbuffer(GL_RENDERBUFFER, pixels);
    egl->RenderbufferStorage(GL_RENDERBUFFER, GL_RGB565, screen->width, screen->height);
    egl->GenFramebuffers(1, &framebuffer);
    egl->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    egl->FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, pixels);
    if (egl->CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        return gl_fail(screen, TIA_ERR_UNSUPPORTED, "no RGB565 framebuffer of %ux%u", screen->width, screen->height);
    return TIA_OK;
}

static int egl_open(struct gl_screen *screen)
{
    struct egl *egl = calloc(1, sizeof *egl);
    void *library;
    int status;

    screen->state = egl;
    if (!egl)
        return gl_fail(screen, TIA_ERR_MEMORY, "out of memory");
    library = gl_library(screen, "libEGL.so.1", "libegl1");
    if (!library)
        return TIA_ERR_DEVICE;
    if (!gl_symbols(screen, library, egl, egl_rows, sizeof egl_rows / sizeof egl_rows[0]))
        return TIA_ERR_UNSUPPORTED;
    if ((status = find_display(screen, egl)) == TIA_OK && (status = make_context(screen, egl)) == TIA_OK)
        status = make_framebuffer(screen, egl);
    return status;
}

/* Reads the frame and reverses its rows: GL's first row is the bottom one. */
static void egl_read(struct gl_screen *screen)
{
    struct egl *egl = screen->state;

    for (int y = 0; y < screen->height; y++) {
        egl->ReadPixels(0, screen->height - 1 - y, screen->width, 1, GL_RGB, GL_UNSIGNED_SHORT_5_6_5,
                        screen->pixels + (size_t)y * screen->width);
    }
}

/* Destroys the context, which frees its frame buffer object. The display is not terminated: it belongs to the whole
 * program, without reference counting, so terminating it would destroy other users' contexts. */
static void egl_close(struct gl_screen *screen)
{
    struct egl *egl = screen->state;

    if (egl && egl->display != EGL_NO_DISPLAY) {
        (void)egl->MakeCurrent(egl->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (egl->context != EGL_NO_CONTEXT)
            (void)egl->DestroyContext(egl->display, egl->context);
    }
    free(egl);
    screen->state = NULL;
}

const struct gl_platform gl_egl = {"egl", egl_open, egl_make_current, egl_proc, egl_read, egl_close};
