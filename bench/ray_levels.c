#include "ray_levels.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/scene/scene.h"
#include "common/thread_pool.h"
#include "milliseconds.h"
#include "ray_scenes.h"

#define ROUNDS 5
#define STRIP 16   /* rows that a thread draws at a time */
#define DRAWERS 10 /* at most: plain C, the levels, the last of them in two threads, double precision */

const char *bench_scene;

/* Who draws: a core, by a level or without. */
struct drawer {
    const char *name;
    const struct tia_core *core;
    const struct tia_level *level;
    unsigned threads;
};

struct canvas {
    const struct drawer *by;
    const struct tia_scene *scene;
    uint16_t width, height;
    struct tia_view *view;
    tia_rgb565 *pixels;
    void *view_memory, *level_memory, *hits_memory;
    struct threads *pool;
    struct tia_observer *observer;
    double wall, cpu; /* milliseconds, the least so far */
};

static void must(int status)
{
    if (status) {
        (void)fprintf(stderr, "bench: status %d\n", status);
        exit(1);
    }
}

static size_t strip_hits(const struct canvas *c)
{
    struct tia_tile tile = {0, 0, c->width, STRIP};

    return (c->by->core->hits_size(c->scene, tile) + 63) / 64 * 64;
}

static void begin(struct canvas *c, const struct drawer *by, const struct tia_scene *scene, uint16_t width,
                  uint16_t height)
{
    size_t size = by->core->view_size(scene, scene->light_count);
    size_t more = tia_level_size(by->level, scene, scene->light_count);

    *c = (struct canvas){.by = by, .scene = scene, .width = width, .height = height};
    c->view_memory = ray_scene_memory(size);
    c->level_memory = ray_scene_memory(more);
    c->hits_memory = ray_scene_memory(strip_hits(c) * (height / STRIP + 1u));
    c->pixels = ray_scene_memory(sizeof *c->pixels * width * height);
    c->pool = threads_create(by->threads);
    must(c->pool ? TIA_OK : TIA_ERR_MEMORY);
    must(by->core->view_init(&c->view, c->view_memory, size, scene, scene->light_count, width, height));
    if (by->level)
        must(tia_view_set_level(c->view, by->level, c->level_memory, more));
}

static void end(struct canvas *c)
{
    threads_destroy(c->pool);
    free(c->pixels);
    free(c->hits_memory);
    free(c->level_memory);
    free(c->view_memory);
}

static void draw_strip(void *arg, unsigned index)
{
    const struct canvas *c = arg;
    unsigned y = index * STRIP, left = c->height - y;
    struct tia_tile tile = {0, (uint16_t)y, c->width, (uint16_t)(left < STRIP ? left : STRIP)};
    struct tia_surface surface = {c->pixels + (size_t)y * c->width, sizeof *c->pixels,
                                  (ptrdiff_t)(sizeof *c->pixels * c->width)};
    const struct tia_options options = {.observer = c->observer};
    struct tia_hits *hits;

    must(c->by->core->hits_init(&hits, (char *)c->hits_memory + index * strip_hits(c), strip_hits(c), c->view, tile));
    must(c->by->core->render(c->view, hits, tile, &surface, &options));
}

static void draw(struct canvas *c)
{
    double wall = milliseconds(), cpu = cpu_milliseconds();

    threads_workers.run(c->pool, draw_strip, c, (c->height + STRIP - 1u) / STRIP);
    keep_least(&c->wall, milliseconds() - wall);
    keep_least(&c->cpu, cpu_milliseconds() - cpu);
}

static void count(void *ctx, const struct tia_traced *traced)
{
    (void)traced;
    ++*(double *)ctx;
}

/* How many rays the picture takes, shadow rays included. */
static double rays_of(const struct tia_scene *scene, uint16_t width, uint16_t height)
{
    static const struct drawer watched = {"watched", &tia_core_watched, NULL, 1};
    double rays = 0;
    struct tia_observer observer = {.traced = count, .ctx = &rays};
    struct canvas c;

    begin(&c, &watched, scene, width, height);
    c.observer = &observer;
    draw(&c);
    end(&c);
    return rays;
}

static int find_drawers(struct drawer to[DRAWERS])
{
    const struct tia_level *level;
    int n = 0;

    to[n++] = (struct drawer){"plain", &tia_core_q16, NULL, 1};
    for (unsigned i = 0; (level = tia_level_at(i)) && n < DRAWERS - 2; i++)
        to[n++] = (struct drawer){NULL, &tia_core_q16, level, 1};
    level = to[n - 1].level;
    to[n++] = (struct drawer){NULL, &tia_core_q16, level, 2};
#ifdef TIA_HAVE_F64
    to[n++] = (struct drawer){"f64", &tia_core_f64, NULL, 1};
#endif
    return n;
}

/* All in turns, so that a change of the machine's speed meets all; the pictures must be the same. */
static void measure(const char *name, const struct tia_scene *scene, uint16_t width, uint16_t height)
{
    struct drawer drawers[DRAWERS];
    struct canvas canvas[DRAWERS];
    int n = find_drawers(drawers);
    double rays = rays_of(scene, width, height);

    for (int i = 0; i < n; i++)
        begin(&canvas[i], &drawers[i], scene, width, height);
    for (int round = 0; round < ROUNDS; round++)
        for (int i = 0; i < n; i++)
            draw(&canvas[i]);
    for (int i = 0; i < n; i++) {
        const struct canvas *c = &canvas[i];
        bool same = !memcmp(c->pixels, canvas[0].pixels, sizeof *c->pixels * width * height);
        const char *by = drawers[i].name ? drawers[i].name : tia_view_level(c->view);
        printf("| %s %ux%u | %s%s | %.1f | %.1f | %.0f | %.2f |%s\n", name, width, height, by,
               drawers[i].threads > 1 ? ", 2 threads" : "", c->cpu, c->wall, c->cpu * 1e6 / rays,
               canvas[0].cpu / c->cpu, same || drawers[i].core != &tia_core_q16 ? "" : " OTHER PIXELS");
    }
    (void)fflush(stdout);
    for (int i = 0; i < n; i++)
        end(&canvas[i]);
}

static bool wanted(const char *name)
{
    return !bench_scene || strstr(name, bench_scene);
}

static void measure_file(const char *path, uint16_t width, uint16_t height)
{
    const char *name = strrchr(path, '/') + 1;
    struct scene_file file;

    if (!wanted(name))
        return;
    if (scene_open(&file, path, scene_format_of(path), false)) {
        (void)fprintf(stderr, "bench: %s\n", file.why);
        exit(1);
    }
    measure(name, &file.scene, width, height);
    scene_close(&file);
}

static void measure_made(const char *kind, void (*make)(struct ray_scene *, int), int level, uint32_t count)
{
    struct ray_scene s;
    char name[64];

    if (!wanted(kind))
        return;
    make(&s, level);
    (void)snprintf(name, sizeof name, "%u %s, built in %.0f ms,", count, kind, s.built);
    measure(name, &s.scene, 320, 240);
    ray_scene_free(&s);
}

void bench_ray_levels(void)
{
    static const char *const databases[] = {"balls_1",  "balls_2",   "balls_3", "balls_4", "gears_1",
                                            "jacks_3",  "lattice_3", "mount_3", "rings_3", "shells_2",
                                            "teapot_3", "tetra_4",   "tree_4"};
    static const char *const gallery[] = {"castle", "chess", "flake", "glass", "orrery", "vase"};
    char path[64];

    printf("\n| scene | drawn by | CPU, ms | wall, ms | CPU, ns a ray | plain/this |\n|---|---|--:|--:|--:|--:|\n");
    for (size_t i = 0; i < sizeof databases / sizeof *databases; i++) {
        (void)snprintf(path, sizeof path, "scenes/nff/%s.nff", databases[i]);
        measure_file(path, 640, 480);
    }
    for (size_t i = 0; i < sizeof gallery / sizeof *gallery; i++) {
        (void)snprintf(path, sizeof path, "scenes/%s.tia", gallery[i]);
        measure_file(path, 160, 120);
    }
    for (uint32_t level = 1, n = 10; level <= 5; level++, n = 9 * n + 1)
        measure_made("balls", ray_scene_balls, (int)level, n);
    for (uint32_t level = 2; level <= 7; level++)
        measure_made("triangles", ray_scene_mesh, (int)level, (UINT32_C(84) << 2 * level) + 12);
}
