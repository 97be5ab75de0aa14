#include "rays.h"

#include <stdio.h>
#include <stdlib.h>

#include "common/scene/scene_load.h"
#include "milliseconds.h"

#define WIDTH 640
#define HEIGHT 480
#define ROUNDS 3

static const struct tia_tile area = {0, 0, WIDTH, HEIGHT};

static void must(int status)
{
    if (status) {
        (void)fprintf(stderr, "bench: status %d\n", status);
        exit(1);
    }
}

/* Returns the milliseconds for one frame, including tia_view_init. */
static double draw(const struct tia_core *core, const struct tia_scene *scene)
{
    size_t view_size = core->view_size(core, scene, scene->light_count), hits_size = core->hits_size(core, scene, area);
    void *memory[2] = {malloc(view_size), malloc(hits_size)};
    tia_rgb565 *pixels = malloc(sizeof *pixels * WIDTH * HEIGHT);
    struct tia_surface surface = {.pixels = pixels, .step = sizeof *pixels, .pitch = sizeof *pixels * WIDTH};
    struct tia_view *view;
    struct tia_hits *hits;
    double start = milliseconds();

    must(memory[0] && memory[1] && pixels ? TIA_OK : TIA_ERR_MEMORY);
    must(core->view_init(core, &view, memory[0], view_size, scene, scene->light_count, WIDTH, HEIGHT, NULL));
    must(tia_hits_init(&hits, memory[1], hits_size, view, area));
    must(tia_view_draw(view, hits, area, &surface, NULL));
    double end = milliseconds();
    free(memory[0]);
    free(memory[1]);
    free(pixels);
    return end - start;
}

static double best(const struct tia_core *core, const struct tia_scene *scene)
{
    double least = draw(core, scene);

    for (int i = 1; i < ROUNDS; i++) {
        double ms = draw(core, scene);
        least = ms < least ? ms : least;
    }
    return least;
}

static void measure(const char *path)
{
    struct scene_file file;
    double start = milliseconds();

    if (scene_open(&file, path, scene_format_of(path), false)) {
        printf("%s\n", file.why);
        return;
    }
    double read = milliseconds() - start, q16 = best(&tia_core_q16, &file.scene);
    printf("| `%s` | %u | %.1f | %.0f |", path, (unsigned)file.scene.sphere_count, read, q16);
#ifdef TIA_HAVE_F64
    printf(" %.0f |", best(&tia_core_f64, &file.scene));
#endif
    printf("\n");
    scene_close(&file);
}

/* Measures reading a scene file of a megabyte: spheres in rows. */
static void measure_reading(void)
{
    const size_t most = 1 << 20;
    char *text = malloc(most + 64);
    static const char view[] = "v\nfrom 50 50 200\nat 50 50 0\nup 0 1 0\nangle 40\nhither 1\nresolution 640 480\n";
    struct tia_reader reader = {.format = TIA_FORMAT_NFF, .text = text};
    struct tia_scene scene;
    void *memory;
    size_t need;

    must(text ? TIA_OK : TIA_ERR_MEMORY);
    reader.length = (size_t)sprintf(text, "%s", view);
    for (unsigned i = 0; reader.length < most; i++)
        reader.length += (size_t)sprintf(text + reader.length, "s %u.%02u %u %u 0.1%04u\n", i % 100, i % 97,
                                         i / 100 % 100, i / 10000, i % 9973);
    double start = milliseconds();
    must(tia_read(&reader, &scene, NULL, 0, &need) == TIA_ERR_MEMORY ? TIA_OK : TIA_ERR_RANGE);
    memory = malloc(need);
    must(memory ? tia_read(&reader, &scene, memory, need, &need) : TIA_ERR_MEMORY);
    double read = milliseconds() - start;
    size_t size = tia_bvh_size(&scene);
    void *boxes = malloc(size);
    must(boxes ? tia_bvh_build(&scene.bvh, boxes, size, NULL, &scene, NULL) : TIA_ERR_MEMORY);
    printf("\n%u spheres in %.1f MB of text: read in %.0f ms, hierarchy built in %.0f ms.\n",
           (unsigned)scene.sphere_count, (double)reader.length / 1e6, read, milliseconds() - start - read);
    free(boxes);
    free(memory);
    free(text);
}

void bench_rays(void)
{
    printf("\n| scene, %dx%d | spheres | read, ms | q16, ms |", WIDTH, HEIGHT);
#ifdef TIA_HAVE_F64
    printf(" f64, ms |\n|---|--:|--:|--:|--:|\n");
#else
    printf("\n|---|--:|--:|--:|\n");
#endif
    measure("scenes/nff/balls_1.nff");
    measure("scenes/nff/balls_2.nff");
    measure("scenes/nff/balls_3.nff");
    measure("scenes/nff/balls_4.nff");
    measure_reading();
}
