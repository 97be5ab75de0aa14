/* The parts of rows against docs/definition.md in 113 bits: where a part is lit no ball blocks the light, and where it
 * is dark one does; few pixels are left open.
 *
 *     test_span_parts [N]    N scenes of each kind */
#include "check.h"

#include "random.h"
#include "simd_truth.h"
#include "span_regimes.h"

#include "render/span/span.h"
#include "render/span/span_parts.h"

#if TRUTH_KNOWN
enum { MOST = 4096, BALLS = 6 };

static unsigned long seen[3], parts_seen, spans_seen;
static enum span_part part_of[MOST];
/* A picture and its exact values. */
struct world {
    const struct tia_scene *scene;
    int size[2];
    quad depth, q[3];
};

/* True if ball j blocks the light at a point that faces it. */
static bool blocks(const struct world *w, const struct truth *o, const struct truth_way *way, uint32_t j)
{
    const struct tia_sphere *s = &w->scene->spheres[j];
    quad c[3], out[3], r = (quad)s->radius / 65536;
    struct truth_caster caster;

    truth_place(w->scene, s->centre, c);
    truth_approach(o, way, c, r, &caster);
    for (int i = 0; i < 3; i++)
        out[i] = c[i] - w->q[i];
    return caster.a > 0 && caster.a * caster.a >= caster.h * way->square &&
           (quad_dot(out, out) <= r * r || way->square > caster.a);
}

static void try_pixel(const struct world *w, uint32_t object, int x, int y, enum span_part part)
{
    const struct tia_sphere *s = &w->scene->spheres[object];
    struct truth_way way;
    struct truth o;
    bool blocked = false;

    truth_meet(w->scene, w->size, w->depth, x, y, s->centre, s->radius, &o);
    truth_look(&o, w->q, &way);
    seen[part]++;
    if (part == SPAN_OPEN || way.cosine <= 0)
        return;
    for (uint32_t j = 0; j < w->scene->sphere_count; j++)
        blocked = blocked || (j != object && blocks(w, &o, &way, j));
    CHECK_MSG(blocked == (part == SPAN_DARK), "%d x %d, pixel (%d, %d) of %u is %s", w->size[0], w->size[1], x, y,
              object, blocked ? "in the shadow" : "lit");
}

static void try_span(const struct tia_view *view, const struct world *w, uint32_t object, int x, int y, int count)
{
    struct span_run runs[SPAN_RUNS];
    int at = 0;

    while (at < count) {
        int from = at, found = span_divide(view, object, x + from, y, count - from, runs);
        CHECK(found > 0 && found <= SPAN_RUNS);
        parts_seen += (unsigned long)found;
        for (int i = 0; i < found; i++) {
            CHECK(runs[i].end > at - from && from + runs[i].end <= count);
            for (; at < from + runs[i].end; at++)
                part_of[at] = runs[i].part;
        }
    }
    spans_seen++;
    for (int i = 0; i < count; i += 1 + (int)(random_bits() & 3))
        try_pixel(w, object, x + i, y, part_of[i]);
}

/* Tries each run of pixels of a row that show one ball. */
static void try_row(const struct tia_view *view, const struct world *w, int y)
{
    static uint64_t memory[2 * MOST + 64];
    struct tia_tile tile = {0, (uint16_t)y, (uint16_t)w->size[0], 1};
    struct tia_hits *hits;

    CHECK_EQ(tia_hits_init(&hits, memory, sizeof memory, view, tile), TIA_OK);
    CHECK_EQ(tia_view_trace(view, hits, tile), TIA_OK);
    for (int x = 0, end; x < w->size[0]; x = end) {
        uint32_t object = tia_hits_object(hits, (unsigned)x, (unsigned)y);
        end = x + 1;
        while (end < w->size[0] && end - x < 1024 && tia_hits_object(hits, (unsigned)end, (unsigned)y) == object)
            end++;
        if (object < w->scene->sphere_count)
            try_span(view, w, object, x, y, end - x);
    }
}

static bool is_outside(const struct tia_view *view)
{
    for (uint32_t i = 0; i < view->scene->sphere_count; i++)
        if (span_view_of(view)->spheres[i].c <= 0)
            return false;
    return true;
}

static void try_scene(const struct tia_scene *scene, unsigned width, unsigned height, int rows)
{
    static uint64_t memory[8192];
    struct tia_view *view;

    CHECK(tia_view_size(scene, 1) <= sizeof memory);
    if (tia_view_init(&view, memory, sizeof memory, scene, 1, width, height, NULL) || !is_outside(view))
        return;
    struct world w = {
        .scene = scene, .size = {(int)width, (int)height}, .depth = truth_depth(height, scene->camera.fov)};
    truth_place(scene, scene->lights[0].centre, w.q);
    for (int i = 0; i < rows; i++)
        try_row(view, &w, (int)(random_u32() % height));
}

static void check_seen(const char *what, double open)
{
    unsigned long all = seen[SPAN_LIT] + seen[SPAN_DARK] + seen[SPAN_OPEN];

    printf("# %s: %lu spans, %lu parts; %lu pixels lit, %lu dark, %lu open\n", what, spans_seen, parts_seen,
           seen[SPAN_LIT], seen[SPAN_DARK], seen[SPAN_OPEN]);
    CHECK(seen[SPAN_LIT] > all / 20 && seen[SPAN_DARK] > all / 100 && (double)seen[SPAN_OPEN] < open * (double)all);
    for (int i = 0; i < 3; i++)
        seen[i] = 0;
    spans_seen = parts_seen = 0;
}

/* One ball and one caster of any magnitude. */
TEST(parts_of_any_magnitude)
{
    static struct regime r;

    for (unsigned i = 0; i < check_count(4000); i++)
        if (regime_make(&r, i, false))
            try_scene(&r.scene, r.width, r.height, 3);
    check_seen("regimes", .8);
}

static tia_q16 around(double middle, double reach)
{
    return (tia_q16)((middle + reach * random_double()) * 65536);
}

/* A ground and balls on it or above it, which shade it and each other. */
TEST(parts_of_a_ground)
{
    static const struct tia_material grey = {.colour = TIA_RGB(.5, .5, .5)};
    static struct tia_sphere balls[BALLS];
    struct tia_light light = {.emission = TIA_RGB(1, 1, 1)};
    struct tia_scene scene = {.materials = &grey,
                              .spheres = balls,
                              .lights = &light,
                              .material_count = 1,
                              .sphere_count = BALLS,
                              .light_count = 1};

    random_state = 5;
    for (unsigned i = 0; i < check_count(400); i++) {
        balls[0] = (struct tia_sphere){{0, TIA_Q16(-1002), TIA_Q16(-20)}, TIA_Q16(1000), 0};
        for (int n = 1; n < BALLS; n++)
            balls[n] = (struct tia_sphere){{around(0, 6), around(0, 2), around(-18, 8)}, around(1, .9), 0};
        light.centre = (struct tia_vec3){around(0, 20), around(6, 5), around(-15, 15)};
        scene.camera.fov = TIA_Q16(30) + (tia_q16)(random_u32() % (60u << 16));
        try_scene(&scene, 320, 240, 6);
    }
    check_seen("grounds", .05);
}

int main(void)
{
    RUN(parts_of_any_magnitude);
    RUN(parts_of_a_ground);
    return check_status();
}

#else
int main(void)
{
    printf("skip span_parts: no numbers of 113 bits on this machine\n");
    return 0;
}
#endif
