/* The steps of a ball's colour against 113 bits: each step is where a channel reaches a level, A and D are within their
 * bounds, and every pixel that is decided has the colour of the formulas. */
#include "check.h"
#include "random.h"
#include "simd_truth.h"
#include "simd_used.h"
#include "span_regimes.h"

#include "render/span/span.h"

#define STEPS_HALVES 0
#include "render/span/steps/steps_row.c"
#include "render/span/steps/steps_side.c"
#include "render/span/steps/steps_table.c"
#include "render/span/steps/steps_walk.c"

#if TRUTH_KNOWN
enum { WORDS, FORMS, DEPTHS, TURNS, BOUNDS };
static struct used bounds[BOUNDS] = {{"W", 0, 0}, {"A", 0, 0}, {"D", 0, 0}, {"where u turns", 0, 0}};
static unsigned long decided, open_pixels, steps_seen, ways[3];

static quad power(int e)
{
    quad x = 1;

    for (int i = 0; i < (e < 0 ? -e : e); i++)
        x *= 2;
    return e < 0 ? 1 / x : x;
}

/* A picture of one ball under one light, and its exact values. */
struct world {
    const struct tia_scene *scene;
    const struct span_view *spans;
    const struct colour_steps *steps;
    int size[2];
    quad depth, l[3], q[3], g[3], r, c, f, p;
};

static const unsigned most[3] = {31, 63, 31};

static tia_q30 channel(const struct tia_rgb *c, int i)
{
    return i == 0 ? c->r : i == 1 ? c->g : c->b;
}

/* Returns the cosine with which a channel reaches a level. */
static quad lambda_of(const struct world *w, int i, int level)
{
    const struct tia_material *m = &w->scene->materials[0];
    quad product = (quad)channel(&m->colour, i) * (quad)channel(&w->scene->lights[0].emission, i) * power(-60);

    return ((2 * level - 1) / (quad)(2 * most[i]) - channel(&m->emission, i) * power(-30)) / product;
}

/* Returns W, in its last bits. */
static quad word_at(const struct world *w, quad lambda)
{
    quad away = w->p / (w->r * lambda + quad_root(w->r * w->r * lambda * lambda + w->p));

    return (w->r * lambda * away - w->f) / w->c * power(w->steps->form_shift - w->spans->spheres[0].b_shift + 32);
}

static int pixel_level(tia_rgb565 pixel, int i)
{
    return i == 0 ? pixel >> 11 : i == 1 ? pixel >> 5 & 63 : pixel & 31;
}

/* Each entry is a level of its channels, none is missing, and they ascend. */
static void try_table(const struct world *w)
{
    int level[3];

    for (int i = 0; i < 3; i++)
        level[i] = pixel_level(w->steps->pixel[0], i);
    for (int k = 0; k < w->steps->count; k++) {
        CHECK(w->steps->pixel[k + 1] != w->steps->pixel[k]);
        CHECK(k == 0 || w->steps->at[k] >= w->steps->at[k - 1] - 2 * STEPS_WORD);
        for (int i = 0; i < 3; i++)
            if (pixel_level(w->steps->pixel[k + 1], i) != pixel_level(w->steps->pixel[k], i))
                use(&bounds[WORDS], (real)(w->steps->at[k] - word_at(w, lambda_of(w, i, ++level[i]))),
                    STEPS_BOUND(STEPS_WORD));
    }
    for (int i = 0; i < 3; i++)
        CHECK(level[i] == (int)most[i] || lambda_of(w, i, level[i] + 1) > 1);
    steps_seen += w->steps->count;
}

/* A and D at the row's pixel, with a random step. */
static void try_forms(const struct world *w, const struct step_row *row, const struct truth *o)
{
    const struct primary_rays *primary = &w->spans->primary;
    int b_shift = w->spans->spheres[0].b_shift, k = (int)(random_bits() % (w->steps->count + 1u));
    quad unit = power(primary->exponent + b_shift - 16);
    struct step_point point;

    steps_point(row, &point);
    quad d = (quad)(int64_t)(point.d - ((uint64_t)(uint32_t)w->steps->depth_doubt << 32)) * power(-32);
    use(&bounds[DEPTHS], (real)(d - o->d * unit * unit * power(-32)), w->steps->depth_doubt);
    if (k == w->steps->count)
        return;
    quad word = w->steps->at[k], form = quad_dot(w->g, o->v) * power(primary->exponent + w->steps->form_shift - 16);
    use(&bounds[FORMS], (real)(steps_top(form_at(&point, w->steps->at[k])) - (form - word * o->b * unit * power(-32))),
        w->steps->fine_doubt - STEPS_BOUND(STEPS_WORD));
}

/* Where u grows at the row's pixel, and what decides it: l and omega S with their words' exponents. */
static void try_way(const struct world *w, const struct step_row *row, const struct truth *o)
{
    const struct primary_rays *primary = &w->spans->primary;
    quad unit = power(primary->exponent + w->spans->spheres[0].b_shift - 16), long_step = power(w->steps->turn_shift);
    quad unit_g = power(primary->exponent + w->steps->form_shift - 16);
    quad g = quad_dot(w->g, o->v) * unit_g, g_step = 2 * w->g[0] * unit_g;
    quad b = o->b * unit, b_step = 2 * w->l[0] * unit;
    struct step_point point;
    int32_t a, word;

    if (!w->steps->turn_shift || o->d <= 0)
        return;
    quad d = o->d * unit * unit * power(-32),
         d_step = 2 * (o->b * 2 * w->l[0] - w->c * 2 * o->v[0]) * unit * unit * power(-32);
    steps_point(row, &point);
    turn_at(row, &point, &a, &word);
    quad l = (g_step * d - g * d_step / 2) * long_step * power(-32);
    quad omega = (g_step * b - g * b_step) * long_step * power(-32), s = quad_root(d) * power(-16);
    use(&bounds[TURNS], (real)(quad_size(a - l) + quad_size(word + omega) * s), w->steps->turn_doubt);
    int way = way_at(row);
    ways[way + 1]++;
    CHECK_MSG(!way || (omega * s + l > 0) == (way > 0), "u %s", way > 0 ? "falls" : "grows");
}

/* Returns the pixel of the formulas. */
static tia_rgb565 exact_pixel(const struct world *w, const struct truth *o)
{
    const struct tia_material *m = &w->scene->materials[0];
    struct truth_way way;
    unsigned level[3];

    truth_look(o, w->q, &way);
    for (int i = 0; i < 3; i++) {
        quad light = (quad)channel(&m->colour, i) * (quad)channel(&w->scene->lights[0].emission, i) * power(-60);
        quad sum = channel(&m->emission, i) * power(-30) + light * (way.cosine > 0 ? way.cosine : 0);
        level[i] = (unsigned)(most[i] * (sum < 1 ? sum : 1) + (quad).5);
    }
    return (tia_rgb565)(level[0] << 11 | level[1] << 5 | level[2]);
}

static void try_row(const struct world *w, int y, struct span span)
{
    const struct span_sphere *sphere = &w->spans->spheres[0];
    static tia_rgb565 pixels[4096];
    static struct truth truth[4096];
    struct step_row row = {.swap = false};
    int count = span.end - span.first < 1024 ? span.end - span.first : 1024;

    steps_begin(&w->spans->primary, sphere, w->steps, span.first, y, count, &row);
    for (int i = 0; i < count; i++) {
        truth_meet(w->scene, w->size, w->depth, span.first + i, y, w->scene->spheres[0].centre,
                   w->scene->spheres[0].radius, &truth[i]);
        struct step_row there = row;
        there.at = i;
        try_forms(w, &there, &truth[i]);
        try_way(w, &there, &truth[i]);
    }
    while (row.at < count) {
        int at = row.at;
        uint64_t open = steps_draw(&row, pixels + at);
        CHECK(row.at > at && row.at <= at + STEPS_BLOCK && row.at <= count);
        for (int i = at; i < row.at; i++) {
            bool in_doubt = open >> (i - at) & 1;
            open_pixels += in_doubt;
            decided += !in_doubt;
            tia_rgb565 want = exact_pixel(w, &truth[i]);
            CHECK_MSG(in_doubt || pixels[i] == want, "%d x %d, pixel (%d, %d) is %04x, not %04x", w->size[0],
                      w->size[1], span.first + i, y, pixels[i], want);
        }
    }
}

static bool is_usable(const struct tia_view *view)
{
    const struct colour_steps *steps = steps_number(span_view_of(view)->steps, span_view_of(view)->spheres[0].steps);

    return steps && steps->usable;
}

static void try_scene(const struct tia_scene *scene, unsigned width, unsigned height)
{
    size_t size = tia_view_size(scene, 1);
    void *memory = malloc(size);
    struct tia_view *view;

    if (!tia_view_init(&view, memory, size, scene, 1, width, height, NULL) && is_usable(view)) {
        const struct span_view *spans = span_view_of(view);
        struct world w = {.scene = scene,
                          .spans = spans,
                          .steps = spans->steps,
                          .size = {(int)width, (int)height},
                          .depth = truth_depth(height, scene->camera.fov),
                          .r = (quad)scene->spheres[0].radius / 65536};
        truth_place(scene, scene->spheres[0].centre, w.l);
        truth_place(scene, scene->lights[0].centre, w.q);
        for (int i = 0; i < 3; i++)
            w.g[i] = w.q[i] - w.l[i];
        w.c = quad_dot(w.l, w.l) - w.r * w.r;
        w.f = w.c - quad_dot(w.l, w.q);
        w.p = quad_dot(w.g, w.g) - w.r * w.r;
        try_table(&w);
        struct span rows = spans->spheres[0].rows;
        for (int i = 0; i < 4 && rows.first < rows.end; i++) {
            int y = rows.first + (int)(random_bits() % (unsigned)(rows.end - rows.first));
            struct span span = span_sphere_row(view, 0, y, (struct span){0, 0});
            if (span.first < span.end)
                try_row(&w, y, span);
        }
    }
    free(memory);
}

static tia_q30 random_channel(void)
{
    return random_bits() % 4 ? (tia_q30)(random_u32() >> 2) : random_bits() & 1 ? TIA_Q30(1) : 0;
}

static void paint(struct regime *r)
{
    struct tia_material *m = &r->materials[0];
    bool grey = random_bits() & 1;

    m->colour = (struct tia_rgb){random_channel(), random_channel(), random_channel()};
    m->emission = (struct tia_rgb){random_channel() / 4, random_channel() / 4, random_channel() / 8};
    r->light.emission = (struct tia_rgb){random_channel(), random_channel(), random_channel()};
    if (grey) {
        m->colour.g = m->colour.b = m->colour.r;
        m->emission.g = m->emission.b = m->emission.r;
        r->light.emission.g = r->light.emission.b = r->light.emission.r;
    }
}

TEST(steps_are_those_of_the_formulas)
{
    static struct regime r;
    unsigned count = check_count(6000);

    for (unsigned i = 0; i < count; i++)
        if (regime_make(&r, i, false)) {
            paint(&r);
            r.scene.sphere_count = 1;
            try_scene(&r.scene, r.width, r.height);
        }
    check_used(bounds, BOUNDS);
    printf("# %lu steps; %lu pixels decided, %lu in doubt\n", steps_seen, decided, open_pixels);
    printf("# u falls at %lu, grows at %lu pixels, %lu in doubt\n", ways[0], ways[2], ways[1]);
    CHECK(ways[1] < (ways[0] + ways[2]) / 10);
    CHECK(steps_seen > count && decided > 15 * count && open_pixels < decided / 50);
}

/* Products of halves are too small by less than 3. */
#undef TIA_RENDER_SPAN_STEPS_STEPS_ROW_H
#undef STEPS_HALVES
#define STEPS_HALVES 1
#define steps_high halves_high
#define steps_high_sum halves_high_sum
#define steps_square halves_square
#define steps_top halves_top
#define steps_times halves_times
#define steps_above halves_above
#define step_point halves_pixel
#undef steps_point
#undef steps_side
#undef steps_upper
#define steps_upper halves_upper
#define steps_point halves_point
#define steps_side halves_side
#undef STEPS_HALF
#include "render/span/steps/steps_row.h"

TEST(products_of_halves_are_cut_off_by_less_than_3)
{
    static const int32_t ends[] = {0,        1,          -1,          0xffff,     0x10000,
                                   -0x10000, 0x3fffffff, -0x3fffffff, 0x3fff0000, 0x40000000};
    double worst = 0;

    for (int i = 0; i < 1000000; i++) {
        int32_t a = random_bits() % 8 ? (int32_t)random_u32() / 2 : ends[random_bits() % 10];
        int32_t b = random_bits() % 8 ? (int32_t)random_u32() / 2 : ends[random_bits() % 10];
        double short_by = (double)((long double)a * b / 0x1p32L - halves_high(a, b));
        worst = short_by > worst ? short_by : worst;
        CHECK_MSG(short_by >= 0 && short_by < 3, "%d * %d", (int)a, (int)b);
    }
    CHECK_MSG(worst > 2, "the worst is %g", worst);
}

int main(void)
{
    RUN(steps_are_those_of_the_formulas);
    RUN(products_of_halves_are_cut_off_by_less_than_3);
    return check_status();
}

#else
int main(void)
{
    printf("skip steps: no numbers of 113 bits on this machine\n");
    return 0;
}
#endif
