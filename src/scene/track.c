#include "track.h"

#include "math/integer.h"

/* Returns a/b as Q2.62, rounded down; 0 <= a <= b < 2^31, b > 0. */
static int64_t fraction(int64_t a, int64_t b)
{
    uint64_t n = (uint64_t)a << 31, d = (uint64_t)b;
    return (int64_t)((n / d) << 31 | (n % d << 31) / d);
}

/* Weights, Q2.62, of the difference of a segment's ends and of its two tangents: the cubic Hermite polynomials 3u^2 -
 * 2u^3, u - 2u^2 + u^3 and u^3 - u^2. They are evaluated so that no intermediate result exceeds 1. */
struct weights {
    int64_t end, first_slope, last_slope;
};

static struct weights hermite(int64_t u)
{
    int64_t u2 = tia_scaled_product(u, u, 62), u3 = tia_scaled_product(u2, u, 62);
    return (struct weights){u2 + 2 * (u2 - u3), (u - u2) - (u2 - u3), u3 - u2};
}

/* One coordinate of the four keyframes around a time: the segment's two ends, and the keyframes before and after it.
 * The tangent at an end is the difference of the neighbouring values, multiplied by first_share or last_share: the part
 * of the time between these neighbours that the segment takes. At the ends of the track the tangent is 0. */
struct segment {
    tia_q16 before, first, last, after;
    int64_t first_share, last_share;
};

static tia_q16 interpolate(const struct segment *s, const struct weights *w)
{
    /* Tangents and sum have 32 fractional bits. */
    int64_t first = tia_scaled_product((int64_t)s->last - s->before, s->first_share, 46);
    int64_t last = tia_scaled_product((int64_t)s->after - s->first, s->last_share, 46);
    int64_t sum = tia_scaled_product((int64_t)s->last - s->first, w->end, 46) +
                  tia_scaled_product(first, w->first_slope, 62) + tia_scaled_product(last, w->last_slope, 62);
    int64_t value = s->first + tia_round_shift(sum, 16);
    /* Between keyframes a smooth curve can overshoot Q16.16. */
    return tia_saturate_s32(value);
}

static struct tia_vec3 between(const struct tia_track *track, uint32_t i, tia_q16 time)
{
    const struct tia_keyframe *first = &track->keys[i], *last = first + 1;
    const struct tia_keyframe *before = i > 0 ? first - 1 : first;
    const struct tia_keyframe *after = i + 2 < track->key_count ? last + 1 : last;
    int64_t length = (int64_t)last->time - first->time, u = fraction((int64_t)time - first->time, length);
    struct weights w = {u, 0, 0};
    struct segment s = {0};

    if (track->smooth) {
        w = hermite(u);
        s.first_share = before < first ? fraction(length, (int64_t)last->time - before->time) : 0;
        s.last_share = after > last ? fraction(length, (int64_t)after->time - first->time) : 0;
    }
    struct tia_vec3 value;
#define INTERPOLATE(c)                                                                                                 \
    s.before = before->value.c, s.first = first->value.c, s.last = last->value.c, s.after = after->value.c;            \
    value.c = interpolate(&s, &w)
    INTERPOLATE(x);
    INTERPOLATE(y);
    INTERPOLATE(z);
#undef INTERPOLATE
    return value;
}

struct tia_vec3 tia_track_value(const struct tia_track *track, tia_q16 time)
{
    uint32_t next = 0;

    while (next < track->key_count && track->keys[next].time <= time)
        next++;
    if (next == 0)
        return track->keys[0].value;
    return next == track->key_count ? track->keys[next - 1].value : between(track, next - 1, time);
}

bool tia_track_shows(const struct tia_track *track, tia_q16 time)
{
    uint32_t next = 1;

    while (next < track->key_count && track->keys[next].time <= time)
        next++;
    return track->keys[next - 1].value.x;
}
