#include "shadows_gl.h"

#include <stdio.h>

#ifndef TIA_HAVE_LIBOSMESA
void bench_shadows_gl(const char *driver)
{
    printf("\n%s: built without OSMesa (install libosmesa6-dev)\n", driver);
}
#else
#include "gl/gl_raster.h"
#include "milliseconds.h"
#include "ports.h"
#include "shadow_scene.h"
#include "viewer/strips.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <tia/raster.h>
#include <unistd.h>

#define ROUNDS 7
/* Time in milliseconds after which no further round begins, from the third on; llvmpipe compiles its shaders in the
 * first round. */
#define PATIENCE 500

/* ---- recording ---- */

struct drawn {
    double corner[4][4];
    unsigned count;
    uint32_t face;
};

/* Recorded polygons; those of a pass have one state. */
static struct {
    struct tia_raster_state state[SHADOW_PASSES];
    enum shadow_pass pass;
    struct drawn *polygons;
    size_t count, room;
    bool on;
} drawn;

/* The rasteriser's own function, under the name that the linker's option --wrap gives it. */
int __real_tia_raster_draw(struct tia_raster_target *target, const struct tia_raster_state *state,
                           const struct tia_raster_vertex *corners, unsigned count, uint32_t face);
/* The function that --wrap calls in place of the rasteriser's own: it also records the polygon. */
int __wrap_tia_raster_draw(struct tia_raster_target *target, const struct tia_raster_state *state,
                           const struct tia_raster_vertex *corners, unsigned count, uint32_t face);

static void keep(const struct tia_raster_grid *l, const struct tia_raster_state *state,
                 const struct tia_raster_vertex *corners, unsigned count, uint32_t face)
{
    double one = ldexp(1, l->fraction);

    if (drawn.count == drawn.room) {
        drawn.room = 2 * drawn.room + 1024;
        drawn.polygons = realloc(drawn.polygons, drawn.room * sizeof *drawn.polygons);
        shadow_must(drawn.polygons != NULL);
    }
    struct drawn *d = &drawn.polygons[drawn.count++];
    *d = (struct drawn){.count = count, .face = face};
    drawn.state[drawn.pass] = *state;
    drawn.state[drawn.pass].colour_write[0] = state->depth_write;
    for (unsigned k = 0; k < count; k++) {
        d->corner[k][0] = (double)corners[k].x / one;
        d->corner[k][1] = (double)corners[k].y / one;
        d->corner[k][3] = (double)corners[k].w / one;
        d->corner[k][2] = d->corner[k][3] - (corners[k].h ? 2 : 0); /* the near plane is at 1 */
    }
}

int __wrap_tia_raster_draw(struct tia_raster_target *target, const struct tia_raster_state *state,
                           const struct tia_raster_vertex *corners, unsigned count, uint32_t face)
{
    if (drawn.on)
        keep(target->grid, state, corners, count, face);
    return __real_tia_raster_draw(target, state, corners, count, face);
}

/* ---- drawing by GL ---- */

static double draw(struct gl_raster *gl, enum shadow_pass pass, size_t first, size_t end)
{
    double start = cpu_milliseconds();

    if (pass == SHADOW_DEPTH)
        gl_raster_clear(gl, 0);
    gl_raster_begin(gl, &drawn.state[pass]);
    for (size_t i = first; i < end; i++) {
        const struct drawn *d = &drawn.polygons[i];
        gl_raster_polygon(gl, (const double(*)[4])d->corner, d->count, d->face);
    }
    gl_raster_end(gl);
    gl_raster_finish();
    return cpu_milliseconds() - start;
}

/* Records the passes over a whole image. Returns the number of polygons of the first. */
static size_t record(const struct shadow_scene *s, struct tia_tile image)
{
    struct shadow_passes p;
    size_t faces = 0;
    double ms = 0;

    shadow_passes_init(&p, s, image, image.height);
    drawn.count = 0;
    drawn.on = true;
    for (int pass = SHADOW_DEPTH; pass <= SHADOW_ZFAIL; pass++) {
        faces = drawn.count;
        drawn.pass = (enum shadow_pass)pass;
        shadow_passes_draw(&p, drawn.pass, 0, &ms);
    }
    drawn.on = false;
    shadow_passes_free(&p);
    return faces;
}

/* Milliseconds of tia's rasteriser and of GL. */
struct times {
    double depth[2], zfail[2];
};

static void time_once(struct gl_raster *gl, struct shadow_passes *p, size_t faces, struct times *least)
{
    double depth = 0, zfail = 0;

    for (unsigned y = 0; y < p->target.area.height; y += p->rows) {
        shadow_passes_draw(p, SHADOW_DEPTH, y, &depth);
        shadow_passes_draw(p, SHADOW_ZFAIL, y, &zfail);
    }
    keep_least(&least->zfail[0], zfail);
    keep_least(&least->depth[0], depth);
    keep_least(&least->depth[1], draw(gl, SHADOW_DEPTH, 0, faces));
    keep_least(&least->zfail[1], draw(gl, SHADOW_ZFAIL, faces, drawn.count));
}

static void measure(struct gl_raster *gl, const struct shadow_scene *s, const uint16_t size[2])
{
    const struct tia_tile image = {0, 0, size[0], size[1]};
    size_t faces = record(s, image);
    struct times t = {{0, 0}, {0, 0}};
    struct shadow_passes p;

    shadow_passes_init(&p, s, image, tia_strips_raster_rows(&s->scene, size[0], size[1], 1));
    double start = cpu_milliseconds();
    for (int round = 0; round < 2 || (round < ROUNDS && cpu_milliseconds() - start < PATIENCE); round++)
        time_once(gl, &p, faces, &t);
    printf("| %ux%u | %u | %.2f | %.2f | %.2f | %.2f | %.2f | %.2f |\n", size[0], size[1], p.flat.face_count,
           t.depth[0], t.depth[1], t.depth[0] / t.depth[1], t.zfail[0], t.zfail[1], t.zfail[0] / t.zfail[1]);
    shadow_passes_free(&p);
}

static bool measure_size(const char *driver, struct shadow_scene *s, const uint16_t size[2])
{
    static char why[PORT_WHY];
    struct gl_raster *gl = gl_raster_open("osmesa", size[0], size[1], why);

    if (!gl || !strstr(gl_raster_driver(), driver)) {
        printf("\n%s: %s\n", driver, gl ? "not in this OSMesa" : why);
        return false;
    }
    printf("\n| size | faces | depth, ms | %s with colour, ms | depth/%s | z-fail, ms | %s, ms | z-fail/%s |\n"
           "|---|--:|--:|--:|--:|--:|--:|--:|\n",
           driver, driver, driver, driver);
    for (int level = 0; level < MESH_SIZES; level++) {
        shadow_scene_make(s, level);
        measure(gl, s, size);
        (void)fflush(stdout);
    }
    gl_raster_close(gl);
    return true;
}

static void measure_all(const char *driver)
{
    static const uint16_t sizes[2][2] = {{640, 480}, {1920, 1080}};
    struct shadow_scene s;

    shadow_scene_init(&s);
    if (measure_size(driver, &s, sizes[0]))
        (void)measure_size(driver, &s, sizes[1]);
    shadow_scene_free(&s);
}

/* Measures one driver in a process of its own: a driver must be chosen before the library is loaded, and the library is
 * never unloaded. */
void bench_shadows_gl(const char *driver)
{
    (void)fflush(stdout);
    pid_t child = fork();

    if (child == 0) {
        (void)setenv("GALLIUM_DRIVER", driver, 1);
        (void)setenv("LP_NUM_THREADS", "0", 1);
        (void)setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
        measure_all(driver);
        (void)fflush(stdout);
        _exit(0);
    }
    shadow_must(child > 0 && waitpid(child, NULL, 0) == child);
}
#endif
