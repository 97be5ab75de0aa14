/* gl_scene.c - the built-in scene, drawn by OpenGL from its description alone.
 *
 * GL has no rays: it projects spheres made of small triangles, finds the nearest by a depth
 * buffer and interpolates positions over them. Only lighting is the same formula, in a shader:
 * Lambert's law and a shadow ray against both spheres. */
#include "gl_scene.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include <GL/gl.h>
#include <GL/glext.h>

#include "gl/functions.h"

#define FUNCTIONS(F)                                                                                                   \
    F(void, AttachShader, (GLuint, GLuint))                                                                            \
    F(void, Begin, (GLenum))                                                                                           \
    F(void, BindFramebuffer, (GLenum, GLuint))                                                                         \
    F(void, BindRenderbuffer, (GLenum, GLuint))                                                                        \
    F(void, CallList, (GLuint))                                                                                        \
    F(GLenum, CheckFramebufferStatus, (GLenum))                                                                        \
    F(void, Clear, (GLbitfield))                                                                                       \
    F(void, ClearColor, (GLfloat, GLfloat, GLfloat, GLfloat))                                                          \
    F(void, CompileShader, (GLuint))                                                                                   \
    F(GLuint, CreateProgram, (void))                                                                                   \
    F(GLuint, CreateShader, (GLenum))                                                                                  \
    F(void, Enable, (GLenum))                                                                                          \
    F(void, End, (void))                                                                                               \
    F(void, EndList, (void))                                                                                           \
    F(void, FramebufferRenderbuffer, (GLenum, GLenum, GLenum, GLuint))                                                 \
    F(void, Frustum, (GLdouble, GLdouble, GLdouble, GLdouble, GLdouble, GLdouble))                                     \
    F(void, GenFramebuffers, (GLsizei, GLuint *))                                                                      \
    F(void, GenRenderbuffers, (GLsizei, GLuint *))                                                                     \
    F(GLenum, GetError, (void))                                                                                        \
    F(void, GetProgramiv, (GLuint, GLenum, GLint *))                                                                   \
    F(GLint, GetUniformLocation, (GLuint, const GLchar *))                                                             \
    F(void, LinkProgram, (GLuint))                                                                                     \
    F(void, NewList, (GLuint, GLenum))                                                                                 \
    F(void, ReadPixels, (GLint, GLint, GLsizei, GLsizei, GLenum, GLenum, void *))                                      \
    F(void, RenderbufferStorage, (GLenum, GLenum, GLsizei, GLsizei))                                                   \
    F(void, ShaderSource, (GLuint, GLsizei, const GLchar *const *, const GLint *))                                     \
    F(void, Uniform1f, (GLint, GLfloat))                                                                               \
    F(void, Uniform1i, (GLint, GLint))                                                                                 \
    F(void, Uniform3f, (GLint, GLfloat, GLfloat, GLfloat))                                                             \
    F(void, UseProgram, (GLuint))                                                                                      \
    F(void, Vertex3d, (GLdouble, GLdouble, GLdouble))

static struct functions {
    FUNCTIONS(GL_MEMBER)
} gl;

#define ROW(type, name, arguments) GL_ROW(functions, "gl", name),
static const struct gl_row rows[] = {FUNCTIONS(ROW)};

/* ---- the scene, once more in GL's terms ---- */

#define FOV_DEGREES 25.0
#define PI 3.14159265358979323846

enum { LIGHT = 2, THINGS };
static const struct gl_ball things[2] = {
    [GL_GROUND] = {{0, -10004, -20}, 10000, {0.6, 0.6, 0.6}},
    [GL_BALL] = {{0, -1, -20}, 3, {1, 1, 1}},
};
static const double background = 0.8;

static const char vertex_shader[] = "#version 120\n"
                                    "varying vec3 point;\n"
                                    "void main() {\n"
                                    "    point = gl_Vertex.xyz;\n"
                                    "    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;\n"
                                    "}\n";

/* Fragment shader. For a mask it draws the object (red: the ground, green: the ball) and lit pixels (blue). */
static const char fragment_shader[] =
    "#version 120\n"
    "varying vec3 point;\n"
    "uniform int thing;\n"
    "uniform bool mask;\n"
    "uniform vec3 centre[3], colour[3];\n"
    "uniform float radius[3];\n"
    "bool hit(int i, vec3 origin, vec3 direction, float far) {\n"
    "    vec3 L = centre[i] - origin;\n"
    "    float tca = dot(L, direction);\n"
    "    vec3 across = L - tca * direction;\n"
    "    float d2 = dot(across, across);\n"
    "    if (tca < 0.0 || d2 > radius[i] * radius[i]) return false;\n"
    "    float thc = sqrt(radius[i] * radius[i] - d2);\n"
    "    return (tca < thc ? tca + thc : tca - thc) < far;\n"
    "}\n"
    "void main() {\n"
    "    vec3 N = normalize(point - centre[thing]);\n"
    "    vec3 direction = normalize(centre[2] - point);\n"
    "    vec3 origin = point + exp2(-13.0) * N;\n"
    "    float far = distance(centre[2], origin);\n"
    "    float cosine = radius[2] > 0.0 && thing != 2 ? max(0.0, dot(N, direction)) : 0.0;\n"
    "    if (hit(0, origin, direction, far) || hit(1, origin, direction, far)) cosine = 0.0;\n"
    "    vec3 seen = thing == 2 ? colour[2] : colour[thing] * colour[2] * cosine;\n"
    "    if (mask) seen = vec3(thing == 0, thing == 1, cosine > 0.0);\n"
    "    gl_FragColor = vec4(seen, 1.0);\n"
    "}\n";

/* Draws the part of a sphere that is visible from the eye at the origin, and a little more, as rings around the axis to
 * the eye. The distance of a triangle from the sphere is at most step^2/8 times the radius: 10^-4 for the ground, 3
 * 10^-5 for the ball. */
static void draw_ball(const struct gl_ball *ball)
{
    const int rings = 200, segments = 720;
    const double *c = ball->centre, d = sqrt(c[0] * c[0] + c[1] * c[1] + c[2] * c[2]);
    const double w[3] = {-c[0] / d, -c[1] / d, -c[2] / d}, across = sqrt(w[1] * w[1] + w[2] * w[2]);
    const double u[3] = {0, w[2] / across, -w[1] / across};
    const double v[3] = {w[1] * u[2] - w[2] * u[1], w[2] * u[0] - w[0] * u[2], w[0] * u[1] - w[1] * u[0]};
    const double reach = 1.2 * acos(ball->radius / d);

    for (int ring = 0; ring < rings; ring++) {
        gl.Begin(GL_TRIANGLE_STRIP);
        for (int i = 0; i < 2 * (segments + 1); i++) {
            double theta = reach * (ring + i % 2) / rings, phi = 2 * PI * (i / 2 % segments) / segments, p[3];
            for (int k = 0; k < 3; k++)
                p[k] = c[k] + ball->radius * (cos(theta) * w[k] + sin(theta) * (cos(phi) * u[k] + sin(phi) * v[k]));
            gl.Vertex3d(p[0], p[1], p[2]);
        }
        gl.End();
    }
}

/* ---- drawing with GL ---- */

static bool compile(GLuint program, GLenum kind, const char *source)
{
    GLuint shader = gl.CreateShader(kind);

    gl.ShaderSource(shader, 1, &source, NULL);
    gl.CompileShader(shader);
    gl.AttachShader(program, shader);
    return shader != 0;
}

static GLuint make_program(char *why)
{
    GLuint program = gl.CreateProgram();
    GLint linked = 0;

    if (compile(program, GL_VERTEX_SHADER, vertex_shader) && compile(program, GL_FRAGMENT_SHADER, fragment_shader)) {
        gl.LinkProgram(program);
        gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
    }
    if (!linked) {
        (void)snprintf(why, PORT_WHY, "the shaders do not link");
        return 0;
    }
    gl.UseProgram(program);
    return program;
}

/* Makes a render target apart from the display, which has no depth buffer. Its colours are floats, since GL's
 * specification does not define the rounding of a colour to 5 or 6 bits. */
static bool make_target(unsigned width, unsigned height, char *why)
{
    static const GLenum attachments[2] = {GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT},
                        formats[2] = {GL_RGBA32F, GL_DEPTH_COMPONENT24};
    GLuint framebuffer, buffers[2];

    gl.GenFramebuffers(1, &framebuffer);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl.GenRenderbuffers(2, buffers);
    for (int i = 0; i < 2; i++) {
        gl.BindRenderbuffer(GL_RENDERBUFFER, buffers[i]);
        gl.RenderbufferStorage(GL_RENDERBUFFER, formats[i], (GLsizei)width, (GLsizei)height);
        gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, attachments[i], GL_RENDERBUFFER, buffers[i]);
    }
    gl.Enable(GL_DEPTH_TEST);
    if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        (void)snprintf(why, PORT_WHY, "no framebuffer of %ux%u", width, height);
        return false;
    }
    return true;
}

/* Sets element `thing` of a uniform array, of one or three components. */
static void set(GLuint program, const char *name, int thing, const double *value, int count)
{
    char element[32];
    GLint place;

    (void)snprintf(element, sizeof element, "%s[%d]", name, thing);
    place = gl.GetUniformLocation(program, element);
    if (count == 3)
        gl.Uniform3f(place, (float)value[0], (float)value[1], (float)value[2]);
    else
        gl.Uniform1f(place, (float)value[0]);
}

static void draw_things(GLuint program, int count, bool mask)
{
    const float clear = mask ? 0 : (float)background;

    gl.ClearColor(clear, clear, clear, 1);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl.Uniform1i(gl.GetUniformLocation(program, "mask"), mask);
    for (int i = 0; i < count; i++) {
        gl.Uniform1i(gl.GetUniformLocation(program, "thing"), i);
        gl.CallList((GLuint)i + 1);
    }
}

/* red, green and blue */
typedef float gl_colour[3];

/* The picture, the top row first; GL counts rows from the bottom. */
static gl_colour pixels[PICTURE_PIXELS];

static void read_pixels(const struct picture *picture)
{
    for (unsigned y = 0; y < picture->height; y++) {
        gl.ReadPixels(0, (GLint)(picture->height - 1 - y), (GLsizei)picture->width, 1, GL_RGB, GL_FLOAT,
                      pixels[y * picture->width]);
    }
}

static tia_rgb565 quantised(const gl_colour c)
{
    double level[3];

    for (int k = 0; k < 3; k++)
        level[k] = floor((k == 1 ? 63 : 31) * fmin(1, fmax(0, (double)c[k])) + 0.5);
    return (tia_rgb565)((unsigned)level[0] << 11 | (unsigned)level[1] << 5 | (unsigned)level[2]);
}

/* Sets the projection and the uniforms of the balls, and makes display list i + 1 of object i. */
static void place(GLuint program, const struct gl_ball *light, double aspect)
{
    const double top = tan(FOV_DEGREES / 2 * PI / 180);

    gl.Frustum(-top * aspect, top * aspect, -top, top, 1, 2000);
    for (int i = 0; i < THINGS; i++) {
        const struct gl_ball *ball = i == LIGHT ? light : &things[i];
        set(program, "centre", i, ball->centre, 3);
        set(program, "colour", i, ball->colour, 3);
        set(program, "radius", i, &ball->radius, 1);
        gl.NewList((GLuint)i + 1, GL_COMPILE);
        if (ball->radius > 0)
            draw_ball(ball);
        gl.EndList();
    }
}

static bool draw(const struct gl_ball *light, struct picture *picture, char *why)
{
    const size_t count = (size_t)picture->width * picture->height;
    GLuint program;
    GLenum error;

    if (!make_target(picture->width, picture->height, why) || !(program = make_program(why)))
        return false;
    place(program, light, (double)picture->width / picture->height);
    draw_things(program, THINGS, false);
    read_pixels(picture);
    for (size_t i = 0; i < count; i++)
        picture->colour[i] = quantised(pixels[i]);
    draw_things(program, LIGHT, true);
    read_pixels(picture);
    for (size_t i = 0; i < count; i++) {
        picture->thing[i] = pixels[i][0] > 0 ? GL_GROUND : pixels[i][1] > 0 ? GL_BALL : GL_SKY;
        picture->lit[i] = pixels[i][2] > 0;
    }
    error = gl.GetError();
    if (error != GL_NO_ERROR)
        (void)snprintf(why, PORT_WHY, "GL error 0x%x", error);
    return error == GL_NO_ERROR;
}

bool gl_scene_draw(const char *library, const struct gl_ball *light, struct picture *picture, char *why)
{
    struct port_wish wish = {.device = library, .why = why};
    struct tia_mode mode;
    bool drawn = false;
    void *ctx;

    wish.width = (uint16_t)picture->width;
    wish.height = (uint16_t)picture->height;
    ctx = port_osmesa_create(&wish);
    if (!ctx)
        return false;
    if (!port_osmesa_display.open(ctx, &mode)) {
        drawn = gl_functions_load(ctx, &gl, rows, sizeof rows / sizeof *rows, why) && draw(light, picture, why);
        port_osmesa_display.close(ctx);
    }
    port_osmesa_destroy(ctx);
    return drawn;
}
