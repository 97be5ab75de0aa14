#include "simd_rays.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <tia/debug.h>

#include "common/scene/scene_load.h"
#include "common/thread_pool.h"
#include "embree/embree.h"
#include "milliseconds.h"
#include "ray_scenes.h"

#define ROUNDS 5
#define STRIP 16 /* rows that a thread draws at a time */
/* Largest number of drawers: plain C, the instruction sets, the last of these with two threads, double precision, and
 * Embree's ways. */
#define DRAWERS (10 + EMBREE_WAYS)

const char *bench_scene;

/* A drawer: a core, with or without SIMD kernels. `core` is NULL for Embree. */
struct drawer {
    const char *name;
    const struct tia_core *core;
    const struct tia_simd *simd;
    unsigned threads;
    enum embree_way way;
};

/* What drawers are compared with: Embree's single rays, and the fastest of its ways, for each scene. */
enum { OVER_SINGLE, OVER_BEST, RIVALS };

/* Each drawer's time relative to Embree's, for the databases' scenes. */
static struct against {
    char name[32];
    double logarithm[RIVALS]; /* sum of logarithms over all scenes */
    unsigned scenes, lost[RIVALS];
} against[DRAWERS];

struct canvas {
    const struct drawer *by;
    const struct tia_scene *scene;
    uint16_t width, height;
    struct tia_view *view;
    tia_rgb565 *pixels;
    void *view_memory, *simd_memory, *hits_memory;
    struct threads *pool;
    struct tia_observer *observer;
    const struct embree *embree; /* one for all canvases of Embree's ways; NULL: the core draws */
    double wall, cpu;            /* milliseconds, the least so far */
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

    return (c->by->core->hits_size(c->by->core, c->scene, tile) + 63) / 64 * 64;
}

static void begin_core(struct canvas *c)
{
    const struct drawer *by = c->by;
    const struct tia_scene *scene = c->scene;
    size_t size = by->core->view_size(by->core, scene, scene->light_count);
    size_t more = tia_simd_size(by->simd, scene, scene->light_count, 1);

    c->view_memory = ray_scene_memory(size);
    c->simd_memory = ray_scene_memory(more);
    c->hits_memory = ray_scene_memory(strip_hits(c) * (c->height / STRIP + 1u));
    c->pool = threads_create(by->threads);
    must(c->pool ? TIA_OK : TIA_ERR_MEMORY);
    must(by->core->view_init(by->core, &c->view, c->view_memory, size, scene, scene->light_count, c->width, c->height,
                             NULL));
    if (by->simd)
        must(tia_view_set_simd(c->view, by->simd, c->simd_memory, more));
}

static void begin(struct canvas *c, const struct drawer *by, const struct tia_scene *scene, uint16_t width,
                  uint16_t height)
{
    *c = (struct canvas){.by = by, .scene = scene, .width = width, .height = height};
    if (by->core)
        begin_core(c);
    c->pixels = ray_scene_memory(sizeof *c->pixels * width * height);
}

static void end(struct canvas *c)
{
    threads_destroy(c->pool);
    free(c->pixels);
    free(c->hits_memory);
    free(c->simd_memory);
    free(c->view_memory);
}

static void draw_strip(void *arg, unsigned index)
{
    const struct canvas *c = arg;
    unsigned y = index * STRIP, left = c->height - y;
    struct tia_tile tile = {0, (uint16_t)y, c->width, (uint16_t)(left < STRIP ? left : STRIP)};
    struct tia_surface surface = {.pixels = c->pixels + (size_t)y * c->width,
                                  .step = sizeof *c->pixels,
                                  .pitch = (ptrdiff_t)(sizeof *c->pixels * c->width)};
    const struct tia_options options = {.debug = &(struct tia_debug){.observer = c->observer}};
    struct tia_hits *hits;

    must(tia_hits_init(&hits, (char *)c->hits_memory + index * strip_hits(c), strip_hits(c), c->view, tile));
    must(tia_view_draw(c->view, hits, tile, &surface, &options));
}

static void draw(struct canvas *c)
{
    double wall = milliseconds(), cpu = cpu_milliseconds();

    if (c->embree)
        must(embree_draw(c->embree, c->by->way, c->width, c->height, c->pixels) ? TIA_OK : TIA_ERR_MEMORY);
    else
        threads_run(c->pool, draw_strip, c, (c->height + STRIP - 1u) / STRIP);
    keep_least(&c->wall, milliseconds() - wall);
    keep_least(&c->cpu, cpu_milliseconds() - cpu);
}

static void count(void *ctx, const struct tia_traced *traced)
{
    (void)traced;
    ++*(double *)ctx;
}

/* Returns the number of rays of the picture, shadow rays included. */
static double rays_of(const struct tia_scene *scene, uint16_t width, uint16_t height)
{
    static const struct drawer watched = {.name = "watched", .core = &tia_core_watched, .threads = 1};
    double rays = 0;
    struct tia_observer observer = {.traced = count, .ctx = &rays};
    struct canvas c;

    begin(&c, &watched, scene, width, height);
    c.observer = &observer;
    draw(&c);
    end(&c);
    return rays;
}

static int find_drawers(struct drawer to[DRAWERS], bool with_embree)
{
    const struct tia_simd *simd;
    int n = 0;

    to[n++] = (struct drawer){.name = "plain", .core = &tia_core_q16, .threads = 1};
    for (unsigned i = 0; (simd = tia_simd_at(i)) && n < DRAWERS - 2 - EMBREE_WAYS; i++)
        to[n++] = (struct drawer){.core = &tia_core_q16, .simd = simd, .threads = 1};
    simd = to[n - 1].simd;
    to[n++] = (struct drawer){.core = &tia_core_q16, .simd = simd, .threads = 2};
#ifdef TIA_HAVE_F64
    to[n++] = (struct drawer){.name = "f64", .core = &tia_core_f64, .threads = 1};
#endif
    for (int way = EMBREE_WAYS; with_embree && way-- > 0;) /* single rays are the last */
        to[n++] = (struct drawer){.name = embree_ways[way], .threads = 1, .way = (enum embree_way)way};
    return n;
}

/* Returns the fraction of pixels, per mille, whose values differ by more than two levels of red in a channel. */
static double different(const struct canvas *a, const struct canvas *b)
{
    size_t count = (size_t)a->width * a->height, wrong = 0;

    for (size_t i = 0; i < count; i++) {
        int red = (a->pixels[i] >> 11) - (b->pixels[i] >> 11), blue = (a->pixels[i] & 31) - (b->pixels[i] & 31);
        int green = (a->pixels[i] >> 5 & 63) - (b->pixels[i] >> 5 & 63);
        wrong += abs(red) > 2 || abs(green) > 4 || abs(blue) > 2;
    }
    return 1e3 * (double)wrong / (double)count;
}

static void name_of(const struct canvas *c, char name[32])
{
    (void)snprintf(name, 32, "%s%s", c->by->name ? c->by->name : tia_view_simd(c->view),
                   c->by->threads > 1 ? ", 2 threads" : "");
}

static void print(const char *scene, const struct canvas *c, const struct canvas *plain, double rays)
{
    bool same = !memcmp(c->pixels, plain->pixels, sizeof *c->pixels * c->width * c->height);
    char name[32];

    name_of(c, name);
    printf("| %s %ux%u | %s | %.1f | %.1f | %.0f | %.2f |", scene, c->width, c->height, name, c->cpu, c->wall,
           c->cpu * 1e6 / rays, plain->cpu / c->cpu);
    if (c->embree)
        printf(" other pixels: %.1f of 1000", different(c, plain));
    printf("%s\n", same || c->by->core != &tia_core_q16 ? "" : " OTHER PIXELS");
}

/* Compares the drawers of a scene with Embree, whose single rays are the last of `count` canvases. */
static void compare(const struct canvas *canvas, int count)
{
    double embree[RIVALS] = {canvas[count - 1].cpu, canvas[count - 1].cpu};

    for (int i = 0; i < count; i++)
        if (canvas[i].embree)
            keep_least(&embree[OVER_BEST], canvas[i].cpu);
    for (int i = 0; i < count; i++) {
        name_of(&canvas[i], against[i].name);
        for (int rival = 0; rival < RIVALS; rival++) {
            against[i].logarithm[rival] += log(canvas[i].cpu / embree[rival]);
            against[i].lost[rival] += canvas[i].cpu > embree[rival];
        }
        against[i].scenes++;
    }
}

static void print_against(void)
{
    if (!against[0].scenes)
        return;
    printf(
        "\n| drawn by | time over Embree's single rays, geometric mean of %u scenes | slower on | over its fastest way "
        "| slower on |\n|---|--:|--:|--:|--:|\n",
        against[0].scenes);
    for (int i = 0; i < DRAWERS && against[i].scenes; i++) {
        printf("| %s |", against[i].name);
        for (int rival = 0; rival < RIVALS; rival++)
            printf(" %.2f | %u |", exp(against[i].logarithm[rival] / against[i].scenes), against[i].lost[rival]);
        printf("\n");
    }
}

/* Measures all drawers in turns, so that a change of the machine's speed affects all, and reports pixels that differ
 * from the first drawer's, plain C. */
static void measure(const char *name, const struct tia_scene *scene, uint16_t width, uint16_t height, bool database)
{
    struct drawer drawers[DRAWERS];
    struct canvas canvas[DRAWERS];
    struct embree *embree = embree_open(scene); /* NULL where it does not support the scene */
    int n = find_drawers(drawers, embree);
    double rays = rays_of(scene, width, height);

    for (int i = 0; i < n; i++) {
        begin(&canvas[i], &drawers[i], scene, width, height);
        canvas[i].embree = drawers[i].core ? NULL : embree;
    }
    for (int round = 0; round < ROUNDS; round++)
        for (int i = 0; i < n; i++)
            draw(&canvas[i]);
    for (int i = 0; i < n; i++)
        print(name, &canvas[i], &canvas[0], rays);
    if (database && embree)
        compare(canvas, n);
    (void)fflush(stdout);
    for (int i = 0; i < n; i++)
        end(&canvas[i]);
    embree_close(embree);
}

static bool wanted(const char *name)
{
    return !bench_scene || strstr(name, bench_scene);
}

static void measure_file(const char *path, uint16_t width, uint16_t height, bool database)
{
    const char *name = strrchr(path, '/') + 1;
    struct scene_file file;

    if (!wanted(name))
        return;
    if (scene_open(&file, path, scene_format_of(path), false)) {
        (void)fprintf(stderr, "bench: %s\n", file.why);
        exit(1);
    }
    measure(name, &file.scene, width, height, database);
    scene_close(&file);
}

static void measure_made(const char *kind, void (*make)(struct ray_scene *, int), int level, uint32_t count)
{
    struct ray_scene s;
    char name[64];

    if (!wanted(kind))
        return;
    make(&s, level);
    (void)snprintf(name, sizeof name, "%u %s", count, kind);
    printf("| %s | hierarchy built in %.1f ms, by two threads in %.1f, %.1f MB |\n", name, s.built[0], s.built[1],
           (double)s.memory_bytes * 1e-6);
    measure(name, &s.scene, 320, 240, false);
    ray_scene_free(&s);
}

void bench_simd_rays(void)
{
    static const char *const databases[] = {"balls_1",  "balls_2",   "balls_3", "balls_4", "gears_1",
                                            "jacks_3",  "lattice_3", "mount_3", "rings_3", "shells_2",
                                            "teapot_3", "tetra_4",   "tree_4"};
    static const char *const gallery[] = {"castle", "chess", "flake", "glass", "orrery", "vase"};
    char path[64];

    if (!embree_is_there)
        printf("\nbench: no Embree 3: measured without it (apt-get install libembree-dev)\n");
    printf("\n| scene | drawn by | CPU, ms | wall, ms | CPU, ns a ray | plain/this |\n|---|---|--:|--:|--:|--:|\n");
    for (size_t i = 0; i < sizeof databases / sizeof *databases; i++) {
        (void)snprintf(path, sizeof path, "scenes/nff/%s.nff", databases[i]);
        measure_file(path, 640, 480, true);
    }
    print_against();
    printf("\n");
    for (size_t i = 0; i < sizeof gallery / sizeof *gallery; i++) {
        (void)snprintf(path, sizeof path, "scenes/%s.tia", gallery[i]);
        measure_file(path, 160, 120, false);
    }
    for (uint32_t level = 1, n = 10; level <= 5; level++, n = 9 * n + 1)
        measure_made("spheres", ray_scene_balls, (int)level, n);
    for (uint32_t level = 2; level <= 7; level++)
        measure_made("triangles", ray_scene_mesh, (int)level, (UINT32_C(84) << 2 * level) + 12);
}
