#include "paths.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <tia/simd.h>
#include <tia/tia.h>

#include "common/scene/scene_load.h"
#include "embree/embree_items.h"
#include "float_paths.h"
#include "milliseconds.h"

enum { SIDE = 128, SPP = 16, ROUNDS = 2, LEVELS = 8 };

/* A drawer and its results: the least CPU time of all rounds, in milliseconds, and the mean of the picture's
 * channels. */
struct run {
    const char *simd;
    double ms, mean[3];
};

static void must(int status)
{
    if (status) {
        (void)fprintf(stderr, "bench: status %d\n", status);
        exit(1);
    }
}

/* Draws sums of samples; `simd` NULL: in plain C. */
static void draw_sums(const struct tia_core *core, const struct tia_estimator *estimator, const struct tia_simd *simd,
                      const struct tia_scene *scene, struct run *run)
{
    static struct tia_sum sums[SIDE * SIDE];
    size_t size = core->view_size(core, scene, scene->light_count),
           more = tia_simd_size(simd, scene, scene->light_count, 1);
    void *memory = malloc(size), *simd_memory = malloc(more + 1);
    struct tia_view *view;

    must(memory && simd_memory ? TIA_OK : TIA_ERR_MEMORY);
    must(core->view_init(core, &view, memory, size, scene, scene->light_count, SIDE, SIDE, NULL));
    if (simd)
        must(tia_view_set_simd(view, simd, simd_memory, more));
    run->simd = tia_view_simd(view);
    memset(sums, 0, sizeof sums);
    double start = cpu_milliseconds();
    must(estimator->sample(view, (struct tia_tile){0, 0, SIDE, SIDE}, 0, SPP, sums, SIDE));
    keep_least(&run->ms, cpu_milliseconds() - start);
    memset(run->mean, 0, sizeof run->mean);
    for (unsigned i = 0; i < SIDE * SIDE * 3; i++)
        run->mean[i % 3] += (double)sums[i / 3].rgb[i % 3] / 16777216 / SPP / SIDE / SIDE;
    free(simd_memory);
    free(memory);
}

static uint64_t draw_floats(const struct float_paths *paths, const struct float_meeting *meeting, struct run *run)
{
    static float rgb[SIDE * SIDE * 3];
    double start = cpu_milliseconds();
    uint64_t rays = float_paths_draw(paths, meeting, SPP, rgb);

    keep_least(&run->ms, cpu_milliseconds() - start);
    memset(run->mean, 0, sizeof run->mean);
    for (unsigned i = 0; i < SIDE * SIDE * 3; i++)
        run->mean[i % 3] += (double)rgb[i] / SIDE / SIDE;
    return rays;
}

static void draw_by_embree(const struct float_paths *paths, struct embree_items *items, struct run *run)
{
    const struct float_meeting meeting = {embree_items_meet, items};

    if (!items)
        return;
    unsigned before = embree_modes_begin();
    (void)draw_floats(paths, &meeting, run);
    embree_modes_end(before);
}

static void print(const char *name, const struct run *run, double rays)
{
    const double samples = (double)SIDE * SIDE * SPP;

    printf(" %s | %.0f | %.0f | %.4f %.4f %.4f |\n", name, samples / run->ms * 1000, run->ms * 1e6 / rays, run->mean[0],
           run->mean[1], run->mean[2]);
}

/* Prints one of the rows below the first, if there was such a run. */
static void print_below(const char *name, const struct run *run, double rays)
{
    if (run->ms > 0) {
        printf("| |");
        print(name, run, rays);
    }
}

/* Returns a copy of the materials without highlights. In the balls scenes, highlights and mirrors together reflect more
 * light than they receive, so the radiance of paths would diverge. */
static struct tia_material *without_highlights(struct tia_scene *scene)
{
    struct tia_material *copy = calloc(scene->material_count + 1, sizeof *copy);

    must(copy ? TIA_OK : TIA_ERR_MEMORY);
    for (uint32_t i = 0; i < scene->material_count; i++) {
        copy[i] = scene->materials[i];
        copy[i].specular = (struct tia_rgb){0, 0, 0};
    }
    scene->materials = copy;
    return copy;
}

/* The path tracers of a scene. */
enum { Q16, F64, FLOATS, EMBREE, LEVEL_FIRST, RUNS = LEVEL_FIRST + LEVELS };

struct tracers {
    const struct tia_scene *scene;
    const struct float_paths *paths;
    struct embree_items *items; /* NULL without Embree */
    struct run run[RUNS];
    double rays;
};

static void draw_all(struct tracers *t)
{
    t->rays = (double)draw_floats(t->paths, NULL, &t->run[FLOATS]);
    draw_by_embree(t->paths, t->items, &t->run[EMBREE]);
    draw_sums(&tia_core_q16, &tia_estimator_q16, NULL, t->scene, &t->run[Q16]);
    for (unsigned k = 0; k < LEVELS && tia_simd_at(k); k++)
        draw_sums(&tia_core_q16, &tia_estimator_q16, tia_simd_at(k), t->scene, &t->run[LEVEL_FIRST + k]);
#ifdef TIA_HAVE_F64
    draw_sums(&tia_core_f64, &tia_estimator_f64, NULL, t->scene, &t->run[F64]);
#endif
}

static void print_all(const char *path, const struct tracers *t)
{
    printf("| `%s`, %.2f rays a sample |", path, t->rays / SIDE / SIDE / SPP);
    print("q16", &t->run[Q16], t->rays);
    for (unsigned k = 0; k < LEVELS && tia_simd_at(k); k++)
        print_below(t->run[LEVEL_FIRST + k].simd, &t->run[LEVEL_FIRST + k], t->rays);
    print_below("f64", &t->run[F64], t->rays);
    print_below("small float tracer", &t->run[FLOATS], t->rays);
    print_below("the same on Embree", &t->run[EMBREE], t->rays);
}

static void measure(const char *path)
{
    struct scene_file file;
    struct tracers t = {0};

    if (scene_open(&file, path, scene_format_of(path), false)) {
        printf("%s\n", file.why);
        return;
    }
    struct tia_material *materials = without_highlights(&file.scene);
    file.scene.integration = (struct tia_integration){.integrator = TIA_PATHS};
    struct float_paths *paths = float_paths_open(&file.scene, SIDE, SIDE);
    must(paths ? TIA_OK : TIA_ERR_UNSUPPORTED);
    t.scene = &file.scene;
    t.paths = paths;
    t.items = embree_items_open(float_paths_world(paths));
    for (int i = 0; i < ROUNDS; i++)
        draw_all(&t);
    print_all(path, &t);
    embree_items_close(t.items);
    float_paths_close(paths);
    scene_close(&file);
    free(materials);
}

/* Measures the path tracers. All have the same estimator, so on average they trace as many rays as the small tracer of
 * float_paths.h, which counts them. */
void bench_paths(void)
{
    printf("\n| paths, %dx%d, %d samples a pixel | | samples/s | ns a ray | mean |\n|---|---|--:|--:|---|\n", SIDE,
           SIDE, SPP);
    measure("scenes/cornell.tia");
    measure("scenes/nff/balls_4.nff");
}
