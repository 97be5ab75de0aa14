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

#endif
