#include "lightfield.h"

#include <stdio.h>
#include <stdlib.h>

#include <tia/tia.h>

#include "checked.h"
#include "common/scene/scene_load.h"
#include "milliseconds.h"

enum { WIDTH = 640, HEIGHT = 360, ROUNDS = 3 };

static void *memory(size_t size)
{
    return checked(malloc(size ? size : 1));
}

static void must(int status)
{
    if (status) {
        (void)fprintf(stderr, "bench: status %d\n", status);
        exit(1);
    }
}

/* Returns the CPU time of one picture in milliseconds. `simd` NULL: plain C. */
static double draw(const struct tia_scene *scene, const struct tia_simd *simd, uint16_t width, uint16_t height)
{
    const struct tia_tile all = {0, 0, width, height};
    size_t size = tia_view_size(scene, scene->light_count), hits_size = tia_hits_size(scene, all);
    size_t simd_size = tia_simd_size(simd, scene, scene->light_count, 1);
    void *of_view = memory(size), *of_hits = memory(hits_size), *of_simd = memory(simd_size);
    tia_rgb565 *pixels = memory((size_t)width * height * sizeof *pixels);
    const struct tia_surface surface = {.pixels = pixels, .step = 2, .pitch = 2 * width};
    struct tia_view *view;
    struct tia_hits *hits;

    double start = cpu_milliseconds();
    must(tia_view_init(&view, of_view, size, scene, scene->light_count, width, height, NULL));
    must(tia_view_set_simd(view, simd, of_simd, simd_size));
    must(tia_hits_init(&hits, of_hits, hits_size, view, all));
    must(tia_view_draw(view, hits, all, &surface, NULL));
    double ms = cpu_milliseconds() - start;
    free(of_view);
    free(of_hits);
    free(of_simd);
    free(pixels);
    return ms;
}

static void measure(const char *name, const struct tia_scene *scene, const struct tia_light_field *field,
                    const struct tia_simd *simd, unsigned width, unsigned height)
{
    struct tia_scene drawn = *scene;
    double ms = 0, rays = (double)width * height;

    drawn.field = field;
    if (field && field->kind == TIA_LENTICULAR && field->lens.subpixels != TIA_SUBPIXELS_NONE)
        rays *= 3;
    for (int i = 0; i < ROUNDS; i++)
        keep_least(&ms, draw(&drawn, simd, (uint16_t)width, (uint16_t)height));
    printf("| %s | %.0f | %.0f | %.2f |\n", name, rays, ms, ms / rays * 1000);
}

static void measure_all(const struct tia_scene *scene)
{
    static const uint16_t columns[] = {1, 2, 4, 8};
    struct tia_light_field field = {.kind = TIA_QUILT};
    char name[60];

    measure("a view", scene, NULL, NULL, WIDTH, HEIGHT);
    measure("the same by vector units", scene, NULL, tia_simd_best(), WIDTH, HEIGHT);
    for (unsigned i = 0; i < sizeof columns / sizeof *columns; i++) {
        field.quilt = (struct tia_quilt){columns[i], columns[i]};
        (void)snprintf(name, sizeof name, "a quilt of %u views of %ux%u", columns[i] * columns[i], WIDTH / 4,
                       HEIGHT / 4);
        measure(name, scene, &field, NULL, WIDTH / 4u * columns[i], HEIGHT / 4u * columns[i]);
    }
    field.kind = TIA_LENTICULAR;
    field.lens = (struct tia_lenticular){.pitch = INT64_C(41) << 40, .rise = INT64_C(-7) * (INT64_C(1) << 40)};
    measure("a panel, by subpixels", scene, &field, NULL, WIDTH, HEIGHT);
    field.lens.subpixels = TIA_SUBPIXELS_NONE;
    measure("a panel, by pixels", scene, &field, NULL, WIDTH, HEIGHT);
    field.kind = TIA_PROJECTOR;
    field.projector = (struct tia_projector){0, scene->camera.window.near / 2};
    measure("the projector in the middle", scene, &field, NULL, WIDTH, HEIGHT);
}

void bench_light_fields(void)
{
    const char *path = "scenes/lightfield.tia";
    struct scene_file file;

    if (scene_open(&file, path, scene_format_of(path), false)) {
        printf("%s\n", file.why);
        return;
    }
    file.scene.camera.samples = 1;
    printf("\n| light field | rays | ms | us a ray |\n|---|--:|--:|--:|\n");
    measure_all(&file.scene);
    scene_close(&file);
}
