/* exact.c - single pixels in double precision: the formulas of docs/definition.md, with a bound on the error of each
 * value, which bounds/pixels.h derives. Lengths are in units of 2^-16. */
#include "exact.h"

#include <math.h>

#include "distance.h"
#include "render/span/span_shade.h"
#include "scene/colour.h"

#define U BOUND(SPAN_DOUBLE_UNIT)
#define BIAS ((double)NUM_BIAS)

/* The pixels' sphere, and constants of it: bias/r is `swell`. */
struct seat {
    const struct simd_pixels *pixels;
    const struct primary_rays *primary;
    const struct span_sphere *sphere;
    struct tia_rgb emission;
    bool grey; /* all channels are equal */
    double centre[3], radius, per_radius, swell;
};

/* The visible point P, r N, and the start P + bias N of shadow rays. */
struct point {
    double p[3], n[3], start[3];
    double begins;         /* sum of the sizes of the start's components */
    double moved, started; /* bounds of the errors of P and of the start */
};

/* The ray from the point to a light. */
struct way {
    double w[3], square, length; /* w, |w|^2, |w| */
    double e_w, e_c;             /* bounds of the errors of |w|^2, relative, and of the cosine */
};

/* A colour, the bounds of its channels' errors, and which channels have light beside the emission. */
struct sum {
    double channel[3], off[3];
    bool lit[3];
};

enum shadow { LIT, DARK, OPEN };

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static double size_of(const double a[3])
{
    return fabs(a[0]) + fabs(a[1]) + fabs(a[2]);
}

static void set(double r[3], struct num_vec a)
{
    r[0] = (double)a.x;
    r[1] = (double)a.y;
    r[2] = (double)a.z;
}

/* Finds the visible point of pixel x; false when its error is too large. */
static bool find_point(const struct seat *seat, int x, struct point *o)
{
    const struct simd_row *row = seat->pixels->row;
    struct simd_distance at;

    if (!simd_distance_at(seat->primary, row, x, seat->sphere, &at))
        return false;
    double v[3] = {(double)simd_across(seat->primary, x), (double)row->y_coordinate, -row->depth};
    double off = BOUND_OF(SPAN_PIXEL_POINT, at.off + row->turn + BOUND(SPAN_PIXEL_POINT_UNITS) * U);
    for (int i = 0; i < 3; i++) {
        o->p[i] = at.t * v[i];
        o->n[i] = o->p[i] - seat->centre[i];
        o->start[i] = o->p[i] + seat->swell * o->n[i];
    }
    o->begins = size_of(o->start);
    o->moved = off * size_of(o->p);
    o->started = BOUND_OF(SPAN_PIXEL_START, o->moved * (1 + seat->swell) * (1 + BOUND(SPAN_PIXEL_SECOND)) +
                                                BOUND(SPAN_PIXEL_START_UNITS) * U * (o->begins + 4 * BIAS));
    return o->moved < BOUND(SPAN_PIXEL_NEAR) * seat->radius;
}

/* Gives the ray to the light at `light` less the eye, and its cosine; false when it cannot be bounded. */
static bool aim(const struct seat *seat, const struct point *o, struct num_vec light, struct way *way, double *cosine)
{
    double q[3], more = 1 + BOUND(SPAN_PIXEL_SECOND);

    set(q, light);
    for (int i = 0; i < 3; i++)
        way->w[i] = q[i] - o->p[i];
    way->square = dot(way->w, way->w);
    way->length = sqrt(way->square);
    double per_length = 1 / way->length, aside = o->moved * per_length;
    way->e_w = BOUND_OF(SPAN_PIXEL_SQUARE, 2 * more * aside + BOUND(SPAN_PIXEL_SQUARE_UNITS) * U);
    way->e_c = BOUND_OF(SPAN_PIXEL_COSINE, more * (o->moved * seat->per_radius + aside + way->e_w / 2) +
                                               BOUND(SPAN_PIXEL_COSINE_UNITS) * U);
    *cosine = dot(o->n, way->w) * (seat->per_radius * per_length);
    return aside < BOUND(SPAN_PIXEL_NEAR); /* not NaN either */
}

/* The values that decide whether a caster shadows the light: A.w, h = |A|^2 - R^2 and (A.w)^2 - h |w|^2, with the
 * bounds of their errors. */
struct meeting {
    double a, h, delta;
    double e_a, e_h, e_delta;
};

static struct meeting meet(const struct point *o, const struct way *way, const struct span_sphere *caster)
{
    double centre[3], ray[3], back[3], c = (double)caster->c, w = way->square, more = 1 + BOUND(SPAN_PIXEL_SECOND);
    struct meeting m;

    set(centre, caster->centre);
    for (int i = 0; i < 3; i++) {
        ray[i] = centre[i] - o->start[i];
        back[i] = o->start[i] - 2 * centre[i];
    }
    double size = size_of(ray);
    m.a = dot(ray, way->w);
    m.h = c + dot(o->start, back);
    m.delta = m.a * m.a - m.h * w;
    m.e_a = BOUND_OF(SPAN_PIXEL_A, (o->started * way->length + size * o->moved) * more +
                                       BOUND(SPAN_PIXEL_A_UNITS) * U * size * way->length);
    m.e_h = BOUND_OF(SPAN_PIXEL_H, (2 * size + o->started) * o->started +
                                       BOUND(SPAN_PIXEL_H_UNITS) * U * (fabs(c) + o->begins * size_of(back)));
    m.e_delta = BOUND_OF(SPAN_PIXEL_DELTA, m.e_a * (2 * fabs(m.a) + m.e_a) + w * (m.e_h + fabs(m.h) * way->e_w) * more +
                                               BOUND(SPAN_PIXEL_DELTA_UNITS) * U * m.a * m.a);
    return m;
}

/* Decides whether a caster shadows the light. */
static enum shadow shadow_at(const struct point *o, const struct way *way, struct num_vec light,
                             const struct span_sphere *caster)
{
    struct meeting m = meet(o, way, caster);
    double past = m.a - way->square, beyond = BOUND_OF(SPAN_PIXEL_BEYOND, m.e_a + way->square * way->e_w);

    if (m.delta < -m.e_delta || m.a < -m.e_a)
        return LIT;
    if (past >= -beyond && !tia_simd_encloses(caster, light))
        return past > beyond ? LIT : OPEN;
    return m.delta > m.e_delta && m.a > m.e_a ? DARK : OPEN;
}

/* Multiplies `tint` by a sphere's transmission. */
static void pass(const struct tia_scene *scene, uint32_t sphere, double tint[3])
{
    const struct tia_rgb *through = &scene->materials[scene->spheres[sphere].material].transmission;

    tint[0] *= (double)through->r * 0x1p-30;
    tint[1] *= (double)through->g * 0x1p-30;
    tint[2] *= (double)through->b * 0x1p-30;
}

/* Multiplies `tint` by the transmissions of all spheres that shadow the light, and counts these in *passed; false when
 * one of them is undecided, unless the others leave no light. */
static bool cast_shadows(const struct seat *seat, const struct simd_lamp *lamp, const struct point *o,
                         const struct way *way, double tint[3], int *passed)
{
    const struct tia_scene *scene = seat->pixels->view->scene;
    const struct span_sphere *spheres = span_view_of(seat->pixels->view)->spheres;
    bool open = false;

    for (int i = 0; i < lamp->casts; i++) {
        uint32_t j = lamp->cast[i].sphere;
        enum shadow shadow = shadow_at(o, way, lamp->light, &spheres[j]);
        open = open || shadow == OPEN;
        if (shadow != DARK)
            continue;
        pass(scene, j, tint);
        if (simd_is_black(tint))
            return true;
        ++*passed;
    }
    return !open;
}

static double at_most_1(double a)
{
    return a > 1 ? 1 : a;
}

/* Adds a light to the colour; false when the light is undecided. */
static bool add_light(const struct seat *seat, const struct simd_lamp *lamp, const struct point *o, struct sum *sum)
{
    double tint[3] = {1, 1, 1}, cosine;
    struct way way;
    int passed = lamp->shades;

    if (simd_is_black(lamp->colour))
        return true;
    if (!aim(seat, o, lamp->light, &way, &cosine))
        return false;
    if (cosine < -way.e_c)
        return true;
    if (!cast_shadows(seat, lamp, o, &way, tint, &passed))
        return false;
    cosine = at_most_1(cosine > 0 ? cosine : 0);
    double off = way.e_c + (BOUND(SPAN_PIXEL_COLOUR_UNITS) + 2 * passed) * U;
    for (int c = 0; c < (seat->grey ? 1 : 3); c++) {
        double colour = tint[c] * lamp->colour[c];
        sum->channel[c] = at_most_1(sum->channel[c] + cosine * colour);
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

/* Draws pixel x; false when it is undecided in doubles. */
static bool draw(const struct seat *seat, int x, tia_rgb565 *out)
{
    const struct tia_view *view = seat->pixels->view;
    const struct tia_rgb *own = &seat->emission;
    struct sum sum = {.channel = {(double)own->r * 0x1p-30, (double)own->g * 0x1p-30, (double)own->b * 0x1p-30}};
    num_u threshold = seat->pixels->threshold[x & 7];
    unsigned r, g, b;
    struct point o;

    if (!find_point(seat, x, &o))
        return false;
    for (uint32_t l = 0; l < view->light_count; l++)
        if (!add_light(seat, &seat->pixels->lamps[l], &o, &sum))
            return false;
    if (!quantise(&sum, 0, own->r, 31, threshold, &r) || !quantise(&sum, seat->grey ? 0 : 1, own->g, 63, threshold, &g))
        return false;
    b = r;
    if (!seat->grey && !quantise(&sum, 2, own->b, 31, threshold, &b))
        return false;
    *out = (tia_rgb565)(r << 11 | g << 5 | b);
    return true;
}

static void take_seat(const struct simd_pixels *pixels, struct seat *seat)
{
    const struct span_view *spans = span_view_of(pixels->view);
    const struct tia_scene *scene = pixels->view->scene;
    const struct tia_material *material = &scene->materials[scene->spheres[pixels->sphere].material];

    seat->pixels = pixels;
    seat->primary = &spans->primary;
    seat->sphere = &spans->spheres[pixels->sphere];
    seat->emission = material->emission;
    seat->grey = spans->grey && colour_is_grey(&material->colour) && colour_is_grey(&material->emission);
    set(seat->centre, seat->sphere->centre);
    seat->radius = (double)seat->sphere->radius;
    seat->per_radius = 1 / seat->radius;
    seat->swell = BIAS * seat->per_radius;
}

void tia_simd_decide(const struct simd_pixels *pixels, const uint16_t *list, int count)
{
    struct seat seat;

    if (count == 0)
        return;
    take_seat(pixels, &seat);
    for (int i = 0; i < count; i++) {
        int at = list ? list[i] : i, x = pixels->first + at;
        if (draw(&seat, x, &pixels->out[at]))
            continue;
        num_u t;
        const struct shaded_span one = {pixels->sphere, x, pixels->row->y, 1, &t, NULL, NULL};
        span_distances(span_view_of(pixels->view), pixels->sphere, one.y, x, 1, &t);
        pixels->out[at] = span_shade_exactly(pixels->view, &one, pixels->threshold[x & 7]);
    }
}
