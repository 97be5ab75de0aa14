/* coherence_shadows.c - what blocks a light at the points of a span, by balls around the points of all of it and of its
 * parts. */
#include "coherence.h"

#include "math/integer.h"
#include "math/noinline.h"
#include "render/span/span_parts.h"

#define SLACK 7 /* for all rounding and for the bias, see span_casters.c */

/* Returns an upper limit of a vector's length: with m the largest size of a component, sqrt(m^2 + a^2) is at most m +
 * (sqrt(2) - 1) a. */
static num length_of(num x, num y, num z)
{
    num a = x < 0 ? -x : x, b = y < 0 ? -y : y, c = z < 0 ? -z : z, most = a > b ? a : b;

    most = most > c ? most : c;
    return most + (a + b + c - most) / 2 + 1;
}

/* Surrounds the points of pixels first..last, exact or as the kernels compute them. From outside a row's points lie on
 * less than half of a circle: one at an end is the farthest from the middle. False if t is too inaccurate. */
static bool surround(const struct span_view *spans, const struct shaded_span *span, num doubt, int first, int last,
                     struct coarse_ball *ball, struct coarse_ball end[2])
{
    const struct span_sphere *sphere = &spans->spheres[span->object];
    const struct primary_rays *primary = &spans->primary;
    int middle = first + (last - first) / 2;
    num most = 0;

    if (!span_coarse_point(primary, sphere, span->x + middle, span->y, span->t[middle], doubt, ball))
        return false;
    for (int i = 0; i < 2; i++) {
        int at = i ? last : first;
        if (!span_coarse_point(primary, sphere, span->x + at, span->y, span->t[at], doubt, &end[i]))
            return false;
        num far = length_of(end[i].x - ball->x, end[i].y - ball->y, end[i].z - ball->z) / 2 + end[i].radius / 2;
        most = most > far ? most : far;
    }
    if (span_bits(most) > 26 || span_bits(ball->radius) > 26)
        return false;
    ball->radius = 2 * (most + ball->radius) + 6;
    return true;
}

/* Surrounds the span. */
static NOINLINE void find_ball(const struct span_view *spans, const struct shaded_span *span,
                               struct span_shadows *shadows)
{
    const struct span_sphere *sphere = &spans->spheres[span->object];

    shadows->tried = true;
    shadows->known =
        sphere->c > 0 && surround(spans, span, shadows->doubt, 0, span->count - 1, &shadows->around, shadows->end);
    if (!shadows->known)
        return;
    num_wide sag = span_sag(sphere, &shadows->end[0], &shadows->end[1]);
    shadows->sag = (num)sag + shadows->end[0].radius + shadows->end[1].radius;
    shadows->known = span_bits(sag) <= 28;
}

/* Surrounds the parts. */
static NOINLINE void find_balls(const struct span_view *spans, const struct shaded_span *span,
                                struct span_shadows *shadows)
{
    const int count = span->count;
    struct coarse_ball ends[2];

    shadows->divided = true;
    for (int first = 0; first < count; first += SHADOW_PART) {
        int last = first + SHADOW_PART < count ? first + SHADOW_PART - 1 : count - 1;
        struct coarse_ball *ball = &shadows->ball[first / SHADOW_PART];
        if (!surround(spans, span, shadows->doubt, first, last, ball, ends))
            *ball = shadows->around;
    }
}

/* ---- the plane through a row's points and a light ---- */

/* The points of a span and a light are near a plane across n. All rays between them are where n.X is in low..high, for
 * any n. A ball at C is clear of them where n.C is outside by more than its radius times |n|. */
struct slab {
    num n[3], length; /* n, and an upper limit of |n| */
    num_wide low, high;
};

/* Cuts the components of a vector to 14 bits and a sign. */
static void shorten(num v[3])
{
    uint32_t bits = 1;

    for (int i = 0; i < 3; i++)
        bits |= (uint32_t)(v[i] < 0 ? -v[i] : v[i]);
    int down = 18 - (int)tia_clz32(bits);
    for (int i = 0; i < 3; i++)
        v[i] = (num)((int32_t)v[i] >> (down > 0 ? down : 0));
}

static inline num_wide along(const struct slab *s, const struct coarse_ball *p)
{
    return num_mul(s->n[0], p->x) + num_mul(s->n[1], p->y) + num_mul(s->n[2], p->z);
}

static NOINLINE void find_slab(const struct span_shadows *shadows, const struct coarse_ball *light, struct slab *s)
{
    const struct coarse_ball *a = &shadows->end[0], *b = &shadows->end[1];
    num u[3] = {b->x - a->x, b->y - a->y, b->z - a->z}, v[3] = {light->x - a->x, light->y - a->y, light->z - a->z};

    shorten(u);
    shorten(v);
    for (int i = 0; i < 3; i++)
        s->n[i] = u[(i + 1) % 3] * v[(i + 2) % 3] - u[(i + 2) % 3] * v[(i + 1) % 3];
    shorten(s->n);
    s->length = length_of(s->n[0], s->n[1], s->n[2]);
    const struct coarse_ball *const ends[3] = {a, b, light};
    num_wide more = num_mul(s->length, shadows->sag + SLACK);
    for (int i = 0; i < 3; i++) {
        num_wide at = along(s, ends[i]);
        s->low = i && s->low < at ? s->low : at;
        s->high = i && s->high > at ? s->high : at;
    }
    s->low -= more;
    s->high += more;
}

static inline bool is_outside(const struct slab *s, const struct coarse_ball *caster)
{
    num_wide at = along(s, caster), reach = num_mul(s->length, caster->radius);

    return at - reach > s->high || at + reach < s->low;
}

/* ---- shadows ---- */

/* A light on a span. */
struct shade {
    const struct span_view *spans;
    const struct shaded_span *span;
    struct span_shadows *shadows;
    uint32_t light;
    const struct coarse_ball *ball; /* of the light */
};

/* Sets `near` to those of the listed spheres that may block the light; false if there is none. */
static bool find_near(const struct shade *d, const uint8_t *list)
{
    const struct span_casters *casters = &d->spans->casters;
    uint8_t *near = d->shadows->near;
    struct span_hull hull;
    struct slab slab;
    unsigned some = 0;

    find_slab(d->shadows, d->ball, &slab);
    span_hull_of(&d->shadows->around, d->ball, &hull);
    for (uint32_t i = 0; i < (casters->count + 7) / 8; i++) {
        const struct coarse_ball *caster = &casters->coarse[8 * i];
        near[i] = 0;
        for (unsigned rest = list[i], bit = 1; rest; rest >>= 1, bit <<= 1, caster++)
            if (rest & 1 && !is_outside(&slab, caster) && !span_hull_clears(&hull, caster))
                near[i] = (uint8_t)(near[i] | bit);
        some |= near[i];
    }
    return some != 0;
}

/* Finds what the near spheres do in a part, and marks in `used` those that may block the light in it, or do. */
static NOINLINE enum span_part part_of(const struct shade *d, const struct coarse_ball *ball, uint8_t *used)
{
    const struct span_casters *casters = &d->spans->casters;
    enum span_part part = SPAN_LIT;
    struct span_hull hull;

    span_hull_of(ball, d->ball, &hull);
    for (uint32_t j = 0; (j = span_next_in(casters, d->shadows->near, j)) < casters->count && part != SPAN_DARK; j++) {
        enum span_part by = SPAN_LIT;
        if (!span_hull_clears(&hull, &casters->coarse[j]))
            by = span_part_of(casters, ball, d->light, j);
        if (by == SPAN_LIT)
            continue;
        part = d->spans->tinted ? SPAN_OPEN : by;
        used[j >> 3] = (uint8_t)(used[j >> 3] | 1u << (j & 7));
    }
    return part;
}

/* Finds what happens in each part, and leaves in `near` the spheres that matter. */
static NOINLINE void find_parts(const struct shade *d)
{
    struct span_shadows *shadows = d->shadows;
    uint8_t used[sizeof(shadows->near)] = {0};

    if (!shadows->divided)
        find_balls(d->spans, d->span, shadows);
    for (int i = 0; i * SHADOW_PART < d->span->count; i++)
        shadows->part[i] = (uint8_t)part_of(d, &shadows->ball[i], used);
    for (uint32_t i = 0; i < (d->spans->casters.count + 7) / 8; i++)
        shadows->near[i] = used[i];
}

/* Sets the reach; false if all parts are lit. */
static bool find_reach(int parts, int count, struct span_shadows *shadows)
{
    int first = 0, end = parts;

    while (first < end && shadows->part[first] == SPAN_LIT)
        first++;
    while (end > first && shadows->part[end - 1] == SPAN_LIT)
        end--;
    shadows->reach.first = first * SHADOW_PART;
    shadows->reach.end = end < parts ? end * SHADOW_PART : count;
    return first < end;
}

bool coherence_around(const struct span_view *spans, const struct shaded_span *span, struct span_shadows *shadows)
{
    if (!shadows->tried)
        find_ball(spans, span, shadows);
    return shadows->known;
}

bool coherence_near(const struct span_view *spans, const struct shaded_span *span, uint32_t light,
                    struct span_shadows *shadows)
{
    const struct span_casters *casters = &spans->casters;
    const uint8_t *list = span_list_of(casters, span->object, light);
    struct shade d = {spans, span, shadows, light, &casters->coarse[casters->count + light]};

    if (span_next_in(casters, list, 0) == casters->count)
        return false;
    (void)coherence_around(spans, span, shadows);
    for (uint32_t i = 0; !shadows->known && i < (casters->count + 7) / 8; i++)
        shadows->near[i] = list[i];
    return !shadows->known || find_near(&d, list);
}

bool coherence_shadows(const struct span_view *spans, const struct shaded_span *span, uint32_t light,
                       struct span_shadows *shadows)
{
    const struct span_casters *casters = &spans->casters;
    const int parts = (span->count + SHADOW_PART - 1) / SHADOW_PART;
    struct shade d = {spans, span, shadows, light, &casters->coarse[casters->count + light]};

    if (!coherence_near(spans, span, light, shadows))
        return false;
    for (int i = 0; i < parts; i++)
        shadows->part[i] = SPAN_OPEN;
    if (shadows->known)
        find_parts(&d);
    return find_reach(parts, span->count, shadows);
}
