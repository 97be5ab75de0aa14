#include "gl_raster.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <GL/gl.h>
#include <GL/glext.h>

#include "functions.h"

#define FUNCTIONS(F)                                                                                                   \
    F(void, Begin, (GLenum))                                                                                           \
    F(void, BindFramebuffer, (GLenum, GLuint))                                                                         \
    F(void, BindRenderbuffer, (GLenum, GLuint))                                                                        \
    F(GLenum, CheckFramebufferStatus, (GLenum))                                                                        \
    F(void, Clear, (GLbitfield))                                                                                       \
    F(void, ClearColor, (GLfloat, GLfloat, GLfloat, GLfloat))                                                          \
    F(void, ClearStencil, (GLint))                                                                                     \
    F(void, Color4ub, (GLubyte, GLubyte, GLubyte, GLubyte))                                                            \
    F(void, ColorMask, (GLboolean, GLboolean, GLboolean, GLboolean))                                                   \
    F(void, CullFace, (GLenum))                                                                                        \
    F(void, DepthFunc, (GLenum))                                                                                       \
    F(void, DepthMask, (GLboolean))                                                                                    \
    F(void, Disable, (GLenum))                                                                                         \
    F(void, Enable, (GLenum))                                                                                          \
    F(void, End, (void))                                                                                               \
    F(void, FramebufferRenderbuffer, (GLenum, GLenum, GLenum, GLuint))                                                 \
    F(void, FrontFace, (GLenum))                                                                                       \
    F(void, GenFramebuffers, (GLsizei, GLuint *))                                                                      \
    F(void, GenRenderbuffers, (GLsizei, GLuint *))                                                                     \
    F(void, Finish, (void))                                                                                            \
    F(GLenum, GetError, (void))                                                                                        \
    F(const GLubyte *, GetString, (GLenum))                                                                            \
    F(void, PixelStorei, (GLenum, GLint))                                                                              \
    F(void, ReadPixels, (GLint, GLint, GLsizei, GLsizei, GLenum, GLenum, void *))                                      \
    F(void, RenderbufferStorage, (GLenum, GLenum, GLsizei, GLsizei))                                                   \
    F(void, ShadeModel, (GLenum))                                                                                      \
    F(void, StencilFuncSeparate, (GLenum, GLenum, GLint, GLuint))                                                      \
    F(void, StencilMask, (GLuint))                                                                                     \
    F(void, StencilMaskSeparate, (GLenum, GLuint))                                                                     \
    F(void, StencilOpSeparate, (GLenum, GLenum, GLenum, GLenum))                                                       \
    F(void, Vertex4d, (GLdouble, GLdouble, GLdouble, GLdouble))                                                        \
    F(void, Viewport, (GLint, GLint, GLsizei, GLsizei))

static struct functions {
    FUNCTIONS(GL_MEMBER)
} gl;

#define ROW(type, name, arguments) GL_ROW(functions, "gl", name),
static const struct gl_row rows[] = {FUNCTIONS(ROW)};

struct gl_raster {
    void *display;
    unsigned width, height;
    uint8_t *rgba;
};

/* Prepares GL's state. Returns false on failure, with the reason in `why`. Polygons are drawn upside down: Mesa's
 * software rasterisers draw pixel centres that lie on bottom and left edges, in GL's orientation, while tia's rule is
 * top-left. Upside down, front faces are clockwise. */
static bool prepare(const struct gl_raster *r, char *why)
{
    static const GLenum formats[2] = {GL_RGBA8, GL_DEPTH24_STENCIL8},
                        attachments[2] = {GL_COLOR_ATTACHMENT0, GL_DEPTH_STENCIL_ATTACHMENT};
    GLuint framebuffer, buffers[2];

    gl.GenFramebuffers(1, &framebuffer);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl.GenRenderbuffers(2, buffers);
    for (int i = 0; i < 2; i++) {
        gl.BindRenderbuffer(GL_RENDERBUFFER, buffers[i]);
        gl.RenderbufferStorage(GL_RENDERBUFFER, formats[i], (GLsizei)r->width, (GLsizei)r->height);
        gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, attachments[i], GL_RENDERBUFFER, buffers[i]);
    }
    if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        (void)snprintf(why, PORT_WHY, "no framebuffer of %ux%u with a stencil", r->width, r->height);
        return false;
    }
    gl.Viewport(0, 0, (GLsizei)r->width, (GLsizei)r->height);
    gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl.FrontFace(GL_CW);
    gl.ShadeModel(GL_FLAT);
    gl.Disable(GL_DITHER);
    gl.Enable(GL_DEPTH_CLAMP);
    gl.Enable(GL_DEPTH_TEST);
    return true;
}

struct gl_raster *gl_raster_open(const char *library, unsigned width, unsigned height, char *why)
{
    struct port_wish wish = {.device = library, .why = why, .width = (uint16_t)width, .height = (uint16_t)height};
    struct gl_raster *r = calloc(1, sizeof *r);
    struct tia_mode mode;

    if (r)
        r->rgba = malloc((size_t)4 * width * height);
    if (!r || !r->rgba)
        abort();
    r->width = width;
    r->height = height;
    void *display = port_osmesa_create(&wish);
    if (display && !port_osmesa_display.open(display, &mode))
        r->display = display;
    else if (display)
        port_osmesa_destroy(display);
    if (r->display && gl_functions_load(r->display, &gl, rows, sizeof rows / sizeof *rows, why) && prepare(r, why))
        return r;
    gl_raster_close(r);
    return NULL;
}

void gl_raster_close(struct gl_raster *r)
{
    if (r->display) {
        port_osmesa_display.close(r->display);
        port_osmesa_destroy(r->display);
    }
    free(r->rgba);
    free(r);
}

const char *gl_raster_driver(void)
{
    return (const char *)gl.GetString(GL_RENDERER);
}

void gl_raster_clear(struct gl_raster *r, uint8_t stencil)
{
    (void)r;
    gl.DepthMask(GL_TRUE);
    gl.StencilMask(255);
    gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl.ClearColor(1, 1, 1, 1);
    gl.ClearStencil(stencil);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

static const GLenum compares[8] = {GL_NEVER,   GL_LESS,     GL_EQUAL,  GL_LEQUAL,
                                   GL_GREATER, GL_NOTEQUAL, GL_GEQUAL, GL_ALWAYS};
static const GLenum operations[8] = {GL_KEEP, GL_ZERO,   GL_REPLACE,   GL_INCR,
                                     GL_DECR, GL_INVERT, GL_INCR_WRAP, GL_DECR_WRAP};

static void set_side(GLenum side, const struct tia_stencil *s)
{
    gl.StencilFuncSeparate(side, compares[s->test], s->reference, s->mask);
    gl.StencilOpSeparate(side, operations[s->fail], operations[s->zfail], operations[s->zpass]);
    gl.StencilMaskSeparate(side, s->write);
}

static bool ignores_stencil(const struct tia_stencil *s)
{
    return s->test == TIA_COMPARE_ALWAYS && s->zfail == TIA_STENCIL_KEEP && s->zpass == TIA_STENCIL_KEEP;
}

static void switch_to(GLenum what, bool on)
{
    (on ? gl.Enable : gl.Disable)(what);
}

static void set_state(const struct tia_raster_state *s)
{
    GLboolean colour = s->colour_write[0] ? GL_TRUE : GL_FALSE;

    gl.DepthFunc(compares[s->depth]);
    gl.DepthMask(s->depth_write ? GL_TRUE : GL_FALSE);
    gl.ColorMask(colour, colour, colour, colour);
    switch_to(GL_STENCIL_TEST, !ignores_stencil(&s->front) || !ignores_stencil(&s->back));
    set_side(GL_FRONT, &s->front);
    set_side(GL_BACK, &s->back);
    switch_to(GL_CULL_FACE, s->skip_front || s->skip_back);
    if (s->skip_front || s->skip_back)
        gl.CullFace(s->skip_front && s->skip_back ? GL_FRONT_AND_BACK : s->skip_front ? GL_FRONT : GL_BACK);
}

void gl_raster_begin(struct gl_raster *r, const struct tia_raster_state *state)
{
    (void)r;
    set_state(state);
    gl.Begin(GL_TRIANGLES);
}

void gl_raster_polygon(struct gl_raster *r, const double (*corners)[4], unsigned count, uint32_t face)
{
    (void)r;
    gl.Color4ub((GLubyte)face, (GLubyte)(face >> 8), (GLubyte)(face >> 16), (GLubyte)(face >> 24));
    for (unsigned i = 2; i < count; i++) {
        const double *const triangle[3] = {corners[0], corners[i - 1], corners[i]};
        for (int k = 0; k < 3; k++)
            gl.Vertex4d(triangle[k][0], -triangle[k][1], triangle[k][2], triangle[k][3]);
    }
}

void gl_raster_end(struct gl_raster *r)
{
    (void)r;
    gl.End();
}

void gl_raster_draw(struct gl_raster *r, const struct tia_raster_state *state, const double (*corners)[4],
                    unsigned count, uint32_t face)
{
    gl_raster_begin(r, state);
    gl_raster_polygon(r, corners, count, face);
    gl_raster_end(r);
}

void gl_raster_finish(void)
{
    gl.Finish();
}

bool gl_raster_read(struct gl_raster *r, uint32_t *face, uint8_t *stencil)
{
    size_t count = (size_t)r->width * r->height;

    gl.ReadPixels(0, 0, (GLsizei)r->width, (GLsizei)r->height, GL_RGBA, GL_UNSIGNED_BYTE, r->rgba);
    gl.ReadPixels(0, 0, (GLsizei)r->width, (GLsizei)r->height, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, stencil);
    for (size_t i = 0; i < count; i++)
        face[i] = (uint32_t)r->rgba[4 * i] | (uint32_t)r->rgba[4 * i + 1] << 8 | (uint32_t)r->rgba[4 * i + 2] << 16 |
                  (uint32_t)r->rgba[4 * i + 3] << 24;
    return gl.GetError() == GL_NO_ERROR;
}
