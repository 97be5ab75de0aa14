#include "raster.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <tia/raster.h>
#include <time.h>

#define ROUNDS 15
#define LEVELS 6
#define FACES_MAX 100000
#define RANGE 5 /* clip coordinates stay below 32 */

struct point {
    double x, y, z;
};

struct mesh {
    struct point (*corner)[3];
    uint32_t count;
};

static void add(struct mesh *m, struct point a, struct point b, struct point c)
{
    struct point *face = m->corner[m->count++];

    face[0] = a;
    face[1] = b;
    face[2] = c;
}

static void add_quad(struct mesh *m, struct point a, struct point b, struct point c, struct point d)
{
    add(m, a, b, c);
    add(m, a, c, d);
}

static struct point placed(struct point centre, double x, double y, double z)
{
    return (struct point){centre.x + x, centre.y + y, centre.z + z};
}

static const struct point ball_centre = {-1.7, 1.6, 0.2};
#define BALL_RADIUS 1.2

static struct point on_ball(struct point p)
{
    double scale = BALL_RADIUS / sqrt(p.x * p.x + p.y * p.y + p.z * p.z);

    return (struct point){p.x * scale, p.y * scale, p.z * scale};
}

static struct point middle(struct point a, struct point b)
{
    return on_ball((struct point){a.x + b.x, a.y + b.y, a.z + b.z});
}

static void add_ball_part(struct mesh *m, struct point a, struct point b, struct point c, int level)
{
    if (level == 0) {
        add(m, placed(ball_centre, a.x, a.y, a.z), placed(ball_centre, b.x, b.y, b.z),
            placed(ball_centre, c.x, c.y, c.z));
        return;
    }
    struct point ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    add_ball_part(m, a, ab, ca, level - 1);
    add_ball_part(m, b, bc, ab, level - 1);
    add_ball_part(m, c, ca, bc, level - 1);
    add_ball_part(m, ab, bc, ca, level - 1);
}

/* An icosahedron, its faces divided into four `level` times. */
static void add_ball(struct mesh *m, int level)
{
    static const double g = 1.618033988749895;
    static const uint8_t face[20][3] = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                        {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                        {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                        {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    const struct point p[12] = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                                {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};

    for (int i = 0; i < 20; i++)
        add_ball_part(m, on_ball(p[face[i][0]]), on_ball(p[face[i][1]]), on_ball(p[face[i][2]]), level);
}

static struct point on_ring(double u, double v)
{
    static const struct point centre = {0.4, 1.3, 2.0};
    double tau = 6.283185307179586, away = 0.9 + 0.3 * cos(tau * v);
    double x = away * cos(tau * u), z = away * sin(tau * u), y = 0.3 * sin(tau * v);

    return placed(centre, x, y * cos(1.0) - z * sin(1.0), y * sin(1.0) + z * cos(1.0));
}

static void add_ring(struct mesh *m, int around, int across)
{
    for (int i = 0; i < around; i++)
        for (int k = 0; k < across; k++) {
            double u = (double)i / around, v = (double)k / across;
            double next_u = (double)(i + 1) / around, next_v = (double)(k + 1) / across;
            add_quad(m, on_ring(u, v), on_ring(u, next_v), on_ring(next_u, next_v), on_ring(next_u, v));
        }
}

static void add_box(struct mesh *m)
{
    static const uint8_t side[6][4] = {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1},
                                       {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}};
    struct point p[8];

    for (int i = 0; i < 8; i++) {
        double x = i & 4 ? 0.8 : -0.8, y = i & 2 ? 1.7 : 0, z = i & 1 ? 0.7 : -0.7;
        p[i] = (struct point){1.9 + x * cos(0.5) + z * sin(0.5), y, -0.6 - x * sin(0.5) + z * cos(0.5)};
    }
    for (int i = 0; i < 6; i++)
        add_quad(m, p[side[i][0]], p[side[i][1]], p[side[i][2]], p[side[i][3]]);
}

static void make_scene(struct mesh *m, int level)
{
    m->count = 0;
    add_quad(m, (struct point){-12, 0, -12}, (struct point){-12, 0, 12}, (struct point){12, 0, 12},
             (struct point){12, 0, -12});
    add_ball(m, level);
    add_box(m);
    add_ring(m, 8 << level, 4 << level);
}

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

    make_scene(m, level);
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
    struct mesh m = {malloc(sizeof *m.corner * FACES_MAX), 0};

    must(m.corner != NULL);
    printf(
        "\n| size | faces | nearest face, ms | counting behind it, ms | exact comparisons |\n|---|---|---|---|---|\n");
    for (int level = 0; level < LEVELS; level++)
        measure(&m, 640, 480, level);
    for (int level = 0; level < LEVELS; level++)
        measure(&m, 1920, 1080, level);
    free(m.corner);
}
