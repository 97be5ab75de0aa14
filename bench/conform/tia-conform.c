/* tia-conform.c - OpenGL beside the exact rasteriser: random triangles with depth and stencil states. docs/conform.md
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "compare.h"
#include "gl/gl_raster.h"
#include "piped.h"
#include "ports.h"

enum { USAGE = 2, NO_GL = 3 }; /* and those of enum conform_result */

struct options {
    const char *library, *by; /* by: a program that draws instead; NULL: none */
    struct conform_plan plan;
};

static bool draw_gl(void *ctx, const struct trial *trial, struct pixels *pixels)
{
    struct gl_raster *gl = ctx;
    const int64_t one = INT64_C(1) << 20;

    gl_raster_clear(gl, trial->clear);
    for (uint32_t face = 0; face < trial->count; face++) {
        const struct triangle *triangle = &trial->triangles[face];
        double clip[3][4];
        for (int i = 0; i < 3; i++) {
            struct tia_raster_vertex v = trial_vertex(triangle, i, one);
            clip[i][0] = (double)v.x / (double)one;
            clip[i][1] = (double)v.y / (double)one;
            clip[i][2] = (double)(triangle->level * (triangle->level - 8)) / 8; /* z/w: levels an eighth apart */
            clip[i][3] = triangle->level;
        }
        gl_raster_draw(gl, &triangle->state, (const double(*)[4])clip, 3, face);
    }
    return gl_raster_read(gl, pixels->face, pixels->stencil);
}

static void say(void *ctx, const char *text)
{
    (void)ctx;
    (void)fputs(text, stdout);
}

static int compare(const struct options *options, trial_drawer *draw, void *ctx, const char *driver)
{
    const struct conform_tested tested = {draw, ctx, driver, say, NULL};
    int result = conform_compare(&options->plan, &tested);

    return result == CONFORM_FAILED ? NO_GL : result;
}

static int compare_gl(const struct options *options)
{
    char why[PORT_WHY];
    struct gl_raster *gl = gl_raster_open(options->library, SIDE, SIDE, why);

    if (!gl) {
        (void)fprintf(stderr, "tia-conform: %s\n", why);
        return NO_GL;
    }
    int status = compare(options, draw_gl, gl, gl_raster_driver());
    gl_raster_close(gl);
    return status;
}

static int compare_by(const struct options *options)
{
    struct piped *piped = piped_open(options->by);

    if (!piped)
        return NO_GL;
    int status = compare(options, piped_draw, piped, piped_driver(piped));
    piped_close(piped);
    return status;
}

static int refuse(const char *what)
{
    (void)fprintf(stderr, "tia-conform: %s (tia-conform -h)\n", what);
    return USAGE;
}

static bool number(const char *text, unsigned long least, unsigned long most, unsigned long *value)
{
    char *end;

    *value = strtoul(text, &end, 10);
    return *text >= '0' && *text <= '9' && !*end && *value >= least && *value <= most;
}

static int parse(struct options *options, int argc, char **argv)
{
    for (int i = 1; i < argc; i += 2) {
        unsigned long value = 0;
        const char *text = i + 1 < argc ? argv[i + 1] : "";
        if (strcmp(argv[i], "--library") == 0 && (strcmp(text, "osmesa") == 0 || strcmp(text, "egl") == 0))
            options->library = text;
        else if (strcmp(argv[i], "--by") == 0 && *text)
            options->by = text;
        else if (strcmp(argv[i], "--trials") == 0 && number(text, 1, 1000000, &value))
            options->plan.trials = (unsigned)value;
        else if (strcmp(argv[i], "--step") == 0 && number(text, 1, 256, &value))
            options->plan.step = (unsigned)value;
        else if (strcmp(argv[i], "--seed") == 0 && number(text, 1, 4294967295, &value))
            options->plan.seed = value;
        else
            return refuse(argv[i]);
    }
    return CONFORM_SAME;
}

int main(int argc, char **argv)
{
    struct options options = {.library = "egl", .plan = {.trials = 200, .step = 1, .seed = 1}};

    if (argc == 2 && (strcmp(argv[1], "-h") == 0 || strcmp(argv[1], "--help") == 0)) {
        printf("usage: tia-conform [options]\n"
               "Draws random triangles by OpenGL and exactly, and prints the fewest that show each difference.\n"
               "      --library egl|osmesa  the library of OpenGL; default egl\n"
               "      --by COMMAND          a program that draws instead, such as bench/conform/webgl.py\n"
               "      --trials N            pictures of 64x64 pixels with 24 triangles; default 200\n"
               "      --step N              corners are multiples of N/256 pixel; default 1, 128 for many ties\n"
               "      --seed N              another row of pictures; default 1\n"
               "Status: 0 no pixel differs, 1 some do, 2 wrong options, 3 no OpenGL.\n");
        return CONFORM_SAME;
    }
    int status = parse(&options, argc, argv);
    if (status)
        return status;
    status = options.by ? compare_by(&options) : compare_gl(&options);
    if (status == NO_GL)
        (void)fprintf(stderr, "tia-conform: OpenGL failed\n");
    return status;
}
