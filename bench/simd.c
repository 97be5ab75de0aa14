#include "simd.h"

#include <sched.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <tia/tia.h>

#include "checked.h"
#include "float_lanes.h"
#include "float_loop.h"
#include "milliseconds.h"
#include "pixels/pages.h"

#define ROUNDS 25

/* Milliseconds of the fastest round: other programs can slow a round down, but nothing makes one too fast. */
struct best {
    double wall, cpu;
};

static void keep(struct best *best, double wall, double cpu)
{
    wall = milliseconds() - wall;
    cpu = cpu_milliseconds() - cpu;
    best->wall = wall < best->wall ? wall : best->wall;
    best->cpu = cpu < best->cpu ? cpu : best->cpu;
}

static void *memory(size_t size)
{
    return checked(pages_alloc(size + 1));
}

struct picture {
    struct tia_scene scene;
    struct tia_tile area;
    struct tia_surface surface;
};

struct measured {
    struct best full, relit, floats;
};

/* Draws by the float loop in SIMD lanes of the instruction set `simd`, its baseline; in plain C if `simd` is NULL. */
static void draw_floats(const struct picture *p, const char *simd)
{
    if (simd)
        (void)float_lanes_render(&p->scene, simd, p->area.width, p->area.height, p->surface.pixels);
    else
        plain_render(&p->scene, p->area.width, p->area.height, p->surface.pixels);
}

/* Measures full frames, relit frames and the float loop in turns, so that a change of the machine's speed affects them
 * alike. */
static void measure_rounds(const struct picture *p, const char *simd, struct tia_view *view, struct tia_hits *hits,
                           struct measured *m)
{
    *m = (struct measured){{1e9, 1e9}, {1e9, 1e9}, {1e9, 1e9}};
    for (int i = 0; i < (simd ? ROUNDS : ROUNDS / 5); i++) {
        double wall = milliseconds(), cpu = cpu_milliseconds();
        (void)tia_view_draw(view, hits, p->area, &p->surface, NULL);
        keep(&m->full, wall, cpu);
        wall = milliseconds(), cpu = cpu_milliseconds();
        (void)tia_view_light(view, hits, p->area, &p->surface, NULL);
        keep(&m->relit, wall, cpu);
        wall = milliseconds(), cpu = cpu_milliseconds();
        draw_floats(p, simd);
        keep(&m->floats, wall, cpu);
    }
}

static void row(const struct picture *p, const char *name, const struct tia_simd *simd)
{
    size_t view_size = tia_view_size(&p->scene, 1), more = tia_simd_size(simd, &p->scene, 1, 1);
    size_t hits_size = tia_hits_size(&p->scene, p->area);
    void *part[3] = {memory(view_size), memory(more), memory(hits_size)};
    struct tia_view *view;
    struct tia_hits *hits;
    struct measured m;

    if (tia_view_init(&view, part[0], view_size, &p->scene, 1, p->area.width, p->area.height, NULL) ||
        tia_view_set_simd(view, simd, part[1], more) || tia_hits_init(&hits, part[2], hits_size, view, p->area))
        exit(1);
    measure_rounds(p, simd ? name : NULL, view, hits, &m);
    printf("| %ux%u | %s | %.2f | %.2f | %.2f | %.2f | %.2f | %.2f | %.2f | %.2f |\n", p->area.width, p->area.height,
           name, m.full.wall, m.full.cpu, m.relit.wall, m.relit.cpu, m.floats.wall, m.floats.cpu,
           m.full.cpu / m.floats.cpu, m.relit.cpu / m.floats.cpu);
    (void)fflush(stdout);
    for (int i = 0; i < 3; i++)
        free(part[i]);
}

static void pin(const cpu_set_t *all)
{
    cpu_set_t one;

    CPU_ZERO(&one);
    for (size_t i = 0; i < CPU_SETSIZE; i++)
        if (CPU_ISSET(i, all))
            CPU_SET(i, &one), i = CPU_SETSIZE;
    (void)sched_setaffinity(0, sizeof one, &one);
}

void bench_simd(void)
{
    static const uint16_t sizes[3][2] = {{640, 480}, {1920, 1080}, {3840, 2160}};
    static const char *const names[] = {"sse41", "avx2", "avx512", "neon", "rvv", "wasm"};

    cpu_set_t all;
    bool pinned = sched_getaffinity(0, sizeof all, &all) == 0;

    if (pinned)
        pin(&all);
    printf("\n| size | simd | full, ms | CPU | relit, ms | CPU | float, ms | CPU | full/float | relit/float |\n");
    printf("|---|---|--:|--:|--:|--:|--:|--:|--:|--:|\n");
    for (int i = 0; i < 3; i++) {
        struct picture p = {.scene = tia_thesis_scene, .area = {0, 0, sizes[i][0], sizes[i][1]}};
        size_t bytes = (size_t)sizes[i][0] * sizes[i][1] * 2;
        p.scene.lights = &tia_thesis_scene.bindings[0].state;
        p.scene.light_count = 1;
        p.surface = (struct tia_surface){.pixels = memory(bytes), .step = 2, .pitch = 2 * sizes[i][0]};
        memset(p.surface.pixels, 1, bytes);
        const struct tia_simd *last = NULL, *simd;
        row(&p, "plain", NULL);
        for (size_t k = 0; k < sizeof names / sizeof *names; k++) {
            (void)tia_simd_named(names[k], &simd);
            if (simd && simd != last) /* for a set that is missing, tia_simd_named returns a narrower one */
                row(&p, names[k], simd);
            last = simd;
        }
        free(p.surface.pixels);
    }
    if (pinned)
        (void)sched_setaffinity(0, sizeof all, &all);
}
