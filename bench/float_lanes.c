/* float_lanes.c - converts the scene to float, and selects the loop that draws it. */
#include "float_lanes.h"

#include <math.h>
#include <string.h>

static float channel(tia_q30 a)
{
    return (float)a / 1073741824;
}

static void place_object(const struct tia_scene *s, int i, const struct tia_vec3 *at, tia_q16 radius,
                         struct lanes_world *w)
{
    const struct tia_vec3 *eye = &s->camera.eye;
    const tia_q16 p[3] = {at->x - eye->x, at->y - eye->y, at->z - eye->z};
    double r = (double)radius / 65536, c = -r * r;

    for (int k = 0; k < 3; k++) {
        w->centre[i][k] = (float)p[k] / 65536;
        c += (double)p[k] * (double)p[k] / 4294967296.0;
    }
    w->c[i] = (float)c;
    w->radius2[i] = (float)(r * r);
    w->per_radius[i] = (float)(1 / r);
}

static tia_rgb565 quantised(const float rgb[3])
{
    return (tia_rgb565)((int)(rgb[0] + .5f) << 11 | (int)(rgb[1] + .5f) << 5 | (int)(rgb[2] + .5f));
}

/* Scales a colour to the levels of RGB565, 31 and 63. */
static void copy_colour(const struct tia_rgb *from, float to[3])
{
    to[0] = 31 * fminf(1, channel(from->r));
    to[1] = 63 * fminf(1, channel(from->g));
    to[2] = 31 * fminf(1, channel(from->b));
}

static void lanes_world(const struct tia_scene *s, int width, int height, struct lanes_world *w)
{
    const struct tia_light *light = &s->lights[0];
    float a = tanf((float)s->camera.fov / 65536 * 3.14159265f / 360);

    for (int i = 0; i < 2; i++) {
        const struct tia_rgb *m = &s->materials[s->spheres[i].material].colour, *e = &light->emission;
        place_object(s, i, &s->spheres[i].centre, s->spheres[i].radius, w);
        w->colour[i][0] = 31 * channel(m->r) * channel(e->r);
        w->colour[i][1] = 63 * channel(m->g) * channel(e->g);
        w->colour[i][2] = 31 * channel(m->b) * channel(e->b);
    }
    place_object(s, 2, &light->centre, light->radius, w);
    copy_colour(&light->emission, w->glow);
    copy_colour(&s->background, w->background);
    for (int i = 0; i < 16; i++)
        w->sky[i] = quantised(w->background);
    w->step = 2 * a / (float)height;
    w->start = (1 - (float)width) / 2 * w->step;
    w->up = ((float)height - 1) / 2 * w->step;
}

bool float_lanes_render(const struct tia_scene *scene, const char *simd, int width, int height, tia_rgb565 *pixels)
{
    static const struct {
        const char *name;
        void (*draw)(const struct lanes_world *, int, int, tia_rgb565 *);
    } loops[] = {
#ifdef TIA_HAVE_SSE41
        {"sse41", float_lanes_sse41},
#endif
#ifdef TIA_HAVE_AVX2
        {"avx2", float_lanes_avx2},
#endif
#ifdef TIA_HAVE_AVX512
        {"avx512", float_lanes_avx512},
#endif
#if defined TIA_HAVE_NEON || defined TIA_HAVE_NEON32
        {"neon", float_lanes_neon},
#endif
#ifdef TIA_HAVE_RVV
        {"rvv", float_lanes_rvv},
#endif
        {"", NULL},
    };
    struct lanes_world w;

    lanes_world(scene, width, height, &w);
    for (size_t i = 0; loops[i].draw; i++)
        if (strcmp(loops[i].name, simd) == 0) {
            loops[i].draw(&w, width, height, pixels);
            return true;
        }
    return false;
}
