/* tia-conform.c - OpenGL beside the exact rasteriser: random triangles with depth and stencil states. docs/conform.md
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "gl/gl_raster.h"
#include "piped.h"
#include "ports.h"
#include "trial.h"

enum { CONFORMS, DIFFERS, USAGE, NO_GL };

struct options {
    const char *library, *by; /* by: a program that draws instead; NULL: none */
    unsigned trials, step;
    uint64_t seed;
};

/* What is compared with the exact rasteriser. */
struct tested {
    trial_drawer *draw;
    void *ctx;
    const char *driver;
};

static const char *const rules[RULES] = {"edges", "ties", "depth", "stencil"};
static const char *const compares[8] = {"never", "less", "equal", "lequal", "greater", "notequal", "gequal", "always"};
static const char *const operations[8] = {"keep", "zero",   "replace",   "incr",
                                          "decr", "invert", "incr_wrap", "decr_wrap"};

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

static void print_face(const char *who, uint32_t face, unsigned stencil)
{
    if (face == TIA_NO_FACE)
        printf("%s no triangle, stencil %u", who, stencil);
    else
        printf("%s triangle %u, stencil %u", who, (unsigned)face, stencil);
}

static void print_side(const char *name, const struct tia_stencil *s)
{
    printf("      %s: %s reference %u mask %02x write %02x, fail %s zfail %s zpass %s\n", name, compares[s->test],
           (unsigned)s->reference, (unsigned)s->mask, (unsigned)s->write, operations[s->fail], operations[s->zfail],
           operations[s->zpass]);
}

static void print_finding(const struct finding *f)
{
    printf("%s: pixel (%u, %u): ", rules[f->rule], f->x, f->y);
    print_face("OpenGL shows", f->face[1], f->stencil[1]);
    print_face("; exact:", f->face[0], f->stencil[0]);
    printf(" (stencil at first %u)\n", (unsigned)f->trial.clear);
    for (unsigned i = 0; i < f->trial.count; i++) {
        const struct triangle *t = &f->trial.triangles[i];
        printf("    triangle %u:", i);
        for (int k = 0; k < 3; k++)
            printf(" (%g, %g)", (double)t->x[k] / 256, (double)t->y[k] / 256);
        printf(" distance %d, depth %s%s%s%s\n", (int)t->level, compares[t->state.depth],
               t->state.depth_write ? "" : ", writes no depth", t->state.skip_front ? ", culls front" : "",
               t->state.skip_back ? ", culls back" : "");
        print_side("front", &t->state.front);
        print_side("back", &t->state.back);
    }
}

/* Draws all trials; prints the smallest finding of each rule, and the numbers. */
static int compare(const struct options *options, const struct tested *tested)
{
    static struct pixels exact, found;
    static struct finding smallest[RULES], finding;
    unsigned long pixels = 0, trials[RULES] = {0};
    uint64_t seed = options->seed;

    for (unsigned i = 0; i < options->trials; i++) {
        struct trial trial;
        unsigned first;
        memset(&trial, 0, sizeof trial);
        trial_random(&trial, &seed, options->step);
        if (!trial_exact(NULL, &trial, &exact) || !tested->draw(tested->ctx, &trial, &found))
            return NO_GL;
        unsigned differing = trial_differs(&exact, &found, &first);
        if (!differing)
            continue;
        pixels += differing;
        if (!trial_shrink(&trial, tested->draw, tested->ctx, &finding)) {
            printf("unsteady: a trial differs only sometimes\n");
            continue;
        }
        if (trials[finding.rule]++ == 0 || finding.trial.count < smallest[finding.rule].trial.count)
            smallest[finding.rule] = finding;
    }
    for (int r = 0; r < RULES; r++)
        if (trials[r])
            print_finding(&smallest[r]);
    printf("%s: %lu of %llu pixels differ; trials by the rule that they break:", tested->driver, pixels,
           (unsigned long long)options->trials * PIXELS);
    for (int r = 0; r < RULES; r++)
        printf(" %s %lu%s", rules[r], trials[r], r + 1 < RULES ? "," : "\n");
    return pixels ? DIFFERS : CONFORMS;
}

static int compare_gl(const struct options *options)
{
    char why[PORT_WHY];
    struct gl_raster *gl = gl_raster_open(options->library, SIDE, SIDE, why);

    if (!gl) {
        (void)fprintf(stderr, "tia-conform: %s\n", why);
        return NO_GL;
    }
    int status = compare(options, &(struct tested){draw_gl, gl, gl_raster_driver()});
    gl_raster_close(gl);
    return status;
}

static int compare_by(const struct options *options)
{
    struct piped *piped = piped_open(options->by);

    if (!piped)
        return NO_GL;
    int status = compare(options, &(struct tested){piped_draw, piped, piped_driver(piped)});
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
            options->trials = (unsigned)value;
        else if (strcmp(argv[i], "--step") == 0 && number(text, 1, 256, &value))
            options->step = (unsigned)value;
        else if (strcmp(argv[i], "--seed") == 0 && number(text, 1, 4294967295, &value))
            options->seed = value;
        else
            return refuse(argv[i]);
    }
    return CONFORMS;
}

int main(int argc, char **argv)
{
    struct options options = {.library = "egl", .trials = 200, .step = 1, .seed = 1};

    if (argc == 2 && (strcmp(argv[1], "-h") == 0 || strcmp(argv[1], "--help") == 0)) {
        printf("usage: tia-conform [options]\n"
               "Draws random triangles by OpenGL and exactly, and prints the fewest that show each difference.\n"
               "      --library egl|osmesa  the library of OpenGL; default egl\n"
               "      --by COMMAND          a program that draws instead, such as bench/conform/webgl.py\n"
               "      --trials N            pictures of 64x64 pixels with 24 triangles; default 200\n"
               "      --step N              corners are multiples of N/256 pixel; default 1, 128 for many ties\n"
               "      --seed N              another row of pictures; default 1\n"
               "Status: 0 no pixel differs, 1 some do, 2 wrong options, 3 no OpenGL.\n");
        return CONFORMS;
    }
    int status = parse(&options, argc, argv);
    if (status)
        return status;
    status = options.by ? compare_by(&options) : compare_gl(&options);
    if (status == NO_GL)
        (void)fprintf(stderr, "tia-conform: OpenGL failed\n");
    return status;
}
