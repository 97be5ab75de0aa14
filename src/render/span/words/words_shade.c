/* words_shade.c - a light on a span: by words where it is certain what blocks it, elsewhere by the kernels. */
#include "words_shade.h"
#include "words.h"

#include "math/noinline.h"
#include "render/span/span_parts.h"
#include "render/span/span_shade.h"

#define OPEN_MOST 4          /* a choice: with more open pixels in a span, the kernels take less */
#define NO_ERROR (-64 * 256) /* a binary logarithm in 256ths */

/* ---- sums ---- */

static num_u greatest(num_u r, num_u g, num_u b)
{
    num_u larger = r > g ? r : g;

    return larger > b ? larger : b;
}

static void clamp_sums(struct span_shading *s)
{
    for (int c = 0; c < 3; c++)
        for (int i = 0; i < s->span->count; i++)
            s->sum[c][i] = num_clamp(s->sum[c][i]);
    s->most = NUM_ONE;
}

static inline num_u share(num_u part, uint32_t factor)
{
    return (num_u)words_high((uint32_t)part, factor);
}

/* Returns a colour of up to 1 times 2^32, at most 1 too small. */
static uint32_t factor_of(num_u colour)
{
    return colour >= NUM_ONE ? UINT32_MAX : (uint32_t)colour << 2;
}

/* Adds a grey light. */
static void add_uncoloured(num_u *sum, const num_u *lambert, int count, uint32_t factor)
{
    const num_u *const end = lambert + count;

    do
        *sum++ += share(*lambert++, factor);
    while (lambert < end);
}

bool words_add(struct span_shading *s, const num_u *lambert, const struct tia_light *light, const num_u product[3])
{
    const uint32_t factor[3] = {(uint32_t)product[0] << 2, (uint32_t)product[1] << 2, (uint32_t)product[2] << 2};
    num_u most = greatest(product[0], product[1], product[2]);

    if (s->uncoloured) {
        add_uncoloured(s->sum[0], lambert, s->span->count, factor_of(num_colour(light->emission.r)));
        return true;
    }
    if (s->grey || most >= NUM_ONE) {
        s->most = NUM_ONE; /* as the kernels clamp the sums */
        return false;
    }
    for (int i = 0; i < s->span->count; i++) {
        num_u cosine = lambert[i];
        s->sum[0][i] += share(cosine, factor[0]);
        s->sum[1][i] += share(cosine, factor[1]);
        s->sum[2][i] += share(cosine, factor[2]);
    }
    s->most += most;
    if (s->most > NUM_ONE)
        clamp_sums(s);
    return true;
}

/* Multiplies the light by the material's colour. Of a channel's error by all lights, 3 each in num_light_doubt, this
 * and the sum of words that are cut off take one for each light and two more. */
static void colour_sums(struct span_shading *s)
{
    const struct tia_rgb *colour = &s->material->colour, *emission = &s->material->emission;
    const uint32_t factor[3] = {factor_of(num_colour(colour->r)), factor_of(num_colour(colour->g)),
                                factor_of(num_colour(colour->b))};
    const num_u least[3] = {num_colour(emission->r), num_colour(emission->g), num_colour(emission->b)};

    for (int i = 0; i < ((s->span->count + 7) & ~7); i++) {
        num_u light = s->sum[0][i];
        s->sum[0][i] = num_clamp(least[0] + share(light, factor[0]));
        s->sum[1][i] = num_clamp(least[1] + share(light, factor[1]));
        s->sum[2][i] = num_clamp(least[2] + share(light, factor[2]));
    }
}

/* ---- shadows ---- */

/* Returns the part that a pixel belongs to. */
static enum span_part part_at(const struct span_shading *s, uint32_t light, int at)
{
    const struct shaded_span *span = s->span;
    const struct span_casters *casters = &s->spans->casters;
    struct coarse_ball point;
    enum span_part part = SPAN_LIT;

    (void)span_coarse_point(&s->spans->primary, &s->spans->spheres[span->object], span->x + at, span->y, span->t[at],
                            s->shadows.doubt, &point);
    for (uint32_t j = 0; (j = span_next_in(casters, s->shadows.near, j)) < casters->count && part != SPAN_DARK; j++) {
        enum span_part by = span_part_of(casters, &point, light, j);
        part = by == SPAN_LIT ? part : by;
    }
    return part;
}

/* Sets the cosines of dark pixels to 0, and adds those pixels to the open ones that are too near to the edge of a
 * shadow; false if these are many. Parts that are open are decided pixel by pixel. */
static NOINLINE bool cast_shadows(const struct span_shading *s, uint32_t light, struct word_light *words)
{
    int left = OPEN_MOST;

    for (int at = words->first; at <= words->last; at++) {
        enum span_part part = (enum span_part)s->shadows.part[at / SHADOW_PART];
        if (part == SPAN_LIT)
            at |= SHADOW_PART - 1;
        if (part == SPAN_OPEN)
            part = part_at(s, light, at);
        if (part == SPAN_DARK)
            words->lambert[at] = 0;
        if (part == SPAN_OPEN) {
            words->open |= PIXEL_BIT(at);
            if (left-- == 0)
                return false;
        }
    }
    return true;
}

/* Adds a light that is prepared; false if the kernels are to do it. `lambert` is room for its cosines. */
static bool shade_by_words(struct span_shading *s, const struct word_points *points, const struct light_source *source,
                           const struct light_line *line, num_u *lambert)
{
    struct word_light words = {.lambert = lambert};

    if (!s->bounded || !(s->shadows.doubt > 0) || !words_light(points, source, line, &s->error, &words))
        return false;
    if (words.first <= words.last) {
        if (s->spans->coherence->shadows(s->spans, s->span, source->number, &s->shadows) &&
            !cast_shadows(s, source->number, &words))
            return false;
        span_add_light(s, &s->view->lights[source->number], lambert, NULL, NO_ERROR, words.doubt);
    }
    s->open |= words.open;
    return true;
}

NOINLINE void words_lights(struct span_shading *s)
{
    const struct tia_rgb *emission = &s->material->emission;
    const struct shaded_span *span = s->span;
    struct word_points points;
    num_u lambert[CHUNK];
    struct light_source source;
    struct light_line line;

    s->most = greatest(num_colour(emission->r), num_colour(emission->g), num_colour(emission->b));
    words_points(&s->spans->primary, &s->spans->spheres[span->object], span->x, span->y, span->t, span->count, &points);
    for (uint32_t l = 0; l < s->view->light_count && !s->given_up && !span_work_stops(s->view, &s->work); l++)
        if (span_prepare_light(s, l, &source, &line) && !shade_by_words(s, &points, &source, &line, lambert))
            span_shade_by_kernels(s, &source, &line, NULL);
    if (s->uncoloured)
        colour_sums(s);
}
