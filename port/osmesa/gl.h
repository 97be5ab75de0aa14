/* gl.h - a GL context that renders into memory, from a library loaded at run time. */
#ifndef PORT_OSMESA_GL_H
#define PORT_OSMESA_GL_H

#include <GL/gl.h>
#include <tia/render.h>

typedef void (*gl_proc)(void);

/* GL functions that are called with either library: F(type, name, arguments). */
#define GL_COMMON(F)                                                                                                   \
    F(void, Disable, (GLenum))                                                                                         \
    F(void, DrawPixels, (GLsizei, GLsizei, GLenum, GLenum, const void *))                                              \
    F(void, Finish, (void))                                                                                            \
    F(GLenum, GetError, (void))                                                                                        \
    F(void, GetIntegerv, (GLenum, GLint *))                                                                            \
    F(const GLubyte *, GetString, (GLenum))                                                                            \
    F(void, PixelStorei, (GLenum, GLint))                                                                              \
    F(void, PixelZoom, (GLfloat, GLfloat))                                                                             \
    F(void, RasterPos2f, (GLfloat, GLfloat))                                                                           \
    F(void, Viewport, (GLint, GLint, GLsizei, GLsizei))

/* A definition of F: declares the member of a table of functions. */
#define GL_MEMBER(type, name, arguments) type(GLAPIENTRY *name) arguments;
/* A row of the list from which gl_symbols and gl_load fill a table. */
#define GL_ROW(table, prefix, name)                                                                                    \
    {                                                                                                                  \
        prefix #name, offsetof(struct table, name)                                                                     \
    }

struct gl_row {
    const char *name;
    size_t offset;
};

struct gl_common {
    GL_COMMON(GL_MEMBER)
};

struct gl_screen {
    const struct gl_platform *platform;
    void *state; /* the platform's own state */
    uint16_t width, height;
    tia_rgb565 *pixels; /* the frame buffer, top row first; the platform writes it */
    struct gl_common gl;
    char *why; /* [PORT_WHY] */
};

struct gl_platform {
    const char *name;
    /* Loads the library, creates a context of the screen's size and makes it current. After a failure `why` has the
     * reason. `close` is safe after a failure, and when called twice. */
    int (*open)(struct gl_screen *screen);
    bool (*make_current)(struct gl_screen *screen);
    gl_proc (*proc)(struct gl_screen *screen, const char *name);
    /* Copies the frame buffer to screen->pixels. Called after glFinish, with the context current. */
    void (*read)(struct gl_screen *screen);
    void (*close)(struct gl_screen *screen);
};

extern const struct gl_platform gl_mesa, gl_egl;

/* Loads the shared library `file`, which is never unloaded. Returns NULL on failure, with the reason, and the package
 * to install, in `why`. */
void *gl_library(struct gl_screen *screen, const char *file, const char *package);

/* Fills a table with functions of a library. False if one is missing; `why` names it. */
bool gl_symbols(struct gl_screen *screen, void *library, void *table, const struct gl_row *rows, size_t count);
/* Fills a table with functions of the current context's GL, as gl_symbols does. */
bool gl_load(struct gl_screen *screen, void *table, const struct gl_row *rows, size_t count);

/* Writes "osmesa:NAME: ..." to `why`; returns status. */
__attribute__((format(printf, 3, 4))) int gl_fail(struct gl_screen *screen, int status, const char *format, ...);

#endif
