/* float_lanes.c - rays in lanes: gcc's vector extensions, one source for 4, 8 and 16 floats. Roots are the processor's
 * estimate and a Newton step. */
#include "float_lanes.h"

#include <math.h>
#include <string.h>

/* What of the scene a pixel needs. */
struct lanes_world {
    float centre[2][3], c[2], radius2[2], per_radius[2], colour[2][3], light[3], background[3];
    float start, step, up, down; /* v.x of the first pixel and from one to the next; v.y */
};

static void lanes_world(const struct tia_scene *s, int width, int height, struct lanes_world *w)
{
    float a = tanf((float)s->camera.fov / 65536 * 3.14159265f / 360), unit = 1 / 65536.f;

    for (int i = 0; i < 2; i++) {
        const struct tia_sphere *from = &s->spheres[i];
        const struct tia_rgb *m = &s->materials[from->material].colour, *e = &s->lights[0].emission;
        const tia_q16 p[3] = {from->centre.x - s->camera.eye.x, from->centre.y - s->camera.eye.y,
                              from->centre.z - s->camera.eye.z};
        const tia_q30 product[3][2] = {{m->r, e->r}, {m->g, e->g}, {m->b, e->b}};
        double r = (double)from->radius / 65536, c = -r * r;
        for (int k = 0; k < 3; k++) {
            w->centre[i][k] = (float)p[k] * unit;
            c += (double)p[k] * (double)p[k] / 4294967296.0;
            w->colour[i][k] = (float)((double)product[k][0] * (double)product[k][1] / 1152921504606846976.0);
        }
        w->c[i] = (float)c;
        w->radius2[i] = (float)(r * r);
        w->per_radius[i] = (float)(1 / r);
    }
    const struct tia_vec3 *l = &s->lights[0].centre, *eye = &s->camera.eye;
    w->light[0] = (float)(l->x - eye->x) * unit;
    w->light[1] = (float)(l->y - eye->y) * unit;
    w->light[2] = (float)(l->z - eye->z) * unit;
    w->background[0] = (float)s->background.r / 1073741824;
    w->background[1] = (float)s->background.g / 1073741824;
    w->background[2] = (float)s->background.b / 1073741824;
    w->step = 2 * a / (float)height;
    w->start = (1 - (float)width) / 2 * w->step;
    w->down = w->step;
    w->up = ((float)height - 1) / 2 * w->step;
}

#if defined __x86_64__
#include <immintrin.h>
#define LANES 4
#define TARGET __attribute__((target("sse4.1")))
#define GUESS(x) ((F)_mm_rsqrt_ps((__m128)(x)))
#include "float_lanes_loop.h"
#define LANES 8
#define TARGET __attribute__((target("avx2,fma")))
#define GUESS(x) ((F)_mm256_rsqrt_ps((__m256)(x)))
#include "float_lanes_loop.h"
#define LANES 16
#define TARGET __attribute__((target("avx512f,avx512bw,avx512dq,avx512vl,prefer-vector-width=512")))
#define GUESS(x) ((F)_mm512_rsqrt14_ps((__m512)(x)))
#include "float_lanes_loop.h"

bool float_lanes_render(const struct tia_scene *scene, int lanes, int width, int height, tia_rgb565 *pixels)
{
    struct lanes_world w;

    lanes_world(scene, width, height, &w);
    if (lanes == 4 && __builtin_cpu_supports("sse4.1"))
        lanes_draw_4(&w, width, height, pixels);
    else if (lanes == 8 && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
        lanes_draw_8(&w, width, height, pixels);
    else if (lanes == 16 && __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl"))
        lanes_draw_16(&w, width, height, pixels);
    else
        return false;
    return true;
}
#elif defined __aarch64__
#include <arm_neon.h>
#define LANES 4
#define TARGET
#define GUESS(x) ((F)vrsqrteq_f32((float32x4_t)(x)))
#include "float_lanes_loop.h"

bool float_lanes_render(const struct tia_scene *scene, int lanes, int width, int height, tia_rgb565 *pixels)
{
    struct lanes_world w;

    lanes_world(scene, width, height, &w);
    if (lanes == 4)
        lanes_draw_4(&w, width, height, pixels);
    return lanes == 4;
}
#else
bool float_lanes_render(const struct tia_scene *scene, int lanes, int width, int height, tia_rgb565 *pixels)
{
    struct lanes_world w;

    (void)lanes, (void)pixels;
    lanes_world(scene, width, height, &w);
    return false;
}
#endif
