/* Coherence against the same pixels one by one: random and constructed scenes, rows of any width, guard pixels. No
 * error exceeds its bound, and the worst of some thousand runs has more than a tenth of it, so that a bound of a tenth
 * of the right size is detected here. */
#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "common/corpus/corpus.h"
#include "common/corpus/dice.h"
#include "edge_scene.h"
#include "render/core/dither.h"
#include "render/span/coherence/coherence.c"
#include "span_points.h"

enum { DISTANCE, REACH, SQUARE, FACING, TURNS, LAMBERT, FOOT, CLEAR, PATH, CHORD, BOUNDS };

/* Bounds that are sums of up to four powers of two have a reserve: the worst error times `reserve` is within the bound.
 */
static struct {
    const char *name;
    double reserve, worst;
    unsigned long tried;
} bounds[BOUNDS] = {[DISTANCE] = {"t", 1, 0, 0},
                    [REACH] = {"|P|^2", 1, 0, 0},
                    [SQUARE] = {"|Q - P|^2", 1, 0, 0},
                    [FACING] = {"r N.(Q - P)", 1, 0, 0},
                    [TURNS] = {"where |Q - P|^2 turns", 2, 0, 0},
                    [LAMBERT] = {"lambert", 1, 0, 0},
                    [FOOT] = {"A'.w/|w|", 2, 0, 0},
                    [CLEAR] = {"h^2 - R^2", 16, 0, 0},
                    [PATH] = {"P between samples", 1, 0, 0},
                    [CHORD] = {"a run's chord", 1, 0, 0}};

static void note(int which, real value, real bound)
{
    double ratio = (double)(fabsl(value) / bound);

    bounds[which].tried++;
    bounds[which].worst = ratio > bounds[which].worst ? ratio : bounds[which].worst;
}

/* ---- bounds ---- */

static void try_caster(const struct coherence_run *run, const struct coherence_sample *s, int j,
                       const struct span_sphere *caster, struct vector p, num_wide slack)
{
    const struct coherence_caster *cast = &run->caster[j];
    struct coherence_slack off = coherence_shadow_slack(run, cast, s->square, slack);
    struct vector w = along(vector_of(run->source.light), -1, p), l = vector_of(run->sphere->centre);
    struct vector a = along(vector_of(caster->centre), -1, p);
    real radius = (real)run->sphere->radius * 0x1p-16L, r = (real)caster->radius * 0x1p-16L,
         unit = power(run->exponent);

    if (off.length > span_power(24) || off.power > span_power(58))
        return;
    a = along(a, -0x1p-13L / radius, along(p, -1, l)); /* A' = A - bias N */
    real foot = dot(a, w) / sqrtl(dot(w, w)), clear = dot(a, a) - r * r - foot * foot;
    note(FOOT, s->foot[j] - foot * unit, (real)off.length);
    real most = fabsl((real)s->foot[j]) + (real)off.length;
    note(CLEAR, (real)s->clear[j] - clear * unit * unit, 2 * most * (real)off.length + (real)off.power);
}

/* Returns the last bit of r N.(Q - P) in the light's line, see span_light.c. */
static real facing_unit(const struct coherence_run *run)
{
    return power(run->light.scale + run->sphere->radius_bits - 15 - (run->source.exponent >> 1));
}

static void try_sample(struct coherence_run *run, const struct span_view *spans, const uint32_t *casters, int x)
{
    struct coherence_sample s;
    const struct span_error *e = &run->error;
    struct vector q = vector_of(run->source.light);
    real t, light = power(run->source.exponent);
    struct vector p = point(run, x, &t);

    coherence_sample_at(run, x, run->caster_count > 0, &s);
    real integer = (real)s.t * power(-run->sphere->t_exponent); /* 2^t_exponent applies to v with its exponent */
    struct vector v = direction(run, x), w = along(q, -1, p), off = along(q, -integer, v);
    note(DISTANCE, integer / t - 1, bound_of(e->t));
    real reach = (real)light_reach(&run->light, num_signed(s.t), run->light.square.start);
    note(REACH, reach * power(-run->source.reach_exponent) - integer * integer * dot(v, v), bound_of(e->reach));
    note(SQUARE, (real)s.square / light - dot(off, off), bound_of(e->square));
    note(TURNS, 2 * ((real)s.square - dot(w, w) * light), (real)run->square_slack);
    real facing = dot(along(p, -1, vector_of(run->sphere->centre)), w);
    note(FACING,
         (real)(run->light.facing + num_mul(num_signed(s.t), num_top(run->light.g))) * facing_unit(run) - facing,
         bound_of(e->facing));
    num_wide slack = coherence_lambert_slack(run, s.square);
    if (!s.faces || slack >= (num_wide)NUM_ONE)
        return;
    real cosine = facing / ((real)run->sphere->radius * 0x1p-16L * sqrtl(dot(w, w)));
    note(LAMBERT, s.lambert - cosine * 0x1p30L, (real)slack);
    for (int j = 0; slack < (num_wide)NUM_ONE / 64 && j < run->caster_count; j++)
        try_caster(run, &s, j, &spans->spheres[casters[j]], p, slack);
}

/* Checks the bound of the distance between the points of pixels and the nearer one of two samples. */
static void try_path(struct coherence_run *run, int first, int last)
{
    struct coherence_sample a, b;
    real t, unit = power(run->exponent);

    coherence_sample_at(run, first, false, &a);
    coherence_sample_at(run, last, false, &b);
    struct vector start = point(run, first, &t), end = point(run, last, &t);
    real path = (real)coherence_path(run, &a, &b);
    for (int i = 1; i < 8; i++) {
        struct vector p = point(run, first + (last - first) * i / 8, &t);
        note(PATH, fminl(distance(p, start), distance(p, end)) * unit, path);
    }
}

/* Checks that the chord of a run is at most the diameter of the circle in which the plane of the row cuts the sphere.
 */
static void try_chord(struct coherence_run *run, int first, int last)
{
    struct coherence_sample a, b;
    struct vector v = direction(run, 0), l = vector_of(run->sphere->centre);
    real up = l.y * v.z - l.z * v.y, radius = (real)run->sphere->radius * 0x1p-16L;

    coherence_sample_at(run, first, false, &a);
    coherence_sample_at(run, last, false, &b);
    coherence_measure(run, &a, &b);
    if (run->chord > 0)
        note(CHORD, (real)run->chord * power(-run->exponent),
             2 * sqrtl(radius * radius - up * up / (v.y * v.y + v.z * v.z)));
}

/* Finds the casters of a run, in their order. */
static void find_casters(const struct coherence_run *run, const struct tia_view *view, uint32_t object,
                         uint32_t casters[COHERENCE_CASTERS])
{
    const struct span_lit lit = {.casters = &span_view_of(view)->casters, .object = object};
    uint32_t j = 0;

    for (int n = 0; n < run->caster_count; n++, j++)
        casters[n] = j = span_next_caster(&lit, 0, j);
}

static void try_bounds(const struct tia_view *view, const struct shaded_span *span)
{
    struct coherence_run run;
    uint32_t casters[COHERENCE_CASTERS] = {0};
    int last = span->x + span->count - 1, step = span->count / 7 + 1;

    if (span->count < 3 || !prepare_run(&run, view, span, span->x - 1, last + 1))
        return;
    find_casters(&run, view, span->object, casters);
    try_chord(&run, span->x, last);
    for (int x = span->x; x <= last; x += step)
        try_sample(&run, span_view_of(view), casters, x);
    for (int x = span->x; x < last; x += 2 * step + 1)
        try_path(&run, x, x + step < last ? x + step : last);
}

/* ---- pixels ---- */

#define MOST 1024
#define GUARDS 8
#define EVERY 23 /* one of so many pixels is compared with the exact pixel */

static unsigned long compared, left;
static bool check_ordered = true; /* the last cases check what all have compared */

/* Draws a span by the kernels for chunks, and some of its pixels exactly. */
static void draw_singly(const struct tia_view *view, const struct shaded_span *span, const num_u threshold[THRESHOLDS],
                        tia_rgb565 *want)
{
    struct exact_picture picture = span_picture_of(view);

    for (int i = 0; i < span->count; i += CHUNK) {
        num_u t[CHUNK];
        int count = span->count - i < CHUNK ? span->count - i : CHUNK;
        struct shaded_span part = {span->object, span->x + i, span->y, count, t, NULL, NULL};
        span_distances(span_view_of(view), span->object, span->y, part.x, count, t);
        shade_span(view, &part, threshold, want + i);
    }
    for (int i = span->x % EVERY; i < span->count; i += EVERY)
        want[i] = tia_exact_shade(&picture, span->x + i, span->y, span->object, (tia_q30)threshold[0], NULL, NULL);
}

static void try_pixels(const struct tia_view *view, const struct shaded_span *span)
{
    static tia_rgb565 want[MOST], got[MOST + 2 * GUARDS];
    num_u threshold[THRESHOLDS];

    dither_thresholds(false, span->y, threshold);
    span_set_order(threshold, false);
    memset(got, 0xa5, sizeof got);
    if (!coherence_shade(view, span, threshold, got + GUARDS)) {
        left += (unsigned long)span->count;
        return;
    }
    draw_singly(view, span, threshold, want);
    compared += (unsigned long)span->count;
    for (int i = 0; i < span->count; i++)
        CHECK_MSG(got[GUARDS + i] == want[i], "sphere %u, pixel %d of %d from (%d, %d): %04x, not %04x",
                  (unsigned)span->object, i, span->count, span->x, span->y, got[GUARDS + i], want[i]);
    for (int i = 0; i < GUARDS; i++)
        CHECK(got[i] == 0xa5a5 && got[GUARDS + span->count + i] == 0xa5a5);
}

/* Checks three parts of a row's span of a sphere: all of it, up to MOST pixels, and two random parts of 1 to 130
 * pixels, as tiles would cut it. */
static void try_row(const struct tia_view *view, uint32_t sphere, int y, uint64_t *state)
{
    struct span all = span_sphere_row(view, sphere, y, (struct span){0, 0});
    int width = all.end - all.first;

    for (int i = 0; i < 3 && width > 0; i++) {
        int count = i == 0 ? width : 1 + (int)(dice_next(state) % 130), room = width - count;
        count = count < MOST ? count : MOST;
        int first = all.first + (room > 0 ? (int)(dice_next(state) % ((unsigned)room + 1)) : 0);
        struct shaded_span span = {sphere, first, y, count < all.end - first ? count : all.end - first, NULL, NULL};
        try_pixels(view, &span);
        if (i < 2)
            try_bounds(view, &span);
    }
}

/* Checks a scene with only its first light. */
static void try_scene(struct tia_scene *scene, unsigned width, unsigned height, uint64_t seed)
{
    size_t size = tia_view_size(scene, 1);
    void *memory = malloc(size);
    struct tia_view *view;

    scene->light_count = 1;
    if (!tia_view_init(&view, memory, size, scene, 1, width, height, NULL)) {
        const struct span_view *spans = span_view_of(view);
        for (int y = (int)(seed % 3); y < (int)height; y += 3 + (int)height / 16)
            for (uint32_t n = 0; n < scene->sphere_count && !spans->tinted; n++) {
                const struct span_sphere *s = &spans->spheres[n];
                if (y >= s->rows.first && y < s->rows.end && s->c > 0 && s->c > s->centre.x * s->centre.x)
                    try_row(view, n, y, &seed);
            }
    }
    free(memory);
}

TEST(random_scenes)
{
    static struct edge_scene e;
    static struct corpus_scene c;

    for (unsigned i = 1; i <= 1500; i++) {
        edge_make(&e, i);
        if (e.scene.light_count)
            try_scene(&e.scene, e.width, e.height, i);
    }
    for (unsigned i = 0; i < 40; i++) {
        corpus_random(&c, 7, i);
        try_scene(&c.scene, 640, 480, i);
    }
}

/* Scenes with a ground and a ball on or near it, and a light: at the centre of the ball, on the tangent plane of a
 * visible point of the ground, or on the ground, above or below it. */
TEST(constructed_scenes)
{
    static const tia_q16 radii[] = {64, 655, TIA_Q16_ONE, 20 * TIA_Q16_ONE, 10000 * TIA_Q16_ONE};
    struct corpus_scene s;

    for (unsigned i = 0; i < 400; i++) {
        uint64_t state = i + 77;
        CHECK_EQ(corpus_thesis(&s, "a", 640, 480), TIA_OK);
        memcpy(s.spheres, s.scene.spheres, 2 * sizeof *s.spheres);
        s.scene.spheres = s.spheres;
        struct tia_sphere *ball = &s.spheres[1], *ground = &s.spheres[0];
        ball->radius = radii[i % 5 == 4 ? 2 : i % 5];
        ground->radius = radii[i / 5 % 5];
        ground->centre = (struct tia_vec3){0, -ground->radius - TIA_Q16_ONE, s.scene.camera.eye.z - 8 * TIA_Q16_ONE};
        ball->centre = ground->centre;
        ball->centre.y += ground->radius + ball->radius + (i & 1 ? 0 : edge_any(&state, 16));
        ball->centre.x += edge_any(&state, 18);
        struct tia_vec3 *light = &s.lights[0].centre;
        *light = i % 3 == 0 ? ball->centre : ground->centre;
        light->y += i % 3 == 1 ? ground->radius : 0; /* on the ground's tangent plane */
        light->x += i % 3 == 1 ? edge_any(&state, 20) : 0;
        light->z += i % 3 == 1 ? edge_any(&state, 20) : 0;
        light->y += i % 3 == 2 ? ground->radius + edge_any(&state, 18) : 0;
        s.lights[0].radius = 0;
        s.scene.light_count = 1;
        try_scene(&s.scene, i & 2 ? 640 : 1920, 60 + i % 7, i);
    }
}

/* NUM_CHANNEL_DOUBT is small against the slacks here. The light of two samples lies shares[i] times the slack above the
 * beginning of a level of 63. A pixel between the samples may have either level if that share is within -1..1, and else
 * has one. */
TEST(levels_within_the_slack)
{
    static const struct tia_rgb white = {NUM_ONE, NUM_ONE, NUM_ONE}, black = {0, 0, 0};
    static const double shares[] = {-1.9, -1.1, -.9, -.5, -.15, .15, .5, .9, 1.1, 1.9};
    struct corpus_scene s;
    struct drawing d;

    CHECK_EQ(corpus_thesis(&s, "", 64, 48), TIA_OK);
    s.scene.light_count = 1;
    s.lights[0].emission = white;
    size_t size = tia_view_size(&s.scene, 1);
    void *memory = malloc(size);
    struct tia_view *view;
    CHECK_EQ(tia_view_init(&view, memory, size, &s.scene, 1, 64, 48, NULL), TIA_OK);
    colouring_prepare(view, &(struct tia_material){.colour = white, .emission = black}, NUM_ROUND, &d.colouring);
    for (unsigned level = 1; level < 63; level++)
        for (int bits = 7; bits < 19; bits += 3)
            for (size_t i = 0; i < sizeof shares / sizeof *shares; i++)
                for (int apart = 0; apart < 2; apart++) {
                    double slack = ldexp(1, bits), begins = ldexp(level - .5, 30) / 63;
                    num_u at = (num_u)(begins + shares[i] * slack), away = (num_u)(apart * slack * 4);
                    num_u other = shares[i] < 0 ? at - away : at + away;
                    struct coherence_sample a = {.lambert = apart ? other : at}, b = {.lambert = at};
                    b.slack = (num_u)slack;
                    CHECK_MSG(same_between(&d, &a, &b) == (fabs(shares[i]) > 1), "level %u, %g of a slack of %g", level,
                              shares[i], slack);
                }
    free(memory);
}

/* Pictures whose rows have 1 to 130 pixels. */
TEST(rows_of_any_width)
{
    struct corpus_scene s;

    for (unsigned width = 1; width <= 130; width++) {
        CHECK_EQ(corpus_thesis(&s, width & 1 ? "" : "a", width, 40), TIA_OK);
        try_scene(&s.scene, width, 40, width);
    }
    CHECK_MSG(compared > 400000, "only %lu pixels were drawn, %lu not", compared, left);
}

TEST(bounds_hold_and_are_not_ten_times_too_wide)
{
    for (int i = 0; i < BOUNDS; i++) {
        printf("# %-22s %9lu values, the worst has %.3f of its bound\n", bounds[i].name, bounds[i].tried,
               bounds[i].worst);
        double worst = bounds[i].worst * bounds[i].reserve;
        CHECK_MSG(worst <= 1, "%s: %g times its bound less the reserve", bounds[i].name, worst);
        CHECK_MSG(worst > .1, "%s: no value has more than %g of its bound less the reserve", bounds[i].name, worst);
    }
}

int main(void)
{
    RUN(random_scenes);
    RUN(constructed_scenes);
    RUN(levels_within_the_slack);
    RUN(rows_of_any_width);
    RUN(bounds_hold_and_are_not_ten_times_too_wide);
    printf("# %lu pixels compared, %lu left to others\n", compared, left);
    return check_status();
}
