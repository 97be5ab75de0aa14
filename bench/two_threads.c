#include "two_threads.h"

#include <malloc.h>
#include <sched.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <tia/tia.h>

#include "checked.h"
#include "common/thread_pool.h"
#include "milliseconds.h"
#include "pixels/pages.h"

enum { ROWS = 16, ROUNDS = 25, FRAMES = 10, STARTS = 15 };

struct frame_size {
    uint16_t width, height;
};

/* Vector units store pictures of the second size past the caches, through the buffers for write-combined memory. */
static const struct frame_size frame_sizes[] = {{1920, 1080}, {3840, 2160}};

/* The data for drawing a frame, and its target. */
struct stage {
    struct frame_size size;
    struct tia_scene scene;
    struct tia_view *view;
    struct tia_hits *hits;
    void *part[4]; /* view, memory of the SIMD kernels, hits, picture */
    bool relit;
};

/* Prepares a stage, with memory allocated as tia does. */
static void set(struct stage *s, struct frame_size size, const struct tia_simd *simd)
{
    const struct tia_tile all = {0, 0, size.width, size.height};

    *s = (struct stage){.size = size, .scene = tia_thesis_scene};
    s->scene.lights = &tia_thesis_scene.bindings[0].state;
    s->scene.light_count = 1;
    size_t view = tia_view_size(&s->scene, 1), more = tia_simd_size(simd, &s->scene, 1, 2);
    size_t hits = tia_hits_size(&s->scene, all);
    s->part[0] = checked(malloc(view));
    s->part[1] = checked(malloc(more + 1));
    s->part[2] = checked(pages_alloc(hits));
    s->part[3] = checked(pages_alloc_cleared((size_t)size.width * size.height * sizeof(tia_rgb565)));
    if (tia_view_init(&s->view, s->part[0], view, &s->scene, 1, size.width, size.height, NULL) ||
        tia_view_set_simd(s->view, simd, s->part[1], more) || tia_hits_init(&s->hits, s->part[2], hits, s->view, all))
        exit(1);
}

static void strike(struct stage *s)
{
    for (int i = 0; i < 4; i++)
        free(s->part[i]);
}

static void strip(void *arg, unsigned index)
{
    const struct stage *s = arg;
    unsigned y = index * ROWS, rows = s->size.height - y < ROWS ? s->size.height - y : ROWS;
    const struct tia_tile tile = {0, (uint16_t)y, s->size.width, (uint16_t)rows};
    const struct tia_surface surface = {
        .pixels = (tia_rgb565 *)s->part[3] + (size_t)y * s->size.width, .step = 2, .pitch = 2 * s->size.width};

    if (s->relit ? tia_view_light(s->view, s->hits, tile, &surface, NULL)
                 : tia_view_draw(s->view, s->hits, tile, &surface, NULL))
        exit(1);
}

static void draw(struct threads *pool, struct stage *s, bool relit)
{
    s->relit = relit;
    threads_run(pool, strip, s, (s->size.height + ROWS - 1u) / ROWS);
}

/* Binds the thread that runs job n to the n-th of the processors that this program may use: a scheduler may put both
 * threads on one processor if they run for only half a millisecond. Each job waits for the other, so that no thread
 * runs both. */
static void settle(void *arg, unsigned index)
{
    atomic_uint *settled = arg;
    cpu_set_t all, own;
    unsigned n = 0;

    CPU_ZERO(&own);
    if (sched_getaffinity(0, sizeof all, &all) == 0)
        for (size_t i = 0; i < CPU_SETSIZE; i++)
            if (CPU_ISSET(i, &all) && n++ == index)
                CPU_SET(i, &own);
    if (n >= 2)
        (void)sched_setaffinity(0, sizeof own, &own);
    atomic_fetch_add(settled, 1u);
    while (atomic_load(settled) < 2)
        (void)sched_yield();
}

/* Wall and CPU time of a frame, in milliseconds. */
struct cost {
    double wall, cpu;
};

/* Measures consecutive frames, as when a key is held down. The first frames are not counted: after them, the other
 * thread spins while it waits for a round, instead of sleeping. */
static void take(struct threads *pool, struct stage *s, bool relit, struct cost *best)
{
    for (int i = 0; i < FRAMES; i++)
        draw(pool, s, relit);
    double wall = milliseconds(), cpu = cpu_milliseconds();
    for (int i = 0; i < FRAMES; i++)
        draw(pool, s, relit);
    keep_least(&best->wall, (milliseconds() - wall) / FRAMES);
    keep_least(&best->cpu, (cpu_milliseconds() - cpu) / FRAMES);
}

/* Measures one thread and two in turns, so that a change of the machine's speed affects both. */
static void measure_frames(struct frame_size size, const struct tia_simd *simd)
{
    struct threads *pool[2] = {checked(threads_create(1)), checked(threads_create(2))};
    struct cost full[2] = {{0, 0}}, relit[2] = {{0, 0}};
    atomic_uint settled = 0;
    cpu_set_t before;
    struct stage s;

    set(&s, size, simd);
    (void)sched_getaffinity(0, sizeof before, &before);
    threads_run(pool[1], settle, &settled, 2);
    for (int i = 0; i < (simd ? ROUNDS : ROUNDS / 5); i++)
        for (int k = 0; k < 2; k++) {
            take(pool[k], &s, false, &full[k]);
            take(pool[k], &s, true, &relit[k]);
        }
    for (int k = 0; k < 2; k++)
        printf("| %s | %u | %.3f | %.3f | %.3f | %.3f | %.2f | %.2f |\n", tia_view_simd(s.view), threads_count(pool[k]),
               full[k].wall, full[k].cpu, relit[k].wall, relit[k].cpu, full[0].wall / full[k].wall,
               relit[0].wall / relit[k].wall);
    (void)fflush(stdout);
    (void)sched_setaffinity(0, sizeof before, &before);
    strike(&s);
    threads_destroy(pool[0]);
    threads_destroy(pool[1]);
}

/* Measures the start-up, with new memory and a new pool each time. */
static void measure_start(const struct tia_simd *simd)
{
    double memory[STARTS], first[STARTS], tenth[STARTS];
    const char *name = "";

    for (int i = 0; i < STARTS; i++) {
        struct stage s;
        double start = milliseconds();
        struct threads *pool = checked(threads_create(2));
        set(&s, frame_sizes[0], simd);
        memory[i] = milliseconds() - start;
        name = tia_view_simd(s.view);
        for (int frame = 1; frame <= 10; frame++) {
            start = milliseconds();
            draw(pool, &s, false);
            *(frame == 1 ? &first[i] : &tenth[i]) = milliseconds() - start;
        }
        strike(&s);
        threads_destroy(pool);
    }
    double m = median(memory, STARTS), f = median(first, STARTS), t = median(tenth, STARTS);
    printf("| %s | %.3f | %.3f | %.3f | %.2f |\n", name, m, f, t, f / t);
    (void)fflush(stdout);
}

void bench_threads(void)
{
    const struct tia_simd *simd = tia_simd_best();

    (void)mallopt(M_MMAP_THRESHOLD, 1 << 20); /* returns freed memory to the system */
    for (size_t i = 0; i < sizeof frame_sizes / sizeof frame_sizes[0]; i++) {
        const struct frame_size size = frame_sizes[i];
        printf("\n| %ux%u | threads | full, ms | CPU | relit, ms | CPU | full, times | relit, times |\n", size.width,
               size.height);
        printf("|---|--:|--:|--:|--:|--:|--:|--:|\n");
        measure_frames(size, NULL);
        if (simd)
            measure_frames(size, simd);
    }
    printf("\n| %ux%u, 2 threads | memory, ms | first frame, ms | tenth | first/tenth |\n", frame_sizes[0].width,
           frame_sizes[0].height);
    printf("|---|--:|--:|--:|--:|\n");
    measure_start(NULL);
    if (simd)
        measure_start(simd);
}
