/* exact.c - single pixels in double precision. */
#include "exact.h"

#include "bound_table.h"
#include "point.h"
#include "render/span/span_shade.h"
#include "scene/colour.h"

#define U BOUND(SPAN_DOUBLE_UNIT)

/* A colour, the bounds of its channels' errors, and which channels have light beside the emission. */
struct sum {
    double channel[3], off[3];
    bool lit[3];
};

/* The pixels' sphere. */
struct matter {
    struct simd_seat seat;
    struct tia_rgb emission;
    bool grey; /* all channels are equal */
};

static void take_matter(const struct simd_pixels *pixels, struct matter *m)
{
    const struct tia_scene *scene = pixels->view->scene;
    const struct tia_material *material = &scene->materials[scene->spheres[pixels->sphere].material];

    tia_simd_seat(pixels->view, pixels->row, pixels->sphere, &m->seat);
    m->emission = material->emission;
    m->grey =
        span_view_of(pixels->view)->grey && colour_is_grey(&material->colour) && colour_is_grey(&material->emission);
}

/* Adds a light to the colour; false when the light is undecided. */
static bool add_light(const struct matter *m, const struct simd_lamp *lamp, const struct simd_blockers *blockers,
                      const struct simd_point *o, struct sum *sum)
{
    struct simd_arrival arrival;

    if (!tia_simd_arrive(&m->seat, lamp, blockers, o, &arrival))
        return false;
    if (arrival.none)
        return true;
    double off = arrival.off + (BOUND(SPAN_PIXEL_COLOUR_UNITS) + 2 * arrival.passed) * U;
    for (int c = 0; c < (m->grey ? 1 : 3); c++) {
        double colour = arrival.tint[c] * lamp->colour[c];
        sum->channel[c] = simd_at_most_1(sum->channel[c] + arrival.cosine * colour);
        sum->off[c] += BOUND_OF(SPAN_PIXEL_COLOUR, colour * off + U);
        sum->lit[c] = sum->lit[c] || colour != 0;
    }
    return true;
}

/* Gives the level of channel c; false when the channel is too near a boundary between two levels. A channel of emission
 * alone is exact. */
static bool quantise(const struct sum *sum, int c, tia_q30 emission, unsigned levels, num_u threshold, unsigned *level)
{
    double y = sum->channel[c] * levels + (double)threshold * 0x1p-30;
    double off = BOUND_OF(SPAN_PIXEL_LEVEL,
                          levels * sum->off[c] * (1 + BOUND(SPAN_PIXEL_SECOND)) + BOUND(SPAN_PIXEL_LEVEL_UNITS) * U);

    if (!sum->lit[c]) {
        *level = num_quantise(num_clamp(num_colour(emission)), levels, threshold);
        return true;
    }
    if (!(y >= off && y < 64)) /* NaN, too */
        return false;
    *level = (unsigned)y;
    return y - (int)*level >= off && (int)*level + 1 - y > off;
}

/* ---- pixels ---- */

#define TOGETHER 16 /* pixels for which a light's casters are listed once */

struct pixel {
    int at; /* its index */
    bool known;
    struct simd_point point;
    struct sum sum;
};

/* Lists the casters of a light; false if it reaches none of the pixels. */
static bool list_casters(const struct simd_pixels *pixels, uint32_t light, struct simd_blockers *blockers)
{
    const struct simd_lamp *lamp = simd_lamp_of(pixels->view, pixels->sphere, light);
    const struct span_casters *casters = &span_view_of(pixels->view)->casters;

    blockers->count = 0;
    if (!lamp->plain) {
        for (int i = 0; i < lamp->casts; i++)
            blockers->sphere[blockers->count++] = lamp->cast[i].sphere;
        return !simd_is_black(lamp->colour);
    }
    const uint8_t *list = tia_simd_crowd_list(pixels->view, pixels->crowd, light);
    for (uint32_t j = 0; list && (j = span_next_in(casters, list, j)) < casters->count; j++)
        blockers->sphere[blockers->count++] = (uint8_t)j;
    return list != NULL;
}

/* Computes the sums of pixels. */
static void add_lights(const struct matter *m, const struct simd_pixels *pixels, struct pixel *pixel, int count)
{
    struct simd_blockers blockers;

    for (uint32_t l = 0; l < pixels->view->light_count; l++) {
        const struct simd_lamp *lamp = simd_lamp_of(pixels->view, pixels->sphere, l);
        if (!list_casters(pixels, l, &blockers))
            continue;
        for (int i = 0; i < count; i++)
            pixel[i].known = pixel[i].known && add_light(m, lamp, &blockers, &pixel[i].point, &pixel[i].sum);
    }
}

/* Gives the colour of a pixel; false when it is undecided. */
static bool colour_of(const struct matter *m, const struct pixel *pixel, num_u threshold, tia_rgb565 *out)
{
    const struct tia_rgb *own = &m->emission;
    unsigned r, g, b;

    if (!pixel->known || !quantise(&pixel->sum, 0, own->r, 31, threshold, &r) ||
        !quantise(&pixel->sum, m->grey ? 0 : 1, own->g, 63, threshold, &g))
        return false;
    b = r;
    if (!m->grey && !quantise(&pixel->sum, 2, own->b, 31, threshold, &b))
        return false;
    *out = (tia_rgb565)(r << 11 | g << 5 | b);
    return true;
}

static void draw_exactly(const struct simd_pixels *pixels, int at)
{
    int x = pixels->first + at;
    num_u t;
    const struct shaded_span one = {pixels->sphere, x, pixels->row->y, 1, &t, NULL, NULL};

    span_distances(span_view_of(pixels->view), pixels->sphere, one.y, x, 1, &t);
    pixels->out[at] = span_shade_exactly(pixels->view, &one, pixels->threshold[x & 7]);
}

static void draw(const struct matter *m, const struct simd_pixels *pixels, struct pixel *pixel, int count)
{
    for (int i = 0; i < count; i++) {
        int x = pixels->first + pixel[i].at;
        pixel[i].sum = (struct sum){{0}, {0}, {0}};
        simd_channels(&m->emission, pixel[i].sum.channel);
        pixel[i].known = tia_simd_point(&m->seat, x, &pixel[i].point);
    }
    add_lights(m, pixels, pixel, count);
    for (int i = 0; i < count; i++) {
        int at = pixel[i].at;
        if (!colour_of(m, &pixel[i], pixels->threshold[(pixels->first + at) & 7], &pixels->out[at]))
            draw_exactly(pixels, at);
    }
}

void tia_simd_decide(const struct simd_pixels *pixels, const uint16_t *list, int count)
{
    struct pixel pixel[TOGETHER];
    struct matter m;

    if (count > 0)
        take_matter(pixels, &m);
    for (int first = 0; first < count; first += TOGETHER) {
        int some = count - first < TOGETHER ? count - first : TOGETHER;
        for (int i = 0; i < some; i++)
            pixel[i].at = list ? list[first + i] : first + i;
        draw(&m, pixels, pixel, some);
    }
}

/* ---- a light ---- */

/* Lists the casters of a lamp that may matter at a pixel: undecided ones, and all that transmit light. */
static void list_open(const struct simd_lamp *lamp, const struct simd_sums *sums, int at,
                      struct simd_blockers *blockers)
{
    int cell = at / SIMD_CELL;

    blockers->count = 0;
    for (int j = 0; j < lamp->casts; j++)
        if (lamp->cast[j].clear || sums->open[j] >> cell & 1)
            blockers->sphere[blockers->count++] = lamp->cast[j].sphere;
}

void tia_simd_decide_lamp(const struct simd_pixels *pixels, const struct simd_lamp *lamp, double faint,
                          const uint16_t *list, int count, struct simd_sums *sums)
{
    struct simd_arrival arrival;
    struct simd_blockers blockers;
    struct simd_point point;
    struct simd_seat seat;

    if (count > 0)
        tia_simd_seat(pixels->view, pixels->row, pixels->sphere, &seat);
    for (int i = 0; i < count; i++) {
        int at = list[i];
        list_open(lamp, sums, at, &blockers);
        if (!tia_simd_point(&seat, pixels->first + at, &point) ||
            !tia_simd_arrive(&seat, lamp, &blockers, &point, &arrival) || arrival.off > faint) {
            sums->sum[0][at] = __builtin_nanf("");
            continue;
        }
        for (int c = 0; c < 3 && !arrival.none; c++)
            sums->sum[c][at] =
                (float)simd_at_most_1((double)sums->sum[c][at] + arrival.cosine * (arrival.tint[c] * lamp->colour[c]));
    }
}
