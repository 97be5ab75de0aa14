#include "levels.h"

#include <sched.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <tia/tia.h>

#include "float_lanes.h"
#include "milliseconds.h"

#define ROUNDS 25

/* The best of the rounds: others may run on this machine, and no round is too fast. */
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
    void *p = malloc(size + 1);
    if (!p) {
        (void)fprintf(stderr, "bench: out of memory\n");
        exit(1);
    }
    return p;
}

struct picture {
    struct tia_scene scene;
    struct tia_tile area;
    struct tia_surface surface;
};

static void measure(const struct picture *p, const struct tia_level *level, struct best *full, struct best *relit)
{
    size_t view_size = tia_view_size(&p->scene, 1), more = tia_level_size(level, &p->scene, 1);
    size_t hits_size = tia_hits_size(&p->scene, p->area);
    void *part[3] = {memory(view_size), memory(more), memory(hits_size)};
    struct tia_view *view;
    struct tia_hits *hits;

    if (tia_view_init(&view, part[0], view_size, &p->scene, 1, p->area.width, p->area.height) ||
        tia_view_set_level(view, level, part[1], more) || tia_hits_init(&hits, part[2], hits_size, view, p->area))
        exit(1);
    *full = *relit = (struct best){1e9, 1e9};
    for (int i = 0; i < (level ? ROUNDS : ROUNDS / 5); i++) {
        double wall = milliseconds(), cpu = cpu_milliseconds();
        (void)tia_render(view, hits, p->area, &p->surface, NULL);
        keep(full, wall, cpu);
        wall = milliseconds(), cpu = cpu_milliseconds();
        (void)tia_light_tile(view, hits, p->area, &p->surface, NULL);
        keep(relit, wall, cpu);
    }
    for (int i = 0; i < 3; i++)
        free(part[i]);
}

static struct best lanes(const struct picture *p, int width)
{
    struct best best = {1e9, 1e9};

    for (int i = 0; i < ROUNDS; i++) {
        double wall = milliseconds(), cpu = cpu_milliseconds();
        if (!float_lanes_render(&p->scene, width, p->area.width, p->area.height, p->surface.pixels))
            return (struct best){0, 0};
        keep(&best, wall, cpu);
    }
    return best;
}

static void row(const struct picture *p, const char *name, const struct tia_level *level, int width)
{
    struct best full, relit, floats = width ? lanes(p, width) : (struct best){0, 0};

    measure(p, level, &full, &relit);
    printf("| %ux%u | %s | %.2f | %.2f | %.2f | %.2f |", p->area.width, p->area.height, name, full.wall, full.cpu,
           relit.wall, relit.cpu);
    if (floats.cpu > 0)
        printf(" %.2f | %.2f | %.2f |\n", floats.cpu, full.cpu / floats.cpu, relit.cpu / floats.cpu);
    else
        printf(" | | |\n");
    (void)fflush(stdout);
}

static void pin(void)
{
    cpu_set_t all, one;

    CPU_ZERO(&one);
    if (sched_getaffinity(0, sizeof all, &all))
        return;
    for (size_t i = 0; i < CPU_SETSIZE; i++)
        if (CPU_ISSET(i, &all))
            CPU_SET(i, &one), i = CPU_SETSIZE;
    (void)sched_setaffinity(0, sizeof one, &one);
}

void bench_levels(void)
{
    static const uint16_t sizes[3][2] = {{640, 480}, {1920, 1080}, {3840, 2160}};
    static const struct {
        const char *name;
        int width;
    } known[] = {{"sse41", 4}, {"avx2", 8}, {"avx512", 16}, {"neon", 4}};

    pin();
    printf("\n| size | level | full, ms | CPU | relit, ms | CPU | float lanes, CPU | full/lanes | relit/lanes |\n");
    printf("|---|---|--:|--:|--:|--:|--:|--:|--:|\n");
    for (int i = 0; i < 3; i++) {
        struct picture p = {.scene = tia_thesis_scene, .area = {0, 0, sizes[i][0], sizes[i][1]}};
        size_t bytes = (size_t)sizes[i][0] * sizes[i][1] * 2;
        p.scene.lights = &tia_thesis_scene.bindings[0].state;
        p.scene.light_count = 1;
        p.surface = (struct tia_surface){memory(bytes), 2, 2 * sizes[i][0]};
        memset(p.surface.pixels, 1, bytes);
        row(&p, "plain", NULL, 0);
        for (size_t k = 0; k < sizeof known / sizeof *known; k++) {
            const struct tia_level *level;
            (void)tia_level_called(known[k].name, &level);
            if (level)
                row(&p, known[k].name, level, known[k].width);
        }
        free(p.surface.pixels);
    }
}
