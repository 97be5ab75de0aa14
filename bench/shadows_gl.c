#include "shadows_gl.h"

#include <stdio.h>

#ifndef TIA_HAVE_LIBOSMESA
void bench_shadows_gl(const char *driver)
{
    printf("\n%s: built without OSMesa (install libosmesa6-dev)\n", driver);
}
#else
#include "gl/raster.h"
#include "ports.h"
#include "shadow_scene.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#define WIDTH 640
#define HEIGHT 480
#define ROUNDS 5

/* ---- what is drawn ---- */

struct drawn {
    struct tia_raster_state state;
    double corner[4][4];
    unsigned count;
    uint32_t face;
};

static struct {
    struct drawn *polygons;
    size_t count, room;
    bool on;
} drawn;

/* The linker puts this before the rasteriser's. */
int __real_tia_draw_polygon(struct tia_raster_target *target, const struct tia_raster_state *state,
                            const struct tia_raster_vertex *corners, unsigned count, uint32_t face);
int __wrap_tia_draw_polygon(struct tia_raster_target *target, const struct tia_raster_state *state,
                            const struct tia_raster_vertex *corners, unsigned count, uint32_t face);

static void keep(const struct tia_lattice *l, const struct tia_raster_state *state,
                 const struct tia_raster_vertex *corners, unsigned count, uint32_t face)
{
    double one = ldexp(1, l->fraction);

    if (drawn.count == drawn.room) {
        drawn.room = 2 * drawn.room + 1024;
        drawn.polygons = realloc(drawn.polygons, drawn.room * sizeof *drawn.polygons);
        shadow_must(drawn.polygons != NULL);
    }
    struct drawn *d = &drawn.polygons[drawn.count++];
    *d = (struct drawn){.state = *state, .count = count, .face = face};
    d->state.colour_write[0] = state->depth_write;
    for (unsigned k = 0; k < count; k++) {
        d->corner[k][0] = (double)corners[k].x / one;
        d->corner[k][1] = (double)corners[k].y / one;
        d->corner[k][3] = (double)corners[k].w / one;
        d->corner[k][2] = d->corner[k][3] - (corners[k].h ? 2 : 0); /* the near plane is at 1 */
    }
}

int __wrap_tia_draw_polygon(struct tia_raster_target *target, const struct tia_raster_state *state,
                            const struct tia_raster_vertex *corners, unsigned count, uint32_t face)
{
    if (drawn.on)
        keep(target->lattice, state, corners, count, face);
    return __real_tia_draw_polygon(target, state, corners, count, face);
}

/* ---- by GL ---- */

static double cpu_ms(void)
{
    return (double)clock() * 1e3 / CLOCKS_PER_SEC;
}

static double draw(struct gl_raster *gl, size_t first, size_t end)
{
    double start = cpu_ms();

    if (first == 0)
        gl_raster_clear(gl, 0);
    for (size_t i = first; i < end; i++) {
        const struct drawn *d = &drawn.polygons[i];
        gl_raster_draw(gl, &d->state, (const double(*)[4])d->corner, d->count, d->face);
    }
    gl_raster_finish();
    return cpu_ms() - start;
}

static void measure(struct gl_raster *gl, const struct shadow_scene *s)
{
    double depth = 1e9, volumes = 1e9;
    struct shadow_passes p;

    shadow_passes_init(&p, s, WIDTH, HEIGHT);
    drawn.count = 0;
    drawn.on = true;
    shadow_passes_draw(&p, SHADOW_DEPTH);
    size_t faces = drawn.count;
    shadow_passes_draw(&p, SHADOW_ZFAIL);
    drawn.on = false;
    for (int round = 0; round < ROUNDS; round++) {
        double ms = draw(gl, 0, faces);
        depth = ms < depth ? ms : depth;
        ms = draw(gl, faces, drawn.count);
        volumes = ms < volumes ? ms : volumes;
    }
    printf("| %ux%u | %u | %.2f | %.2f |\n", WIDTH, HEIGHT, p.flat.face_count, depth, volumes);
    shadow_passes_free(&p);
}

static void measure_all(const char *driver)
{
    static char why[PORT_WHY];
    struct gl_raster *gl = gl_raster_open("osmesa", WIDTH, HEIGHT, why);
    struct shadow_scene s;

    if (!gl || !strstr(gl_raster_driver(), driver)) {
        printf("\n%s: %s\n", driver, gl ? "not in this OSMesa" : why);
        return;
    }
    printf("\n| size, %s | faces | depth and colour, ms | z-fail, ms |\n|---|--:|--:|--:|\n", driver);
    shadow_scene_init(&s);
    for (int level = 0; level < MESH_LEVELS; level++) {
        shadow_scene_make(&s, level);
        measure(gl, &s);
    }
    shadow_scene_free(&s);
    gl_raster_close(gl);
}

/* The driver is chosen before the library is loaded, for good. */
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
