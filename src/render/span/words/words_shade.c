/* words_shade.c - a light on a span: by words where it is certain what blocks it, elsewhere by the kernels. */
#include "words_shade.h"
#include "words.h"

#include "math/noinline.h"
#include "render/span/span_parts.h"
#include "render/span/span_shade.h"

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

static inline num_u share(num_u lambert, uint32_t factor)
{
    return (num_u)words_high((uint32_t)lambert, factor);
}

bool words_add(struct span_shading *s, const num_u *lambert, const num_u product[3])
{
    const uint32_t factor[3] = {(uint32_t)product[0] << 2, (uint32_t)product[1] << 2, (uint32_t)product[2] << 2};
    num_u most = greatest(product[0], product[1], product[2]);

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

/* ---- shadows ---- */

/* Computes the cosines of pixels first..end-1 with the kernels. Returns the logarithm of the bound of their errors. */
static NOINLINE int shade_run(struct span_shading *s, const struct light_source *source, int first, int end,
                              num_u *lambert)
{
    const struct shaded_span *span = s->span;
    struct shaded_span run = {span->object, span->x + first, span->y, end - first, span->t + first, NULL, NULL};
    struct light_source own = *source;
    struct light_line line;
    struct lit lit;
    int error = NO_ERROR;

    light_line_prepare(&s->spans->primary, &own, run.x, run.y, &line);
    line.count = run.count;
    line.facing_doubt = span_error_facing(&own, &line, &s->error);
    s->span = &run;
    if (s->spans->kernels->light(&line, run.t, &lit)) {
        span_bound_lambert(s, &own, lit.most_half);
        error = s->error.lambert;
        span_cast_shadows(s, &own, s->shadows.near, (struct span){0, run.count}, &lit, NULL);
    }
    s->open |= lit.open << first;
    s->spans->kernels->lambert(&lit, own.sphere->inverse, run.count, lambert + first);
    s->span = span;
    return error;
}

/* Computes the cosines of the parts that are not lit. Returns the logarithm of the bound of the kernels' errors. */
static NOINLINE int shade_parts(struct span_shading *s, const struct light_source *source,
                                const struct word_light *words)
{
    const uint8_t *part = s->shadows.part;
    int worst = NO_ERROR;

    for (int i = words->first / SHADOW_PART, next; i * SHADOW_PART <= words->last && !s->given_up; i = next) {
        int first = i * SHADOW_PART;
        next = i + 1;
        while (next * SHADOW_PART < s->span->count && part[next] == part[i])
            next++;
        int end = next * SHADOW_PART < s->span->count ? next * SHADOW_PART : s->span->count;
        int error = part[i] == SPAN_OPEN ? shade_run(s, source, first, end, words->lambert) : NO_ERROR;
        worst = worst > error ? worst : error;
        for (int at = first; part[i] == SPAN_DARK && at < end; at++)
            words->lambert[at] = 0;
    }
    return worst;
}

/* Adds a light that is prepared; false if the kernels are to do it. `lambert` is room for its cosines. */
static bool shade_by_words(struct span_shading *s, const struct word_points *points, const struct light_source *source,
                           const struct light_line *line, num_u *lambert)
{
    struct word_light words = {.lambert = lambert};
    int error = NO_ERROR;

    if (!s->bounded || !words_light(points, source, line, &s->error, &words))
        return false;
    s->open |= words.open;
    if (words.first > words.last)
        return true;
    if (s->spans->coherence->shadows(s->spans, s->span, source->number, &s->shadows))
        error = shade_parts(s, source, &words);
    if (!s->given_up)
        span_add_light(s, &s->view->lights[source->number], lambert, NULL, error, words.doubt);
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
}
