#include "raster.h"

#include "mesh.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <tia/raster.h>
#include <time.h>

#define ROUNDS 15
#define RANGE 5 /* clip coordinates stay below 32 */

/* Seen from (0.5, 4.2, 9) towards (0.2, 0.9, 0.3), 45 degrees high. */
static struct tia_raster_vertex seen(const struct tia_lattice *l, struct point p)
{
    static const double nx = 0.3, ny = 3.3, nz = 8.7, cot = 2.414213562373095;
    double length = sqrt(nx * nx + ny * ny + nz * nz), flat = sqrt(nx * nx + nz * nz);
    double x = p.x - 0.5, y = p.y - 4.2, z = p.z - 9, one = ldexp(1, l->fraction);
    double u = (x * nz - z * nx) / flat, n = (x * nx + y * ny + z * nz) / length;
    double v = (-x * nx * ny + y * flat * flat - z * nz * ny) / flat / length;

    return (struct tia_raster_vertex){llrint(u * cot * l->height / l->width * one), llrint(v * cot * one),
                                      llrint(-n * one), 1};
}

static void must(bool fine)
{
    if (!fine) {
        (void)fprintf(stderr, "bench: the rasteriser failed\n");
        exit(1);
    }
}

static double cpu_ms(void)
{
    return (double)clock() * 1e3 / CLOCKS_PER_SEC;
}

static double drawn(struct tia_raster_target *t, const struct tia_raster_state *state, struct tia_raster_vertex (*v)[3],
                    uint32_t count, bool clear)
{
    double best = 1e9;

    for (int round = 0; round < ROUNDS; round++) {
        double start = cpu_ms();
        if (clear)
            tia_clear_depth(t);
        for (uint32_t i = 0; i < count; i++)
            must(tia_draw_polygon(t, state, v[i], 3, i) == TIA_OK);
        double ms = cpu_ms() - start;
        best = ms < best ? ms : best;
    }
    return best;
}

static const struct tia_raster_state nearest = {.depth = TIA_LESS, .depth_write = true};
/* What is behind counts up, seen from outside, or down. */
static const struct tia_raster_state behind = {
    .depth = TIA_LESS,
    .front = {.test = TIA_ALWAYS, .mask = 255, .write = 255, .zfail = TIA_DECR_WRAP},
    .back = {.test = TIA_ALWAYS, .mask = 255, .write = 255, .zfail = TIA_INCR_WRAP}};

static void measure(struct mesh *m, uint16_t width, uint16_t height, int level)
{
    const struct tia_tile all = {0, 0, width, height};
    struct tia_lattice lattice;
    struct tia_raster_target t;

    bench_mesh(m, level);
    must(tia_lattice_init(&lattice, TIA_PERSPECTIVE, width, height, 1, 0, RANGE) == TIA_OK);
    size_t size = tia_raster_size(all, TIA_BUFFER_DEPTH | TIA_BUFFER_STENCIL, m->count);
    struct tia_raster_vertex(*v)[3] = malloc(sizeof *v * m->count);
    void *memory = malloc(size);
    must(v && memory);
    for (uint32_t i = 0; i < m->count; i++)
        for (int k = 0; k < 3; k++)
            v[i][k] = seen(&lattice, m->corner[i][k]);
    must(tia_raster_init(&t, memory, size, &lattice, all, TIA_BUFFER_DEPTH | TIA_BUFFER_STENCIL, m->count) == TIA_OK);
    struct tia_raster_target depth_alone = t;
    depth_alone.stencil = NULL;
    double depth = drawn(&depth_alone, &nearest, v, m->count, true);
    double count = drawn(&t, &behind, v, m->count, false);
    printf("| %ux%u | %u | %.2f | %.2f | %u |\n", width, height, m->count, depth, count, depth_alone.exact / ROUNDS);
    free(memory);
    free(v);
}

void bench_raster(void)
{
    struct mesh m = {.corner = malloc(sizeof *m.corner * MESH_FACES_MAX)};

    must(m.corner != NULL);
    printf(
        "\n| size | faces | nearest face, ms | counting behind it, ms | exact comparisons |\n|---|---|---|---|---|\n");
    for (int level = 0; level < MESH_LEVELS; level++)
        measure(&m, 640, 480, level);
    for (int level = 0; level < MESH_LEVELS; level++)
        measure(&m, 1920, 1080, level);
    free(m.corner);
}
