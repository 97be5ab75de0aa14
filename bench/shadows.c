#include "shadows.h"

#include "milliseconds.h"
#include "shadow_scene.h"
#include "shadows_gl.h"
#include "viewer/strips.h"

#include <stdio.h>

#define ROUNDS 15

static void measure(const struct shadow_scene *s, uint16_t width, uint16_t height)
{
    const struct tia_tile image = {0, 0, width, height};
    unsigned rows = tia_strips_raster_rows(&s->scene, width, height, 1);
    double ms[SHADOW_PASSES] = {0};
    struct shadow_passes p;

    shadow_passes_init(&p, s, image, rows);
    for (int round = 0; round < ROUNDS; round++) {
        double spent[SHADOW_PASSES] = {0};
        for (unsigned y = 0; y < height; y += rows)
            for (int i = 0; i < SHADOW_PASSES; i++)
                shadow_passes_draw(&p, (enum shadow_pass)i, y, &spent[i]);
        for (int i = 0; i < SHADOW_PASSES; i++)
            keep_least(&ms[i], spent[i]);
    }
    printf("| %ux%u | %u | %.2f | %.2f | %.2f | %.2f |\n", width, height, p.flat.face_count, ms[SHADOW_DEPTH],
           ms[SHADOW_ZFAIL], ms[SHADOW_ZPASS], ms[SHADOW_ZFAIL] / ms[SHADOW_DEPTH]);
    shadow_passes_free(&p);
}

static void measure_passes(void)
{
    static const uint16_t sizes[2][2] = {{640, 480}, {1920, 1080}};
    struct shadow_scene s;

    shadow_scene_init(&s);
    printf("\n| size | faces | depth alone, ms | z-fail alone, ms | z-pass alone, ms | z-fail alone/depth alone |\n"
           "|---|--:|--:|--:|--:|--:|\n");
    for (int i = 0; i < 2; i++)
        for (int level = 0; level < MESH_SIZES; level++) {
            shadow_scene_make(&s, level);
            measure(&s, sizes[i][0], sizes[i][1]);
        }
    shadow_scene_free(&s);
}

void bench_shadows(void)
{
    measure_passes();
    bench_shadows_gl("llvmpipe");
    bench_shadows_gl("softpipe");
}
