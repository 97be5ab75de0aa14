/* exact.c - computes the kernels' sums with 53 bits. Then almost only the integer code's own roundings leave pixels
 * undecided. */
#include "exact.h"

#include <math.h>

#include "render/span/span_shade.h"

void tia_simd_plain(const struct tia_view *view, uint32_t sphere, int x, int y, int count, const num_u threshold[8],
                    tia_rgb565 *out)
{
    num_u t[CHUNK];

    for (int done = 0; done < count; done += CHUNK) {
        int n = count - done < CHUNK ? count - done : CHUNK;
        struct shaded_span span = {sphere, x + done, y, n, t, NULL, NULL};
        span_distances(span_view_of(view), sphere, y, x + done, n, t);
        shade_span(view, &span, threshold, out + done);
    }
}

/* Values at a pixel. */
struct pixel {
    double x, s, vv; /* s = 1/t */
};

enum shadow { LIT, DARK, OPEN };

static double form(const double c[3], const struct pixel *p)
{
    return (c[0] * p->s + c[1] + c[2] * p->x) * p->s + p->vv;
}

/* Decides a shadow at one pixel, like judge() in kernel_tmpl.h. */
static enum shadow shadow_at(const struct simd_fine_cast *cast, double swell, const struct pixel *p, double w)
{
    const struct simd_cast_bounds *b = &cast->bounds;
    double s2 = p->s * p->s, a = form(cast->a, p), k = form(cast->k, p);
    double ea = b->a * s2 * (1 + BOUND(SPAN_VERDICT_A)), ew = b->w * (1 + BOUND(SPAN_VERDICT_W));
    double behind = BOUND_OF(SPAN_BEHIND, ea), beyond = BOUND_OF(SPAN_BEYOND, ea + w * ew);
    double delta = a * a - w * k * (1 + swell), power = w * b->k * s2 * (1 + swell) * (1 + BOUND(SPAN_VERDICT_K));
    double bound = BOUND_OF(SPAN_VERDICT, ea * (2 * fabs(a) + ea) + power + a * a * ew);

    if (delta < -bound || a < -behind || a - w > beyond)
        return LIT;
    return delta > bound && a > behind && a - w < -beyond ? DARK : OPEN;
}

static double at_most_1(double a)
{
    return a > 1 ? 1 : a;
}

/* Adds a light to the colour; false when a shadow is undecided. */
static bool add_light(const struct simd_fine_light *light, const struct pixel *p, double sum[3])
{
    const struct simd_lamp *lamp = light->lamp;
    double w = (lamp->qq * p->s + light->q[0] + light->q[1] * p->x) * p->s + p->vv;
    double lambert = (lamp->k * p->s + light->g[0] + light->g[1] * p->x) * lamp->per_r / sqrt(w), tint[3] = {1, 1, 1};

    if (!(w > 0))
        return false;
    if (lambert <= 0)
        return true;
    for (int j = 0; j < lamp->casts; j++) {
        enum shadow shadow = shadow_at(&light->cast[j], lamp->swell, p, w);
        if (shadow == OPEN)
            return false;
        for (int c = 0; shadow == DARK && c < 3; c++)
            tint[c] *= lamp->cast[j].through[c];
    }
    for (int c = 0; c < 3; c++)
        sum[c] = at_most_1(sum[c] + at_most_1(lambert) * tint[c] * lamp->colour[c]);
    return true;
}

/* Gives a channel's level; false when the channel is too near the boundary between two levels. */
static bool quantise(double channel, double levels, double half, double near, unsigned *level)
{
    double y = channel * levels + half;

    if (!(y >= -.5 && y < 64))
        return false;
    *level = (unsigned)(y + .5);
    return fabs(y - (int)*level) <= near;
}

static bool decide(const struct simd_fine *fine, int i, double half, tia_rgb565 *out)
{
    const double *b = fine->seen.b, *d = fine->seen.d;
    struct pixel p = {.x = fine->place.low + i};
    double depth = d[0] + p.x * (d[1] + p.x * d[2]), sum[3] = {fine->emission[0], fine->emission[1], fine->emission[2]};
    unsigned r = 0, g = 0, blue = 0;

    if (!(depth >= fine->depth.cut))
        return false;
    p.s = (b[0] + b[1] * p.x + sqrt(depth)) / fine->seen.c;
    p.vv = fine->place.v0 + p.x * (fine->place.v1 + p.x * fine->place.v2);
    for (uint32_t l = 0; l < fine->view->light_count; l++)
        if (!add_light(&fine->light[l], &p, sum))
            return false;
    bool sure = quantise(sum[0], 31, half, fine->near31, &r);
    sure = quantise(sum[1], 63, half, fine->near63, &g) && sure;
    sure = quantise(sum[2], 31, half, fine->near31, &blue) && sure;
    *out = (tia_rgb565)(r << 11 | g << 5 | blue);
    return sure;
}

void tia_simd_decide(struct simd_fine *fine, struct simd_bound_cache *cache, const uint16_t *list, int count,
                     const num_u threshold[8], tia_rgb565 *out)
{
    bool fit = count > 0 && tia_simd_fine_bounds(fine, SIMD_DOUBLE, SIMD_DOUBLE_CUT, cache);

    for (int i = 0; i < count; i++) {
        int x = fine->first + list[i];
        double half = (double)threshold[x & 7] * 0x1p-30 - .5;
        if (!fit || !decide(fine, list[i], half, &out[list[i]]))
            tia_simd_plain(fine->view, fine->sphere, x, fine->row->y, 1, threshold, &out[list[i]]);
    }
}
