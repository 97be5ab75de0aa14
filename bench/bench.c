/* bench.c - milliseconds per frame on one core: a full frame, a frame with only the light moved, and the textbook loop
 * in float. The three are measured in turn, so that a change of the machine's speed affects them alike. Prints the
 * median of each and of their ratios. With a part's name as its argument it measures that part alone: thesis, levels,
 * threads, crowds, rays, simd-rays, paths, radio, raster, tinygl, shadows, shadow-frames, shadow-files or light-fields.
 * For crowds, simd-rays and shadow-files, a second argument selects the scenes whose names contain it. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <tia/tia.h>

#include "checked.h"
#include "crowds.h"
#include "float_loop.h"
#include "lightfield.h"
#include "milliseconds.h"
#include "paths.h"
#include "radio.h"
#include "raster.h"
#include "rays.h"
#include "shadow_frames.h"
#include "shadows.h"
#include "simd.h"
#include "simd_rays.h"
#include "tinygl.h"
#include "two_threads.h"

#define ROUNDS 15

struct frame {
    struct tia_scene scene;
    struct tia_tile area;
    struct tia_view *view;
    struct tia_hits *hits;
    struct tia_surface surface;
};

static void *memory(size_t size)
{
    return checked(malloc(size));
}

/* Prepares the built-in scene. Its light is above left, where key a puts it. */
static void prepare(struct frame *f, uint16_t width, uint16_t height)
{
    size_t view_size, hits_size;

    f->scene = tia_thesis_scene;
    f->scene.lights = &tia_thesis_scene.bindings[0].state;
    f->scene.light_count = 1;
    f->area = (struct tia_tile){0, 0, width, height};
    view_size = tia_view_size(&f->scene, 1);
    hits_size = tia_hits_size(&tia_thesis_scene, f->area);
    if (tia_view_init(&f->view, memory(view_size), view_size, &f->scene, 1, width, height, NULL) ||
        tia_hits_init(&f->hits, memory(hits_size), hits_size, f->view, f->area))
        exit(1);
    f->surface = (struct tia_surface){.pixels = memory((size_t)width * height * 2), .step = 2, .pitch = 2 * width};
}

static void measure(uint16_t width, uint16_t height)
{
    double full[ROUNDS], relit[ROUNDS], plain[ROUNDS], ratio[ROUNDS], saved[ROUNDS];
    struct frame f;

    prepare(&f, width, height);
    for (int i = 0; i < ROUNDS; i++) {
        double start = milliseconds();
        if (tia_view_draw(f.view, f.hits, f.area, &f.surface, NULL))
            exit(1);
        double drawn = milliseconds();
        if (tia_view_light(f.view, f.hits, f.area, &f.surface, NULL))
            exit(1);
        double lit = milliseconds();
        plain_render(&f.scene, width, height, f.surface.pixels);
        plain[i] = milliseconds() - lit;
        full[i] = drawn - start;
        relit[i] = lit - drawn;
        ratio[i] = plain[i] / full[i];
        saved[i] = plain[i] / relit[i];
    }
    printf("| %ux%u | %.1f | %.1f | %.1f | %.2f | %.2f |\n", width, height, median(full, ROUNDS), median(relit, ROUNDS),
           median(plain, ROUNDS), median(ratio, ROUNDS), median(saved, ROUNDS));
}

static void measure_frames(void)
{
    printf("| size | full, ms | relit, ms | plain float, ms | float/full | float/relit |\n");
    printf("|---|---|---|---|---|---|\n");
    measure(640, 480);
    measure(1920, 1080);
}

static const struct part {
    const char *name;
    void (*run)(void);
} parts[] = {{"thesis", measure_frames},
             {"levels", bench_simd},
             {"threads", bench_threads},
             {"crowds", bench_crowds},
             {"rays", bench_rays},
             {"simd-rays", bench_simd_rays},
             {"paths", bench_paths},
             {"radio", bench_radio},
             {"raster", bench_raster},
             {"tinygl", bench_tinygl},
             {"shadows", bench_shadows},
             {"shadow-frames", bench_shadow_frames},
             {"shadow-files", bench_shadow_files},
             {"light-fields", bench_light_fields}};

int main(int argc, char **argv)
{
    bool found = false;

    bench_scene = argc > 2 ? argv[2] : NULL;
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++)
        if (argc < 2 || strcmp(argv[1], parts[i].name) == 0) {
            parts[i].run();
            found = true;
        }
    if (!found)
        (void)fprintf(stderr, "bench: no part of that name: %s\n", argv[1]);
    return found ? 0 : 2;
}
