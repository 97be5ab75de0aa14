#define FAST_WHERE_ROOM
#include "math/fast.h"

#include "coherence.h"

#include "coherence_colour.h"
#include "coherence_proved.h"
#include "coherence_run.h"
#include "render/span/span_shadow.h"

#define SHORT 12 /* pixels of shorter runs are drawn one by one */
#define LEAF 8   /* at a shadow's edge, runs up to this length are computed pixel by pixel instead of divided */
#define DEPTH 12 /* largest number of pending samples */

/* Returns 1 if |Q - P|^2 certainly grows somewhere between two samples, -1 if it falls, 0 if neither is certain. */
static int8_t rise(const struct coherence_run *run, num_wide from, num_wide to)
{
    num_wide more = to - from;

    return more > run->square_slack ? 1 : more < -run->square_slack ? -1 : 0;
}

/* ---- shadows between two samples ---- */

/* Returns COHERENCE_DARK if caster j shadows all pixels between two samples, COHERENCE_LIT if it shadows none, or
 * COHERENCE_OPEN.
 *
 * As P moves by up to `path` from the nearer sample, the shadow ray turns around Q by up to path/d. Its distance h from
 * C changes by up to m = |C - Q| path/d + 2 bias, since the ray starts at a distance `bias` from P. With h^2 off by up
 * to e at a sample and at a pixel, h stays above R where h^2 - R^2 > 2 m (R + m) + 3 e at the samples, as
 *
 *     (sqrt(R^2 + e) + m)^2 <= R^2 + e + 2 R m + m^2 + 2 m sqrt(e) <= R^2 + 2 e + 2 R m + 2 m^2,
 *
 * and below R where h^2 - R^2 is below minus this sum. |w| - A'.w/|w| = (C - Q).(P - Q)/|w| changes by up to m, and |w|
 * by up to `path`. */
static int shadow_between(const struct coherence_run *run, const struct coherence_caster *cast, int j,
                          const struct coherence_sample *a, const struct coherence_sample *b, num_wide path)
{
    num_wide square = a->square < b->square ? a->square : b->square, d = (num_wide)(a->far < b->far ? a->far : b->far);

    if (2 * path >= d)
        return COHERENCE_OPEN;
    num_u turn = num_quotient((num_u)path, (num_u)d, 39); /* 24 bits */
    turn += COHERENCE_WIDE(COHERENCE_TURNING, turn / COHERENCE_TURNING + (num_u)num_bound(0));
    struct coherence_slack slack = coherence_shadow_slack(run, cast, square, (num_wide)b->slack);
    if (slack.length > num_bound(COHERENCE_LENGTH_MOST) || slack.power > num_bound(COHERENCE_POWER_MOST))
        return COHERENCE_OPEN;
    num_wide m = num_down(cast->away * (num_wide)turn, 24) + run->bias + num_bound(COHERENCE_BITS(COHERENCE_SLIDE));
    num_wide foot = num_max(num_abs((num_wide)a->foot[j]), num_abs((num_wide)b->foot[j])) + m + path + slack.length;
    num_wide margin = 2 * m * (cast->radius + m) +
                      COHERENCE_WIDE(COHERENCE_ERRORS, COHERENCE_ERRORS * (2 * foot * slack.length + slack.power));
    if (a->clear[j] > margin && b->clear[j] > margin)
        return COHERENCE_LIT;
    num_wide behind = m + COHERENCE_WIDE(COHERENCE_BEHIND, COHERENCE_BEHIND * slack.length), before = behind + path;
    if (a->clear[j] < -margin && b->clear[j] < -margin && (num_wide)a->foot[j] > before &&
        (num_wide)b->foot[j] > before && (num_wide)(a->far - a->foot[j]) > behind &&
        (num_wide)(b->far - b->foot[j]) > behind)
        return COHERENCE_DARK;
    return COHERENCE_OPEN;
}

static int shadows_between(const struct coherence_run *run, const struct coherence_sample *a,
                           const struct coherence_sample *b)
{
    int all = COHERENCE_LIT;

    if (run->caster_count == 0 || (!a->faces && !b->faces))
        return COHERENCE_LIT;
    if (!a->faces || !b->faces)
        return COHERENCE_OPEN;
    num_wide path = coherence_path(run, a, b);
    for (int j = 0; j < run->caster_count; j++) {
        int shadow = shadow_between(run, &run->caster[j], j, a, b, path);
        if (shadow == COHERENCE_DARK)
            return COHERENCE_DARK;
        all = shadow == COHERENCE_OPEN ? COHERENCE_OPEN : all;
    }
    return all;
}

/* ---- a run ---- */

/* A run being drawn into the pixels from `first` on. */
struct drawing {
    struct coherence_run *run;
    const struct tia_view *view;
    struct colouring colouring;
    uint32_t object;
    int first;
    const num_u *threshold;
    tia_rgb565 *pixels;
};

static void put(const struct drawing *d, int x, tia_rgb565 pixel)
{
    d->pixels[x - d->first] = span_order(d->threshold, pixel);
}

/* Draws a pixel by itself. */
static void settle(const struct drawing *d, int x)
{
    num_u t;
    struct shaded_span one = {d->object, x, d->run->y, 1, &t, NULL, NULL};

    coherence_go(d->run, x);
    d->run->kernels->sphere(&d->run->body, &t);
    shade_span(d->view, &one, d->threshold, d->pixels + (x - d->first));
}

/* Draws a pixel whose lambert is off by up to `slack`. */
static void put_lambert(const struct drawing *d, int x, num_u lambert, num_u slack)
{
    if (NUM_CERTIFIED && !is_one_colour(&d->colouring, lambert, lambert, slack))
        settle(d, x);
    else
        put(d, x, colour_of(&d->colouring, lambert, 0));
}

static num_u smaller(num_u a, num_u b)
{
    return a < b ? a : b;
}

static bool same_between(const struct drawing *d, const struct coherence_sample *a, const struct coherence_sample *b)
{
    num_u low = smaller(a->lambert, b->lambert);

    return is_one_colour(&d->colouring, low, a->lambert + b->lambert - low, b->slack);
}

static bool monotone(const struct coherence_sample *a, const struct coherence_sample *b)
{
    return b->x - a->x <= 1 || (a->before != 0 && a->before == b->behind);
}

static num_u slack_between(const struct coherence_run *run, const struct coherence_sample *a,
                           const struct coherence_sample *b)
{
    num_wide slack = coherence_lambert_slack(run, a->square < b->square ? a->square : b->square);

    return slack < (num_wide)NUM_ONE ? (num_u)slack : NUM_ONE;
}

/* Bounds the errors of pixels between two samples, where |Q - P|^2 is at least `square`, and the doubts of all casters;
 * false if that is not possible. */
static bool bound_leaf(struct coherence_run *run, num_wide square, struct span_error *error)
{
    bool known;

    *error = run->error;
    span_error_lambert(&run->source, square, error);
    known = error->lambert < 0;
    for (int j = 0; known && j < run->caster_count; j++)
        known = span_error_shadow(&run->source, run->caster[j].sphere, error, &run->caster[j].line);
    run->light.facing_doubt = span_error_facing(&run->source, &run->light, error);
    return known;
}

/* Draws the pixels from sample a to sample b, both included, one by one. */
static void draw_leaf(const struct drawing *d, const struct coherence_sample *a, const struct coherence_sample *b)
{
    struct span_error error;
    bool known = !NUM_CERTIFIED || bound_leaf(d->run, a->square < b->square ? a->square : b->square, &error);

    for (int x = a->x; x <= b->x; x++) {
        bool open = !known;
        num_u lambert = known ? coherence_lambert_at(d->run, x, &open) : 0;
        if (open)
            settle(d, x);
        else
            put_lambert(d, x, lambert, NUM_CERTIFIED ? (num_u)span_error_number(30 * 256 + error.lambert) : 0);
    }
    d->run->light.facing_doubt = 0;
}

/* Draws the pixels from sample a to sample b, both included; false when the pixels between the samples must be
 * divided. */
static bool draw_between(const struct drawing *d, const struct coherence_sample *a, struct coherence_sample *b)
{
    if (b->shadow == COHERENCE_OPEN && monotone(a, b)) {
        if (b->slack == 0)
            b->slack = slack_between(d->run, a, b);
        if (b->slack < NUM_ONE / COHERENCE_COARSE)
            b->shadow = (uint8_t)shadows_between(d->run, a, b);
    }
    if (b->shadow == COHERENCE_LIT && b->x - a->x <= 1) {
        if (a->x == d->first) /* otherwise drawn together with the pixel in front of it */
            put_lambert(d, a->x, a->lambert, b->slack);
        if (b->x > a->x)
            put_lambert(d, b->x, b->lambert, b->slack);
    } else if (b->shadow == COHERENCE_DARK ||
               (b->shadow == COHERENCE_LIT && a->pixel == b->pixel && same_between(d, a, b))) {
        tia_rgb565 pixel = b->shadow == COHERENCE_DARK ? colour_of(&d->colouring, 0, 0) : a->pixel;
        span_fill(d->pixels + (a->x - d->first), b->x + 1 - a->x, span_order(d->threshold, pixel));
    } else if (b->shadow == COHERENCE_OPEN && b->x - a->x <= LEAF) {
        draw_leaf(d, a, b);
    } else {
        return false;
    }
    return true;
}

/* Returns the last pixel with the colour of `a` if lambert were linear from a to b; if that pixel is a's, the next. */
static int guess(const struct colouring *c, const struct coherence_sample *a, const struct coherence_sample *b)
{
    num_u from = a->lambert, to = b->lambert, apart = (to > from ? to - from : from - to) / (num_u)(b->x - a->x);
    num start = num_signed(from), step = to > from ? num_signed(apart) : -num_signed(apart);
    int low = a->x, high = b->x;

    while (high - low > 1) {
        int x = low + (high - low) / 2;
        if (colour_of(c, (num_u)(start + (num)(x - a->x) * step), 0) == a->pixel)
            low = x;
        else
            high = x;
    }
    return low > a->x ? low : low + 1;
}

/* Divides the run between two samples by a third, s, in the middle. A lit run so short that `room` more samples are
 * enough to halve it completely is divided where the colour probably changes. */
static void divide(const struct drawing *d, const struct coherence_sample *a, struct coherence_sample *b, int room,
                   struct coherence_sample *s)
{
    if (d->run->caster_count > 0 && !a->faces)
        b->shadow = COHERENCE_OPEN; /* not tested yet */
    bool guessed = b->shadow == COHERENCE_LIT && (b->x - a->x) >> room == 0;
    int x = guessed ? guess(&d->colouring, a, b) : a->x + (b->x - a->x) / 2;

    coherence_sample_at(d->run, x, b->shadow == COHERENCE_OPEN && d->run->caster_count > 0, s);
    s->pixel = colour_of(&d->colouring, s->lambert, 0);
    s->shadow = b->shadow;
    s->slack = b->slack; /* |Q - P|^2 is not below the smaller of its values at a and b */
    s->behind = rise(d->run, s->square, b->square);
    if (s->behind == 0 || monotone(a, b))
        s->behind = b->behind;
}

static void end_sample(const struct drawing *d, int x, struct coherence_sample *s)
{
    coherence_sample_at(d->run, x, d->run->caster_count > 0, s);
    s->pixel = colour_of(&d->colouring, s->lambert, 0);
    s->before = s->behind = 0;
    s->slack = 0;
    s->shadow = COHERENCE_OPEN;
}

/* Draws a run: computes samples at both ends and, where the pixels between two samples cannot be drawn, a sample
 * between them. */
static void draw_run(const struct drawing *d, int first, int last)
{
    struct coherence_run *run = d->run;
    /* `right` has the pending samples, the nearest last; then unused ones. */
    struct coherence_sample sample[DEPTH + 1], *left = &sample[0], *right[DEPTH];
    int depth = 1;

    for (int i = 0; i < DEPTH; i++)
        right[i] = &sample[i + 1];
    end_sample(d, first, left);
    end_sample(d, last, right[0]);
    coherence_measure(run, left, right[0]);
    left->before = rise(run, coherence_square_at(run, first - 1), left->square);
    right[0]->behind = rise(run, right[0]->square, coherence_square_at(run, last + 1));
    while (depth > 0) {
        struct coherence_sample *b = right[depth - 1];
        if (draw_between(d, left, b)) {
            int8_t grown = rise(run, left->square, b->square);
            b->before = grown ? grown : left->before;
            right[--depth] = left;
            left = b;
        } else {
            divide(d, left, b, DEPTH - depth - 1, right[depth]);
            depth++;
        }
    }
}

/* ---- preparing ---- */

static int length_exponent(const struct coherence_run *run, const struct span_view *spans, const uint32_t *casters)
{
    num_wide most = 0;

    for (int j = 0; j < run->caster_count; j++) {
        const struct span_sphere *s = &spans->spheres[casters[j]];
        num_wide size = num_abs(s->centre.x) + num_abs(s->centre.y) + num_abs(s->centre.z) + s->radius;
        most = num_max(most, size);
    }
    most += num_abs(run->source.light.x) + num_abs(run->source.light.y) + num_abs(run->source.light.z);
    int exponent = 46 - span_bits(most + span_power(16 + ((run->error.point + 255) >> 8)));
    return exponent < 40 ? exponent : 40; /* the bias is then below 2^29 */
}

/* Prepares the casters; false when there are too many, or the light is inside one. */
static bool prepare_casters(struct coherence_run *run, const struct tia_view *view, uint32_t object)
{
    const struct span_view *spans = span_view_of(view);
    const struct span_lit lit = {.casters = &spans->casters, .object = object};
    uint32_t casters[COHERENCE_CASTERS];

    run->caster_count = 0;
    for (uint32_t j = span_next_caster(&lit, run->source.number, 0); j < view->scene->sphere_count;
         j = span_next_caster(&lit, run->source.number, j + 1)) {
        /* One caster too many overwrites the first, and the run is then not drawn here. */
        struct coherence_caster *cast = &run->caster[run->caster_count % COHERENCE_CASTERS];
        if (spans->spheres[j].c < 0)
            return false;
        shadow_line_prepare(run->primary, &run->source, &spans->spheres[j], run->middle, run->y, &cast->line);
        if (cast->line.enclosed || run->caster_count == COHERENCE_CASTERS)
            return false;
        casters[run->caster_count++] = j;
        cast->sphere = &spans->spheres[j];
        cast->line.count = 1;
        cast->a = cast->line.a;
        cast->c = cast->line.c;
    }
    run->exponent = length_exponent(run, spans, casters);
    run->bias = span_shift(2 * NUM_BIAS, run->exponent - 16) + num_bound(COHERENCE_BITS(COHERENCE_BIAS));
    for (int j = 0; j < run->caster_count; j++)
        coherence_bound_caster(run, &spans->spheres[casters[j]], &run->caster[j]);
    return true;
}

static bool prepare_run(struct coherence_run *run, const struct tia_view *view, const struct shaded_span *span,
                        int first, int last)
{
    const struct span_view *spans = span_view_of(view);

    run->primary = &spans->primary;
    run->kernels = spans->kernels;
    run->sphere = &spans->spheres[span->object];
    run->source.sphere = run->sphere;
    run->source.number = 0;
    run->source.light = num_vec_between(view->scene->camera.eye, view->lights[0].centre);
    run->y = span->y;
    run->middle = run->primary->width / 2;
    span_sphere_line(run->primary, run->sphere, run->y, run->middle, &run->body);
    light_line_prepare(run->primary, &run->source, run->middle, run->y, &run->light);
    run->body.count = run->light.count = 1;
    run->b = run->body.b;
    run->g = run->light.g;
    run->q = run->light.q;
    num_wide row = primary_y(run->primary, run->y);
    run->row_square = num_square(row) + num_square(run->primary->depth);
    return coherence_bound(run, first, last) && prepare_casters(run, view, span->object);
}

bool coherence_shade(const struct tia_view *view, const struct shaded_span *span, const num_u threshold[THRESHOLDS],
                     tia_rgb565 *pixels)
{
    const struct tia_scene *scene = view->scene;
    struct coherence_run run;
    struct drawing d;
    int last = span->x + span->count - 1;

    if (span->count < SHORT || view->light_count != 1 || threshold[0] != threshold[1] ||
        !prepare_run(&run, view, span, span->x - 1, last + 1))
        return false;
    d.run = &run;
    d.view = view;
    d.object = span->object;
    d.threshold = threshold;
    d.first = span->x;
    d.pixels = pixels;
    colouring_prepare(view, &scene->materials[scene->spheres[span->object].material], threshold[0], &d.colouring);
    draw_run(&d, span->x, last);
    return true;
}
