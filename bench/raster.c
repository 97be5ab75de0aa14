#include "raster.h"

#include "milliseconds.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define ROUNDS 15
#define RANGE 5 /* clip coordinates stay below 32 */

/* Projects a point for an eye at (0.5, 4.2, 9) that looks at (0.2, 0.9, 0.3) with a field of view of 45 degrees. */
static struct tia_raster_vertex seen(const struct tia_raster_grid *l, struct point p)
{
    static const double nx = 0.3, ny = 3.3, nz = 8.7, cot = 2.414213562373095;
    double length = sqrt(nx * nx + ny * ny + nz * nz), flat = sqrt(nx * nx + nz * nz);
    double x = p.x - 0.5, y = p.y - 4.2, z = p.z - 9, one = ldexp(1, l->fraction);
    double u = (x * nz - z * nx) / flat, n = (x * nx + y * ny + z * nz) / length;
    double v = (-x * nx * ny + y * flat * flat - z * nz * ny) / flat / length;

    return (struct tia_raster_vertex){llrint(u * cot * l->height / l->width * one), llrint(v * cot * one),
                                      llrint(-n * one), 1};
}

void raster_bench_must(bool fine)
{
    if (!fine) {
        (void)fprintf(stderr, "bench: the rasteriser failed\n");
        exit(1);
    }
}

void raster_bench_init(struct raster_bench *b, struct mesh *m, int level, uint16_t width, uint16_t height,
                       unsigned buffers)
{
    const struct tia_tile all = {0, 0, width, height};

    bench_mesh(m, level);
    b->count = m->count;
    raster_bench_must(tia_raster_grid_init(&b->grid, TIA_PERSPECTIVE, width, height, 1, 0, RANGE) == TIA_OK);
    size_t size = tia_raster_size(all, buffers, m->count);
    b->polygon = malloc(sizeof *b->polygon * m->count);
    b->memory = malloc(size);
    raster_bench_must(b->polygon && b->memory);
    for (uint32_t i = 0; i < m->count; i++)
        for (int k = 0; k < 3; k++)
            b->polygon[i][k] = seen(&b->grid, m->corner[i][k]);
    raster_bench_must(tia_raster_init(&b->target, b->memory, size, &b->grid, all, buffers, m->count) == TIA_OK);
}

void raster_bench_free(struct raster_bench *b)
{
    free(b->memory);
    free(b->polygon);
}

static const struct tia_raster_state nearest = {.depth = TIA_COMPARE_LESS, .depth_write = true};
/* Counts surfaces behind the visible one: up for front faces, down for back faces. */
static const struct tia_raster_state behind = {
    .depth = TIA_COMPARE_LESS,
    .front = {.test = TIA_COMPARE_ALWAYS, .mask = 255, .write = 255, .zfail = TIA_STENCIL_DECR_WRAP},
    .back = {.test = TIA_COMPARE_ALWAYS, .mask = 255, .write = 255, .zfail = TIA_STENCIL_INCR_WRAP}};

static void draw(const struct raster_bench *b, struct tia_raster_target *t, const struct tia_raster_state *state)
{
    for (uint32_t i = 0; i < b->count; i++)
        raster_bench_must(tia_raster_draw(t, state, b->polygon[i], 3, i) == TIA_OK);
}

void raster_bench_nearest(const struct raster_bench *b, struct tia_raster_target *target)
{
    tia_raster_clear_depth(target);
    draw(b, target, &nearest);
}

static void measure(struct mesh *m, uint16_t width, uint16_t height, int level)
{
    double depth = 0, count = 0;
    struct raster_bench b;

    raster_bench_init(&b, m, level, width, height, TIA_BUFFER_DEPTH | TIA_BUFFER_STENCIL);
    struct tia_raster_target depth_alone = b.target;
    depth_alone.stencil = NULL;
    for (int round = 0; round < ROUNDS; round++) {
        double start = cpu_milliseconds();
        raster_bench_nearest(&b, &depth_alone);
        double drawn = cpu_milliseconds();
        draw(&b, &b.target, &behind);
        keep_least(&count, cpu_milliseconds() - drawn);
        keep_least(&depth, drawn - start);
    }
    printf("| %ux%u | %u | %.2f | %.2f | %u |\n", width, height, b.count, depth, count, depth_alone.exact / ROUNDS);
    raster_bench_free(&b);
}

void bench_raster(void)
{
    struct mesh m = {.corner = malloc(sizeof *m.corner * MESH_FACES_MAX)};

    raster_bench_must(m.corner != NULL);
    printf(
        "\n| size | faces | nearest face, ms | counting behind it, ms | exact comparisons |\n|---|---|---|---|---|\n");
    for (int level = 0; level < MESH_SIZES; level++)
        measure(&m, 640, 480, level);
    for (int level = 0; level < MESH_SIZES; level++)
        measure(&m, 1920, 1080, level);
    free(m.corner);
}
