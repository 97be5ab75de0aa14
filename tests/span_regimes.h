/* span_regimes.h - pictures of one ball, one caster and one light, with sizes and distances of any magnitude, so that
 * every term of the integers' errors is the largest one in some of them. */
#ifndef TESTS_SPAN_REGIMES_H
#define TESTS_SPAN_REGIMES_H

#include <math.h>

#include <tia/tia.h>

#include "edge_scene.h"
#include "random.h"

struct regime {
    struct tia_scene scene;
    struct tia_material materials[2];
    struct tia_sphere spheres[2]; /* the ball, and the caster */
    struct tia_light light;
    unsigned width, height;
    bool dither;
};

/* Returns a random number from 2^least to 2^most, of any magnitude alike. */
static inline double regime_size(int least, int most)
{
    return exp2(least + (most - least) * fabs(random_double()));
}

static inline tia_q16 regime_q16(double x)
{
    return (tia_q16)(fmax(-17000, fmin(17000, x)) * 65536);
}

static inline struct tia_vec3 regime_at(const double p[3])
{
    return (struct tia_vec3){regime_q16(p[0]), regime_q16(p[1]), regime_q16(p[2])};
}

/* Moves p by up to `size` in any direction. */
static inline void regime_move(double p[3], double size)
{
    for (int i = 0; i < 3; i++)
        p[i] += size * random_double();
}

/* Makes a picture; false if tia refuses the scene. A third of the balls are around the eye if `inside`. */
static inline bool regime_make(struct regime *r, uint64_t seed, bool inside)
{
    static const unsigned sizes[][2] = {{64, 48}, {63, 47}, {640, 7}, {320, 240}, {4000, 3}, {5, 300}};
    double far = regime_size(-4, 13), radius, near, ball[3], light[3], caster[3], share;

    random_state = seed * 77 + 5;
    far = regime_size(-6, 13);
    radius = fmax(far * regime_size(-14, 2), 0x1p-10);
    bool around = inside && random_bits() % 3 == 0;
    near = around ? -far * .9 : far; /* from the eye to the ball's surface */
    radius = around ? fmax(far, 0x1p-10) : radius;
    for (int i = 0; i < 3; i++)
        ball[i] = i < 2 && random_bits() & 1 ? .4 * far * random_double() : 0;
    ball[2] -= near + radius;
    for (int i = 0; i < 3; i++) /* where it is seen, more or less */
        light[i] = caster[i] = ball[i] + (i == 2 ? radius : 0);
    regime_move(light, (random_bits() & 1 ? regime_size(-12, 13) : 0) + radius * random_double());
    share = regime_size(-10, 0);
    for (int i = 0; i < 3; i++)
        caster[i] += (light[i] - caster[i]) * (random_bits() % 8 ? share : share * 2);
    double size = fmax(0x1p-10, regime_size(-10, random_bits() & 1 ? 3 : 12));
    regime_move(caster, size);
    r->materials[0] = (struct tia_material){.colour = TIA_RGB(1, .9, .7)};
    r->materials[1] = (struct tia_material){.colour = TIA_RGB(.3, .6, 1), .emission = TIA_RGB(0, .1, .2)};
    r->spheres[0] = (struct tia_sphere){regime_at(ball), regime_q16(radius), 0};
    r->spheres[1] = (struct tia_sphere){regime_at(caster), regime_q16(size), 1};
    r->light = (struct tia_light){regime_at(light), 0, TIA_RGB(1, 1, 1)};
    r->scene = (struct tia_scene){.materials = r->materials,
                                  .spheres = r->spheres,
                                  .lights = &r->light,
                                  .material_count = 2,
                                  .sphere_count = 2,
                                  .light_count = 1,
                                  .background = TIA_RGB(.2, .1, .05)};
    r->scene.camera.fov = random_bits() % 3 ? TIA_Q16(1) + (tia_q16)(random_u32() % (169u << 16)) : TIA_Q16(90);
    unsigned k = (unsigned)(random_bits() % 6);
    r->width = sizes[k][0];
    r->height = sizes[k][1];
    r->dither = random_bits() % 5 == 0;
    return tia_scene_check(&r->scene, NULL) == TIA_OK;
}

typedef void regimes_try(const char *what, unsigned number, const struct tia_scene *scene, unsigned width,
                         unsigned height, bool dither);

/* Tries `count` edge scenes and as many of the pictures above, without those that tia refuses. */
static inline void regimes_each(unsigned count, regimes_try *try)
{
    static struct edge_scene e;
    static struct regime r;

    for (unsigned i = 1; i <= count; i++) {
        edge_make(&e, i);
        if (!tia_scene_check(&e.scene, NULL))
            try("edge", i, &e.scene, e.width, e.height, e.dither);
        if (regime_make(&r, i, true))
            try("regime", i, &r.scene, r.width, r.height, r.dither);
    }
}

#endif
