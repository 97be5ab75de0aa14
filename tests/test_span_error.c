/* The bounds of span_error.h against 113 bits, at pixels of spans that span_shade.c shades: no error of the integers
 * exceeds its bound. */
#include "check.h"
#include "random.h"
#include "simd_truth.h"
#include "simd_used.h"
#include "span_regimes.h"

#include "render/span/span_error.c"
#include "render/span/span_shade.c"
#include "span_parts.h"

#if TRUTH_KNOWN
enum {
    DISTANCE,
    INSIDE,
    MANTISSA,
    SUM,
    TURN,
    QUOTIENT,
    ROUNDED,
    TURNED,
    UNITS,
    DIGITS,
    ROOTS,
    ALONG,
    ACROSS,
    POINT,
    REACH,
    SQUARE,
    SCALAR,
    MOVED,
    FACING,
    LAMBERT,
    BIAS,
    APART,
    TOWARD,
    POWER,
    BEYOND,
    WORDS,
    BOUNDS
};
static struct used bounds[BOUNDS] = {{"t", 0, 0},
                                     {"t from inside", 0, 0},
                                     {"the mantissa of t", 0, 0},
                                     {"S by rounding", 0, 0},
                                     {"S by K", 0, 0},
                                     {"c/S", 0, 0},
                                     {"t inside by rounding", 0, 0},
                                     {"t inside by K", 0, 0},
                                     {"S by units", 0, 0},
                                     {"v.v", 0, 0},
                                     {"sqrt(D) by rounding", 0, 0},
                                     {"b by K", 0, 0},
                                     {"P across", 0, 0},
                                     {"P", 0, 0},
                                     {"|P|^2 by rounding", 0, 0},
                                     {"|w|^2 by rounding", 0, 0},
                                     {"r N.w by rounding", 0, 0},
                                     {"|w|^2", 0, 0},
                                     {"r N.w", 0, 0},
                                     {"the cosine", 0, 0},
                                     {"bias N.w", 0, 0},
                                     {"the bias's part of k", 0, 0},
                                     {"A'.w", 0, 0},
                                     {"|A'|^2 - R^2", 0, 0},
                                     {"|w|^2 - A'.w", 0, 0},
                                     {"the cosine by words", 0, 0}};

/* A pixel of a span: the integers' values, and the exact ones. */
struct seen {
    const struct span_shading *s;
    const struct light_source *source;
    const struct lit *lit;
    struct truth truth;
    struct truth_way way;
    int i;
    num t;
};

#define OF(row) bound_of(SPAN_LOG(SPAN_ERROR_##row))

/* Tries the roundings of b with the root, of the root, which D's cause, and of v.v, in last bits; then b and P by K
 * - K0. */
static void try_roundings(const struct span_shading *s, const struct span_sphere *sphere, const struct truth *o,
                          const struct parts *p, int i)
{
    const struct primary_rays *primary = &s->spans->primary;
    struct row_square v = primary_square(primary, s->span->x + i, s->span->y);
    num_wide b = along(s->spans, sphere, s->span->x + i, s->span->y), square = num_top(v.start);
    num_wide top = num_top(num_shift(b, sphere->b_shift) + NUM_HALF);
    quad d = (quad)top * top + (quad)sphere->c_disc * square * (sphere->c < 0 ? 1 : -1), root = quad_root(d);
    bool inside = sphere->c < 0;

    if (d < (quad)0x1p40 || top < 0)
        return;
    use(&bounds[UNITS], (real)(top + num_sqrt((num_uwide)d) - (p->b * p->unit + root)),
        inside ? OF(INSIDE_UNITS) * 0x1p-32L : OF(SUM));
    use(&bounds[ROOTS], (real)(root - p->root * p->unit),
        (inside ? OF(INSIDE_ROOT) * 0x1p-32L : OF(ROOT)) / (real)(p->root * p->unit));
    if (inside)
        use(&bounds[DIGITS], (real)(square - p->square * power(2 * primary->exponent + primary->square_shift - 32)),
            OF(INSIDE_SQUARE));
    if (primary->exact)
        return;
    use(&bounds[ALONG], (real)((o->b - p->b) * p->unit), p->z * (inside ? OF(INSIDE_SUM) * 0x1p-32L : OF(TURNED_SUM)));
    use(&bounds[ACROSS], (real)((o->v[2] + rounded_depth(s)) / quad_root(quad_dot(o->v, o->v))),
        OF(TURNED) / (real)primary->depth);
}

static void try_parts(const struct span_shading *s, const struct span_sphere *sphere, const struct truth *o, int i)
{
    const struct primary_rays *primary = &s->spans->primary;
    struct parts p = parts_of(s, sphere, o);
    struct span_depth at = depth_at(s, i);
    real root = at.root, sum = at.sum, depth = (real)primary->depth;

    try_roundings(s, sphere, o, &p, i);
    if (sphere->c >= 0) {
        use(&bounds[SUM], (real)(at.sum / (p.rounded * p.unit) - 1), OF(ROOT) / root / sum + OF(SUM) / sum);
        use(&bounds[QUOTIENT],
            (real)(at.t * power(-sphere->t_exponent) * at.sum / p.unit / (sphere->c * power(-32)) - 1),
            OF(INVERSE) + OF(ROUNDED) / at.t);
        if (!primary->exact)
            use(&bounds[TURN], (real)(p.sum / p.rounded - 1),
                OF(TURNED_ROOT) * p.across / root + OF(TURNED_SUM) * p.z / sum + OF(TURNED) / depth);
    } else if (o->b > 0) {
        real square = (real)(p.square * power(2 * primary->exponent + primary->square_shift - 32));
        real quotient = ldexpl(square, sphere->t_shift), least = (real)(p.root * p.unit);
        quad scale = power(sphere->t_exponent - 31);
        use(&bounds[ROUNDED], (real)(at.t * power(-31) - p.rounded / p.square * scale),
            OF(INSIDE_ROOT) / least / quotient + OF(INSIDE_UNITS) / quotient + OF(INSIDE_SQUARE) / square +
                OF(INVERSE));
        if (!primary->exact)
            use(&bounds[TURNED], (real)((o->t - p.rounded / p.square) * scale),
                OF(INSIDE_TURNED) * p.across / least / quotient + OF(INSIDE_SUM) * p.z / quotient + OF(TURNED) / depth);
    }
}

static void try_t(const struct span_shading *s, const struct span_sphere *sphere, const struct truth *o, int i)
{
    quad t = s->span->t[i] * power(-sphere->t_exponent);

    if (sphere->c < 0)
        use(&bounds[INSIDE], (real)((t - o->t) * power(sphere->t_exponent - 31)), bound_of(s->error.t));
    else
        use(&bounds[DISTANCE], (real)(t / o->t - 1), bound_of(s->error.t));
    use(&bounds[MANTISSA], s->span->t[i], bound_of(s->error.mantissa));
    quad d[3] = {(t - o->t) * o->v[0], (t - o->t) * o->v[1], -t * rounded_depth(s) - o->p[2]};
    quad size = sphere->c < 0 ? bound_of(s->error.point) : quad_root(quad_dot(o->p, o->p));
    use(&bounds[POINT], (real)(quad_root(quad_dot(d, d)) / size), bound_of(s->error.t));
}

/* Returns the exponent of r N.w in the line. */
static int facing_exponent(const struct light_source *source, const struct light_line *line)
{
    return 15 - source->sphere->radius_bits + (source->exponent >> 1) - line->scale;
}

/* Tries |P|^2, |w|^2 and r N.w at the point that the integers' t and K give. */
static void try_square(const struct seen *p, const struct light_line *line, num_wide v_square)
{
    const struct span_error *e = &p->s->error;
    quad t = p->t * power(-p->source->sphere->t_exponent), w[3];
    const quad v[3] = {p->truth.v[0], p->truth.v[1], -rounded_depth(p->s)};
    num_wide reach = light_reach(line, p->t, v_square), q = ahead(line->q, line->q_step, p->i);
    num_wide square = light_square(line, p->t, q, reach);

    for (int i = 0; i < 3; i++)
        w[i] = p->truth.p[i] + p->way.w[i] - t * v[i];
    use(&bounds[REACH], (real)(reach * power(-p->source->reach_exponent) - t * t * quad_dot(v, v)), bound_of(e->reach));
    const struct span_sphere *sphere = p->source->sphere;
    struct num_vec g = num_vec_sub(p->source->light, sphere->centre);
    quad turned = sphere->c - num_dot(sphere->centre, p->source->light); /* c - L.Q + G.P, from inside its opposite */
    quad facing = turned * power(-32) + t * (g.x * v[0] + g.y * v[1] + g.z * v[2]) / 65536;
    num_wide got = line->facing + num_mul(p->t, num_top(ahead(line->g, line->g_step, p->i)));
    use(&bounds[SCALAR], (real)(got - (sphere->c < 0 ? -facing : facing) * power(facing_exponent(p->source, line))),
        bound_of(SPAN_LOG(SPAN_ERROR_FACING) + e->mantissa));
    use(&bounds[SQUARE], (real)(square * power(-p->source->exponent) - quad_dot(w, w)), bound_of(e->square));
}

/* Tries the constant of |A'|^2 - R^2, which has the bias's terms. */
static void try_constant(const struct span_shading *s, const struct span_sphere *sphere,
                         const struct span_sphere *caster, const struct shadow_line *line, int e_k)
{
    bool inside = sphere->c < 0;
    quad r = sphere->radius * (quad)0x1p-16, other = caster->radius * (quad)0x1p-16;
    quad bias = inside ? -(quad)0x1p-13 : (quad)0x1p-13, apart = length_of(num_vec_sub(sphere->centre, caster->centre));
    quad exact = caster->c * power(-32) - (apart * apart - r * (r + bias) - other * other) * bias / (r + bias);
    quad size = length_of(sphere->centre) + length_of(caster->centre) + r + other + bound_of(s->error.point);
    quad most = bound_of(SPAN_LOG(SPAN_ERROR_APART)) * size * size / r + bound_of(SPAN_LOG(SPAN_ERROR_APART_UNITS));

    use(&bounds[APART], (real)(line->power - exact * power(e_k)), (real)(most * power(e_k) + 1));
}

static void try_caster(const struct seen *p, const struct shadow_line *line, const struct tia_sphere *sphere)
{
    const struct tia_scene *scene = p->s->view->scene;
    const struct lit *lit = p->lit;
    struct truth_caster exact;
    quad centre[3], r = p->source->sphere->radius * (quad)0x1p-16, bias = (quad)0x1p-13 / r;
    int e_d = p->source->exponent, e_a = 43 + (e_d >> 1) - line->bias_shift, e_k = 2 * e_a - e_d - line->exponent;

    truth_place(scene, sphere->centre, centre);
    truth_approach(&p->truth, &p->way, centre, (quad)sphere->radius / 65536, &exact);
    num_wide biased = shadow_bias(line, lit->facing[p->i], lit->half[p->i]);
    int w = sum_of(log_length(p->source->light), p->s->error.point);
    use(&bounds[BIAS], (real)(biased - p->way.cosine * quad_root(p->way.square) * (quad)0x1p-13 * power(e_a)),
        bound_of(SPAN_LOG(SPAN_ERROR_BIAS) + w + p->s->error.lambert + e_a * 256) + 1);
    num_wide a =
        shadow_toward(line, num_mul(p->t, num_top(ahead(line->a, line->a_step, p->i))), lit->reach[p->i]) - biased;
    num_wide k = shadow_power(line, num_mul(p->t, num_top(ahead(line->c, line->c_step, p->i))), lit->reach[p->i]);
    num_wide beyond = num_down(lit->square[p->i], line->square_down) - num_down(a, line->product_down);
    use(&bounds[TOWARD], (real)(a - exact.a * power(e_a)), (real)line->a_doubt);
    use(&bounds[POWER], (real)(k - exact.h * power(e_k) / (p->source->sphere->c < 0 ? 1 - bias : 1 + bias)),
        (real)line->k_doubt);
    use(&bounds[BEYOND], (real)(beyond - (p->way.square - exact.a) * power(e_a < e_d ? e_a : e_d)),
        (real)line->beyond_doubt);
}

/* Tries the casters of all pixels that face the light. */
static void try_casters(struct seen pixels[], const struct light_source *source, struct span_shading *s)
{
    const struct tia_scene *scene = s->view->scene;

    for (uint32_t j = 0; (j = span_next_caster(&s->lit, source->number, j)) < scene->sphere_count; j++) {
        const struct span_sphere *caster = &s->spans->spheres[j];
        struct shadow_line line;
        shadow_line_prepare(&s->spans->primary, source, caster, s->span->x, s->span->y, &line);
        if (caster->c < 0 || !span_error_shadow(source, caster, &s->error, &line))
            continue;
        int e_a = 43 + (source->exponent >> 1) - line.bias_shift;
        try_constant(s, source->sphere, caster, &line, 2 * e_a - source->exponent - line.exponent);
        for (int i = 0; i < s->span->count; i++)
            if (pixels[i].lit->facing[i] > 0)
                try_caster(&pixels[i], &line, &scene->spheres[j]);
    }
}

#include "span_words.h"

/* Tries a light as shade_from_light() adds it. */
static void try_light(struct span_shading *s, struct seen pixels[], uint32_t l)
{
    const struct tia_view *view = s->view;
    struct light_source source = {.sphere = &s->spans->spheres[s->span->object],
                                  .number = l,
                                  .light = num_vec_between(view->scene->camera.eye, view->lights[l].centre)};
    struct light_line line;
    struct lit lit;
    num_u lambert[CHUNK];
    quad q[3];

    light_line_prepare(&s->spans->primary, &source, s->span->x, s->span->y, &line);
    line.count = s->span->count;
    bound_light(s, &source, &line);
    if (!s->bounded)
        return;
    truth_place(view->scene, view->lights[l].centre, q);
    bool any = s->spans->kernels->light(&line, s->span->t, &lit);
    int e_s = facing_exponent(&source, &line);
    for (int i = 0; i < s->span->count; i++) {
        struct seen *p = &pixels[i];
        p->source = &source;
        p->lit = &lit;
        try_t(s, source.sphere, &p->truth, i);
        try_parts(s, source.sphere, &p->truth, i);
        truth_look(&p->truth, q, &p->way);
        try_square(p, &line, v_square_at(&line, i));
        num_wide facing = line.facing + num_mul(p->t, num_top(ahead(line.g, line.g_step, i)));
        quad exact = quad_dot(p->truth.n, p->way.w) * source.sphere->radius / 65536;
        use(&bounds[FACING], (real)(facing - exact * power(e_s)), (real)line.facing_doubt);
        CHECK(facing <= 0 || exact > 0 || facing <= line.facing_doubt);
    }
    try_words(s, pixels, &source, &line);
    bound_lambert(s, &source, lit.most_half);
    if (!any || !s->bounded)
        return;
    try_casters(pixels, &source, s);
    s->spans->kernels->lambert(&lit, source.sphere->inverse, s->span->count, lambert);
    for (int i = 0; i < s->span->count; i++)
        if (lit.facing[i] > 0) {
            struct seen *p = &pixels[i];
            use(&bounds[MOVED], (real)(lit.square[i] * power(-source.exponent) / p->way.square - 1),
                bound_of(s->error.relative));
            quad cosine = p->way.cosine > 0 ? p->way.cosine : 0;
            use(&bounds[LAMBERT], (real)(lambert[i] * (quad)0x1p-30 - cosine), bound_of(s->error.lambert));
        }
}

static void try_span(const struct tia_view *view, const struct shaded_span *span)
{
    static struct seen pixels[CHUNK];
    static struct span_shading s;
    const struct tia_scene *scene = view->scene;
    const struct tia_sphere *sphere = &scene->spheres[span->object];
    const int size[2] = {(int)view->width, (int)view->height};
    quad depth = truth_depth((unsigned)view->height, scene->camera.fov);

    s.span = span;
    s.view = view;
    s.spans = view->prepared;
    s.lit = (struct span_lit){.casters = &s.spans->casters, .object = span->object};
    s.open = 0;
    find_ends(&s, s.ends);
    span_error_points(&s.spans->primary, &s.spans->spheres[span->object], s.ends, num_bound(30), &s.error);
    for (int i = 0; i < span->count; i++) {
        pixels[i] = (struct seen){.s = &s, .i = i, .t = num_signed(span->t[i])};
        truth_meet(scene, size, depth, span->x + i, span->y, sphere->centre, sphere->radius, &pixels[i].truth);
    }
    for (uint32_t l = 0; l < view->light_count; l++)
        try_light(&s, pixels, l);
}

/* Tries a span of up to `most` pixels, at the begin, at the end or in the middle of a row's. */
static void try_row(const struct tia_view *view, uint32_t object, int y, int most)
{
    const struct span_view *spans = span_view_of(view);
    struct span all = span_sphere_row(view, object, y, (struct span){0, 0});
    num_u t[CHUNK];

    if (all.first >= all.end)
        return;
    int count = all.end - all.first < most ? all.end - all.first : most, room = all.end - all.first - count;
    int place = (int)(random_bits() % 3), first = all.first + (place == 0 ? 0 : place == 1 ? room : room / 2);
    struct shaded_span span = {object, first, y, count, t, NULL, NULL};
    struct span_shading probe = {.span = &span, .spans = spans};
    span_distances(spans, object, y, first, span.count, t);
    while (find_ends(&probe, probe.ends))
        span.count = (span.count + 1) / 2;
    try_span(view, &span);
}

static void try_scene(const struct tia_scene *scene, unsigned width, unsigned height, uint32_t objects)
{
    size_t size = tia_view_size(scene, scene->light_count);
    void *memory = malloc(size);
    struct tia_view *view;

    if (!tia_view_init(&view, memory, size, scene, scene->light_count, width, height, NULL))
        for (uint32_t n = 0; n < objects; n++) {
            struct span rows = span_view_of(view)->spheres[n].rows;
            for (int i = 0; i < 4 && rows.first < rows.end; i++) {
                int y = i == 0 ? rows.first : rows.first + (int)(random_bits() % (unsigned)(rows.end - rows.first));
                try_row(view, n, y, i & 1 ? CHUNK : 1 + (int)(random_bits() % 5));
            }
        }
    free(memory);
}

TEST(errors_are_within_their_bounds)
{
    static struct regime r;
    unsigned count = check_count(12000);

    for (unsigned i = 0; i < count; i++)
        if (regime_make(&r, i, true))
            try_scene(&r.scene, r.width, r.height, 1);
    for (unsigned i = 0; i < count / 8; i++)
        try_scene(close_light(), 64, 64, 1);
    check_used(bounds, BOUNDS);
}

/* Sums of logarithms, and those of lengths, are rounded up by no more than a tenth of a bit. */
TEST(logarithms_are_upper_limits)
{
    for (int apart = 0; apart < 8000; apart += 7) {
        double exact = 256 * log2(1 + exp2(-apart / 256.0));
        CHECK_MSG(sum_of(1000, 1000 - apart) >= 1000 + exact && sum_of(1000, 1000 - apart) < 1257 + exact / 2,
                  "apart by %d", apart);
        CHECK_EQ(sum_of(1000, 1000 - apart), sum_of(1000 - apart, 1000));
    }
    for (int i = 0; i < 20000; i++) {
        struct num_vec a = {(num_wide)random_short(31), -(num_wide)random_short(31), (num_wide)random_short(31)};
        double exact = 256 * log2(fmax((double)length_of(a), 0x1p-16));
        CHECK_MSG(log_length(a) >= exact && log_length(a) < exact + 400, "%d, not %g", log_length(a), exact);
    }
}

int main(void)
{
    RUN(logarithms_are_upper_limits);
    RUN(errors_are_within_their_bounds);
    return check_status();
}

#else
int main(void)
{
    printf("skip span_error: no numbers of 113 bits on this machine\n");
    return 0;
}
#endif
