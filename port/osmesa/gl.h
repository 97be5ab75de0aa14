/* gl.h - a GL context that draws into memory, from a library that is loaded when it is needed. */
#ifndef PORT_OSMESA_GL_H
#define PORT_OSMESA_GL_H

#include <GL/gl.h>
#include <tia/render.h>

typedef void (*gl_proc)(void);

/* The functions of GL that both libraries need: F(type, name, arguments). */
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

/* Members of a table of functions, and rows of the list that gl_load fills it by. */
#define GL_MEMBER(type, name, arguments) type(GLAPIENTRY *name) arguments;
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
    void *state; /* the platform's own */
    uint16_t width, height;
    tia_rgb565 *pixels; /* what GL shows, from the top; the platform writes it */
    struct gl_common gl;
    char *why; /* [PORT_WHY] */
};

struct gl_platform {
    const char *name;
    /* Loads the library and makes a context of the screen's size, current. On failure why says
     * what failed; close is safe all the same, and twice. */
    int (*open)(struct gl_screen *screen);
    bool (*make_current)(struct gl_screen *screen);
    gl_proc (*proc)(struct gl_screen *screen, const char *name);
    /* Brings what is drawn into screen->pixels. GL has finished, the context is current. */
    void (*read)(struct gl_screen *screen);
    void (*close)(struct gl_screen *screen);
};

extern const struct gl_platform gl_mesa, gl_egl;

/* Loads the shared library `file`, which then stays; NULL: why says what failed. */
void *gl_library(struct gl_screen *screen, const char *file, const char *package);

/* Fills a table with functions of a library, or with functions of GL. False: why names what is missing. */
bool gl_symbols(struct gl_screen *screen, void *library, void *table, const struct gl_row *rows, size_t count);
bool gl_load(struct gl_screen *screen, void *table, const struct gl_row *rows, size_t count);

/* Writes "osmesa:NAME: ..." into why; returns status. */
__attribute__((format(printf, 3, 4))) int gl_fail(struct gl_screen *screen, int status, const char *format, ...);

#endif
