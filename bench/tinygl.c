#include "tinygl.h"

#include <stdio.h>

#ifndef TIA_HAVE_TINYGL
void bench_tinygl(void)
{
    printf("\nTinyGL: not asked for (make bench TINYGL=DIR, with its include and its libTinyGL.a)\n");
}
#else
#include "milliseconds.h"
#include "raster.h"

#include <math.h>
#include <stdlib.h>
#include <tia/raster.h>
#include <zbuffer.h> /* TinyGL's, with its own GL/gl.h */

#define ROUNDS 15

struct corner {
    GLfloat x, y, w;
};

struct picture {
    struct raster_bench exact;
    struct corner (*polygon)[3];
    ZBuffer *buffer;
};

/* Matrix from a corner's x, y and w to clip coordinates, with z = w - 2: the near plane is at 1. TinyGL assumes that
 * the fourth coordinate of its input is 1, so w is passed as the third. */
static const GLfloat from_corner[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, -2, 0};

static void open_picture(struct picture *p, struct mesh *m, int level, uint16_t width, uint16_t height)
{
    raster_bench_init(&p->exact, m, level, width, height, TIA_BUFFER_DEPTH);
    p->polygon = malloc(sizeof *p->polygon * p->exact.count);
    p->buffer = ZB_open(width, height, ZB_MODE_RGBA, NULL);
    raster_bench_must(p->polygon && p->buffer);
    for (uint32_t i = 0; i < p->exact.count; i++)
        for (int k = 0; k < 3; k++) {
            const struct tia_raster_vertex *v = &p->exact.polygon[i][k];
            double one = ldexp(1, p->exact.grid.fraction);
            p->polygon[i][k] = (struct corner){(GLfloat)((double)v->x / one), (GLfloat)((double)v->y / one),
                                               (GLfloat)((double)v->w / one)};
        }
    glInit(p->buffer);
    glMatrixMode(GL_PROJECTION);
    glLoadMatrixf(from_corner);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glShadeModel(GL_FLAT);
    glEnable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glClearColor(1, 1, 1, 1);
}

static void close_picture(struct picture *p)
{
    glClose();
    ZB_close(p->buffer);
    free(p->polygon);
    raster_bench_free(&p->exact);
}

/* Returns the colour that TinyGL converts to `byte`. TinyGL multiplies a colour by 254, adds nearly 1 and rounds
 * down. */
static GLfloat shade(uint32_t byte)
{
    return byte ? ((GLfloat)byte - 0.25f) / 254 : 0;
}

static void draw(const struct picture *p)
{
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glBegin(GL_TRIANGLES);
    for (uint32_t i = 0; i < p->exact.count; i++) {
        const struct corner *c = p->polygon[i];
        glColor3f(shade(i >> 16), shade(i >> 8 & 255), shade(i & 255));
        for (int k = 0; k < 3; k++)
            glVertex3f(c[k].x, c[k].y, c[k].w);
    }
    glEnd();
}

/* Returns the number of pixels where TinyGL does not show the same face as tia. */
static uint32_t differences(const struct picture *p)
{
    const struct tia_raster_target *t = &p->exact.target;
    uint32_t count = 0;

    for (unsigned y = 0; y < t->area.height; y++)
        for (unsigned x = 0; x < t->area.width; x++) {
            size_t at = (size_t)y * t->pitch + x;
            count += (p->buffer->pbuf[(size_t)y * t->area.width + x] & 0xffffff) != (t->face[at] & 0xffffff);
        }
    return count;
}

static void measure(struct mesh *m, uint16_t width, uint16_t height, int level)
{
    double exact = 0, theirs = 0;
    struct picture p;

    open_picture(&p, m, level, width, height);
    for (int round = 0; round < ROUNDS; round++) {
        double start = cpu_milliseconds();
        raster_bench_nearest(&p.exact, &p.exact.target);
        double drawn = cpu_milliseconds();
        draw(&p);
        keep_least(&theirs, cpu_milliseconds() - drawn);
        keep_least(&exact, drawn - start);
    }
    printf("| %ux%u | %u | %.2f | %.2f | %.2f | %u |\n", width, height, p.exact.count, exact, theirs, exact / theirs,
           differences(&p));
    close_picture(&p);
}

void bench_tinygl(void)
{
    struct mesh m = {.corner = malloc(sizeof *m.corner * MESH_FACES_MAX)};

    raster_bench_must(m.corner != NULL);
    printf(
        "\n| size | faces | nearest face, ms | TinyGL, ms | nearest face/TinyGL | pixels where TinyGL has another face "
        "|\n|---|--:|--:|--:|--:|--:|\n");
    for (int level = 0; level < MESH_SIZES; level++)
        measure(&m, 640, 480, level);
    for (int level = 0; level < MESH_SIZES; level++)
        measure(&m, 1920, 1080, level);
    free(m.corner);
}
#endif
