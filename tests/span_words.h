/* span_words.h - the cosines of words.h against 113 bits, for test_span_error.c. */
#ifndef TESTS_SPAN_WORDS_H
#define TESTS_SPAN_WORDS_H

#include "render/span/words/words.h"

/* Tries a light as words_lights() adds it. */
static void try_words(struct span_shading *s, const struct seen pixels[], const struct light_source *source,
                      const struct light_line *line)
{
    num_u lambert[CHUNK];
    struct word_light light = {.lambert = lambert};
    struct word_points points;

    if (source->sphere->c <= 0)
        return;
    words_points(&s->spans->primary, source->sphere, s->span->x, s->span->y, s->span->t, s->span->count, &points);
    if (!words_light(&points, source, line, &s->error, &light))
        return;
    for (int i = 0; i < s->span->count; i++) {
        quad cosine = pixels[i].way.cosine > 0 ? pixels[i].way.cosine : 0;
        if (!(light.open & PIXEL_BIT(i)))
            use(&bounds[WORDS], (real)(lambert[i] * (quad)0x1p-30 - cosine), light.doubt * 0x1p-30L);
    }
}

/* Returns a scene with a light close above a ground: along a row |w|^2 falls to a small part of itself, and rises
 * again. It is valid until the next call. */
static const struct tia_scene *close_light(void)
{
    static const struct tia_material grey = {.colour = TIA_RGB(.5, .5, .5)};
    static struct tia_sphere ground;
    static struct tia_light light;
    static const struct tia_scene scene = {.materials = &grey,
                                           .spheres = &ground,
                                           .lights = &light,
                                           .material_count = 1,
                                           .sphere_count = 1,
                                           .light_count = 1,
                                           .camera = {.fov = TIA_Q16(50)}};
    double r = exp2(3 + 6 * fabs(random_double())), x = 2 * random_double(), z = -6 + 3 * random_double();
    double y = sqrt(r * r - x * x - (z + 6) * (z + 6)) - r - 1 + exp2(-5 + 5 * random_double());

    ground = (struct tia_sphere){{0, (int32_t)lround(65536 * (-r - 1)), TIA_Q16(-6)}, (int32_t)lround(65536 * r), 0};
    light = (struct tia_light){
        .centre = {(int32_t)lround(65536 * x), (int32_t)lround(65536 * y), (int32_t)lround(65536 * z)},
        .emission = TIA_RGB(1, 1, 1)};
    return &scene;
}

#endif
