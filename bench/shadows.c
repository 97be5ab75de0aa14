#include "shadows.h"

#include "shadow_scene.h"
#include "shadows_gl.h"

#include <stdio.h>
#include <time.h>

#define ROUNDS 15

static double cpu_ms(void)
{
    return (double)clock() * 1e3 / CLOCKS_PER_SEC;
}

static void measure(const struct shadow_scene *s, uint16_t width, uint16_t height)
{
    double ms[SHADOW_PASSES];
    struct shadow_passes p;

    shadow_passes_init(&p, s, width, height);
    for (int i = 0; i < SHADOW_PASSES; i++)
        ms[i] = 1e9;
    for (int round = 0; round < ROUNDS; round++)
        for (int i = 0; i < SHADOW_PASSES; i++) {
            double start = cpu_ms();
            shadow_passes_draw(&p, (enum shadow_pass)i);
            double one = cpu_ms() - start;
            ms[i] = one < ms[i] ? one : ms[i];
        }
    printf("| %ux%u | %u | %.2f | %.2f | %.2f | %.2f |\n", width, height, p.flat.face_count, ms[SHADOW_DEPTH],
           ms[SHADOW_ZFAIL], ms[SHADOW_ZPASS], 1 + ms[SHADOW_ZFAIL] / ms[SHADOW_DEPTH]);
    shadow_passes_free(&p);
}

void bench_shadows(void)
{
    static const uint16_t sizes[2][2] = {{640, 480}, {1920, 1080}};
    struct shadow_scene s;

    shadow_scene_init(&s);
    printf("\n| size | faces | depth, ms | z-fail, ms | z-pass, ms | depth and z-fail/depth |\n"
           "|---|--:|--:|--:|--:|--:|\n");
    for (int i = 0; i < 2; i++)
        for (int level = 0; level < MESH_LEVELS; level++) {
            shadow_scene_make(&s, level);
            measure(&s, sizes[i][0], sizes[i][1]);
        }
    shadow_scene_free(&s);
    bench_shadows_gl("llvmpipe");
    bench_shadows_gl("softpipe");
}
