#include "point.h"

#include <math.h>

#include "distance.h"

#define U BOUND(SPAN_DOUBLE_UNIT)
#define BIAS ((double)NUM_BIAS)

/* The ray from the point to a light. */
struct way {
    double w[3], square, length; /* w, |w|^2, |w| */
    double e_w, e_c;             /* bounds of the errors of |w|^2, relative, and of the cosine */
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

bool tia_simd_point(const struct simd_seat *seat, int x, struct simd_point *o)
{
    const struct simd_row *row = seat->row;
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
static bool aim(const struct simd_seat *seat, const struct simd_point *o, struct num_vec light, struct way *way,
                double *cosine)
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

static struct meeting meet(const struct simd_point *o, const struct way *way, const struct span_sphere *caster)
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
static enum shadow shadow_at(const struct simd_point *o, const struct way *way, struct num_vec light,
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
static bool cast_shadows(const struct simd_seat *seat, struct num_vec light, const struct simd_blockers *blockers,
                         const struct simd_point *o, const struct way *way, double tint[3], int *passed)
{
    const struct tia_scene *scene = seat->view->scene;
    const struct span_sphere *spheres = span_view_of(seat->view)->spheres;
    bool open = false;

    for (int i = 0; i < blockers->count; i++) {
        uint32_t j = blockers->sphere[i];
        enum shadow shadow = shadow_at(o, way, light, &spheres[j]);
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

bool tia_simd_arrive(const struct simd_seat *seat, const struct simd_lamp *lamp, const struct simd_blockers *blockers,
                     const struct simd_point *o, struct simd_arrival *arrival)
{
    struct way way;

    *arrival = (struct simd_arrival){.tint = {1, 1, 1}, .passed = lamp->shades};
    if (!aim(seat, o, lamp->light, &way, &arrival->cosine))
        return false;
    arrival->off = way.e_c;
    arrival->none = arrival->cosine < -way.e_c;
    arrival->cosine = simd_at_most_1(arrival->cosine > 0 ? arrival->cosine : 0);
    return arrival->none || cast_shadows(seat, lamp->light, blockers, o, &way, arrival->tint, &arrival->passed);
}

void tia_simd_seat(const struct tia_view *view, const struct simd_row *row, uint32_t sphere, struct simd_seat *seat)
{
    const struct span_view *spans = span_view_of(view);

    seat->view = view;
    seat->row = row;
    seat->primary = &spans->primary;
    seat->sphere = &spans->spheres[sphere];
    set(seat->centre, seat->sphere->centre);
    seat->radius = (double)seat->sphere->radius;
    seat->per_radius = 1 / seat->radius;
    seat->swell = BIAS * seat->per_radius;
}
