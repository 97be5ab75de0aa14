#include "span_shade.h"

#include "math/noinline.h"
#include "scene/colour.h"
#include "span_shading.h"

#define WORTH 4 /* least number of pixels for which words pay */

#define SPAN_LAMBERT_MOST (-9 * 256) /* the largest error of a cosine with which pixels are decided */

/* Leaves all pixels open. */
static NOINLINE void give_up(struct span_shading *s)
{
    s->open = PIXELS_ALL;
    s->given_up = !s->span->path_hash && !s->span->colours;
}

/* The part of a light that half-transparent spheres transmit to each pixel of a span. */
struct tint {
    num_u left[3][CHUNK];
    num_u before[CHUNK];    /* `facing` before the last caster */
    uint16_t passed[CHUNK]; /* sum of (index + 1) of the spheres on the way */
};

/* Where `sphere` has just darkened `lit`, multiplies the tint by `through`, the sphere's transmission, and restores
 * `lit` unless no light is left. */
static void tint_light(const struct tia_rgb *through, uint32_t sphere, struct lit *lit, int count, struct tint *tint)
{
    const num_u colour[3] = {num_colour(through->r), num_colour(through->g), num_colour(through->b)};

    for (int i = 0; i < count; i++) {
        bool lit_still = false;
        if (tint->before[i] == lit->facing[i])
            continue;
        for (int c = 0; c < 3; c++) {
            tint->left[c][i] = num_colour_product(tint->left[c][i], colour[c]);
            lit_still = lit_still || tint->left[c][i] > 0;
        }
        tint->passed[i] = (uint16_t)((tint->passed[i] + sphere + 1) & 0xffff);
        if (lit_still)
            lit->facing[i] = tint->before[i];
    }
}

/* Adds light l to the path hash of each pixel that it reaches, see tia/debug.h. */
static void note_reached(const struct lit *lit, const struct tint *tint, uint32_t l, int count, uint32_t *path_hash)
{
    for (int i = 0; i < count; i++)
        if (lit->facing[i] > 0) {
            uint32_t way = tint ? tint->passed[i] * (l + 1) & 0xffff : 0;
            way = ((path_hash[i] >> 16) + way) & 0xffff;
            path_hash[i] = way << 16 | (path_hash[i] & 0xffff) | UINT32_C(1) << l;
        }
}

/* Lets sphere j, around the eye, block the light: of all pixels, unless the light is inside too. */
static bool blocks_all(const struct light_source *source, const struct span_sphere *caster)
{
    struct num_vec d = span_difference(&caster->centre, &source->light);

    return !span_is_within(&d, caster->radius);
}

static void darken(struct lit *lit, int count)
{
    for (int i = 0; i < count; i++)
        lit->facing[i] = 0;
}

/* Sets facing to 0 where sphere j blocks the light, in a part of the span; false if it blocks it nowhere. */
static bool cast_shadow(struct span_shading *s, const struct light_source *source, uint32_t j, struct span reach,
                        struct lit *lit)
{
    const struct shaded_span *span = s->span;
    const struct span_sphere *caster = &s->spans->spheres[j];
    struct shadow_line line;

    if (caster->c < 0) {
        bool all = blocks_all(source, caster);
        darken(lit, all ? span->count : 0);
        return all;
    }
    shadow_line_prepare(&s->spans->primary, source, caster, span->x, span->y, &line);
    line.first = reach.first;
    line.count = reach.end;
    if (s->bounded && !span_error_shadow(source, caster, &s->error, &line))
        give_up(s);
    s->spans->kernels->shadow(&line, span->t, lit);
    return true;
}

/* Casts the shadows of spheres that may block the light in a part of the span: of those near it, unless NULL. */
static NOINLINE void cast_shadows(struct span_shading *s, const struct light_source *source, const uint8_t *near,
                                  struct span reach, struct lit *lit, struct tint *tint)
{
    const struct shaded_span *span = s->span;
    const struct tia_scene *scene = s->view->scene;
    const struct span_casters *casters = &s->spans->casters;

    for (uint32_t j = 0;
         (j = near ? span_next_in(casters, near, j) : span_next_caster(&s->lit, source->number, j)) < casters->count &&
         !s->given_up && !span_work_stops(s->view, &s->work);
         j++) {
        const struct tia_rgb *through = &scene->materials[scene->spheres[j].material].transmission;
        bool passes = tint && !colour_is_black(through);

        for (int i = 0; passes && i < span->count; i++)
            tint->before[i] = lit->facing[i];
        if (cast_shadow(s, source, j, reach, lit) && passes)
            tint_light(through, j, lit, span->count, tint);
    }
}

static num_u greatest(const num_u x[3])
{
    num_u larger = x[0] > x[1] ? x[0] : x[1];

    return larger > x[2] ? larger : x[2];
}

/* Adds a light whose cosines are off by up to `doubt`, and by a binary logarithm, `log`. */
NOINLINE void span_add_light(struct span_shading *s, const struct tia_light *light, const num_u *lambert,
                             struct tint *tint, int log, num_u doubt)
{
    const struct tia_rgb *colour = &s->material->colour, *emission = &light->emission;
    num_u product[3] = {num_colour_product(num_colour(colour->r), num_colour(emission->r)),
                        num_colour_product(num_colour(colour->g), num_colour(emission->g)),
                        num_colour_product(num_colour(colour->b), num_colour(emission->b))};

    if (s->bounded)
        s->doubt += num_light_doubt(greatest(product), log, tint ? s->view->scene->sphere_count : 0);
    if (s->bounded && doubt > 0)
        s->doubt += num_colour_product(greatest(product), doubt) + 1;
    if (s->words && s->spans->coherence->add(s, lambert, light, product))
        return;
    for (int c = 0; c < (s->grey ? 1 : 3); c++) {
        num_u tinted[CHUNK];
        for (int i = 0; tint && i < s->span->count; i++)
            tinted[i] = num_colour_product(lambert[i], tint->left[c][i]);
        s->spans->kernels->add(s->sum[c], tint ? tinted : lambert, product[c], s->span->count);
    }
}

/* Bounds the errors of a light's line, if possible; otherwise all pixels are open. */
static void bound_light(struct span_shading *s, const struct light_source *source, struct light_line *line)
{
    span_error_of(source, line, &s->error);
    line->facing_doubt = span_error_facing(source, line, &s->error);
    s->bounded = s->error.t < 0;
    if (!s->bounded)
        give_up(s);
}

/* Bounds the cosine's error, if possible; otherwise all pixels are open. */
static void bound_lambert(struct span_shading *s, const struct light_source *source, int most_half)
{
    span_error_lambert(source, num_least_normal(most_half), &s->error);
    s->bounded = s->bounded && s->error.lambert <= SPAN_LAMBERT_MOST;
    if (!s->bounded)
        give_up(s);
}

/* Casts the shadows of a light: of spheres that may block it, if there are few such. */
static void find_casters(struct span_shading *s, const struct light_source *source, struct lit *lit, struct tint *tint)
{
    struct span all = {0, s->span->count};
    bool few = s->bounded && s->spans->coherence && s->view->scene->sphere_count > 2;

    if (!few)
        cast_shadows(s, source, NULL, all, lit, tint);
    else if (s->spans->coherence->shadows(s->spans, s->span, source->number, &s->shadows))
        cast_shadows(s, source, s->shadows.near, s->shadows.reach, lit, tint);
}

/* Adds the light that arrives from one light by the kernels. */
NOINLINE void span_shade_by_kernels(struct span_shading *s, const struct light_source *source,
                                    const struct light_line *line, struct tint *tint)
{
    const struct shaded_span *span = s->span;
    struct lit lit;
    num_u *lambert = lit.facing; /* in the same memory, as stack is scarce */

    bool any = s->spans->kernels->light(line, span->t, &lit);
    s->open |= lit.open;
    if (!any)
        return;
    if (NUM_CERTIFIED)
        bound_lambert(s, source, lit.most_half);
    find_casters(s, source, &lit, tint);
    s->open |= lit.open;
    if (span->path_hash && source->number < 16)
        note_reached(&lit, tint, source->number, span->count, span->path_hash);
    s->spans->kernels->lambert(&lit, source->sphere->inverse, span->count, lambert);
    span_add_light(s, &s->view->lights[source->number], lambert, tint, s->error.lambert, 0);
}

bool span_prepare_light(struct span_shading *s, uint32_t l, struct light_source *source, struct light_line *line)
{
    const struct shaded_span *span = s->span;

    source->sphere = &s->spans->spheres[span->object];
    source->number = l;
    source->light = num_vec_between(s->view->scene->camera.eye, s->view->lights[l].centre);
    light_line_prepare(&s->spans->primary, source, span->x, span->y, line);
    line->count = span->count;
    s->bounded = false;
    if (NUM_CERTIFIED)
        bound_light(s, source, line);
    return !s->given_up;
}

/* Adds the light that arrives from one light, tinted by half-transparent spheres unless `tint` is NULL. */
static void shade_from_light(struct span_shading *s, uint32_t l, struct tint *tint)
{
    struct light_source source;
    struct light_line line;

    if (span_prepare_light(s, l, &source, &line))
        span_shade_by_kernels(s, &source, &line, tint);
}

static NOINLINE void shade_from_tinted_light(struct span_shading *s, uint32_t l)
{
    struct tint tint;

    for (int i = 0; i < s->span->count; i++) {
        tint.left[0][i] = tint.left[1][i] = tint.left[2][i] = NUM_ONE;
        tint.passed[i] = 0;
    }
    shade_from_light(s, l, &tint);
}

void span_put_colours(const num_u *const rgb[3], int step, int count, uint16_t *colours)
{
    for (int i = 0; colours && i < count; i++)
        for (int c = 0; c < 3; c++)
            *colours++ = (uint16_t)num_quantise(rgb[c][i * step], 65535, NUM_ROUND);
}

/* Decides the pixels of a set whose channels are near a level, one by one: a channel is at least the emission, which is
 * exact, and often is exactly a level. Returns those that remain. */
static pixel_set decide_levels(const struct span_shading *s, pixel_set near, const num_u *threshold, tia_rgb565 *pixels)
{
    const struct tia_rgb *emission = &s->material->emission;
    const num_u least[3] = {num_colour(emission->r), num_colour(emission->g), num_colour(emission->b)};

    for (int i = 0; i < s->span->count; i++) {
        num_u low[3], high[3], half = threshold[(s->span->x + i) & 7];
        pixel_set bit = PIXEL_BIT(i);
        if (!(near & bit))
            continue;
        for (int c = 0; c < 3; c++) {
            num_u sum = s->sum[s->grey ? 0 : c][i];
            low[c] = sum > least[c] + s->doubt ? sum - s->doubt : least[c];
            high[c] = sum + s->doubt;
        }
        tia_rgb565 pixel = span_pixel(low, half);
        pixels[i] = span_order(threshold, pixel);
        if (pixel == span_pixel(high, half))
            near &= ~bit;
    }
    return near;
}

/* Gives the depths of the first and the last pixel. True if D = b^2 - c v.v, which is convex unless c > L.x^2, falls at
 * the first and rises at the last. */
static bool find_ends(const struct span_shading *s, struct span_depth ends[2])
{
    const struct shaded_span *span = s->span;
    const struct primary_rays *primary = &s->spans->primary;
    const struct span_sphere *sphere = &s->spans->spheres[span->object];
    num_wide y = primary_y(primary, span->y), z = primary->depth, row = num_square(y) + num_square(z);
    num_wide base = sphere->centre.y * y - sphere->centre.z * z;
    bool inside = sphere->c < 0; /* then the bounds are for all of the image */
    bool convex = sphere->c > 0 && sphere->c <= sphere->centre.x * sphere->centre.x, rises[2] = {true, false};

    for (int i = 0; i < 2; i++) {
        int at = i ? span->count - 1 : 0;
        num_wide x = num_pixel_coordinate(2 * (span->x + at) + 1 - primary->width, primary->exponent);
        num_wide b = num_max(sphere->centre.x * x + base, 0), square = inside ? num_square(z) : num_square(x) + row;
        if (convex)
            rises[i] = span_product_above(sphere->centre.x, b, sphere->c, x);
        ends[i] =
            span_depth_of(sphere, inside ? 0 : num_top_u(span_shift(b, sphere->b_shift) + NUM_HALF),
                          num_top_u(num_up(square, primary->square_shift) + (inside ? 0 : NUM_HALF)), span->t[at]);
    }
    return !rises[0] && rises[1];
}

/* Sets the sums to the emission, in eights of pixels, as pack() reads them. */
static void begin_sums(struct span_shading *s)
{
    const struct tia_rgb *emission = &s->material->emission, black = {0, 0, 0};

    emission = s->uncoloured ? &black : emission;
    const num_u colour[3] = {num_colour(emission->r), num_colour(emission->g), num_colour(emission->b)};

    int count = (s->span->count + 7) & ~7;

    for (int c = 0; c < (s->grey || s->uncoloured ? 1 : 3); c++)
        for (int i = 0; i < count; i += 4)
            s->sum[c][i] = s->sum[c][i + 1] = s->sum[c][i + 2] = s->sum[c][i + 3] = colour[c];
}

/* True if words.h may compute the span. A ball with steps is left to them under one light: what they leave is at the
 * edge of a shadow, where words do not pay. */
static bool is_worded(const struct span_shading *s)
{
    const struct shaded_span *span = s->span;
    const struct span_sphere *sphere = &s->spans->spheres[span->object];

    return s->spans->coherence && !s->spans->tinted && !span->path_hash && !span->colours && sphere->c > 0 &&
           (s->view->light_count > 1 || !sphere->steps);
}

/* Shades a span, and returns the set of its pixels that are in doubt. Shortens it where D would be least in its
 * middle. */
static NOINLINE pixel_set shade(const struct tia_view *view, struct shaded_span *span,
                                const num_u threshold[THRESHOLDS], tia_rgb565 *pixels)
{
    const struct tia_scene *scene = view->scene;
    struct span_shading s; /* not zeroed, since the sums are large */

    s.span = span;
    s.view = view;
    s.spans = view->prepared;
    s.lit.casters = &s.spans->casters;
    s.lit.object = span->object;
    s.lit.surrounded = false;
    s.material = &scene->materials[scene->spheres[span->object].material];
    s.grey = s.spans->grey && colour_is_grey(&s.material->colour) && colour_is_grey(&s.material->emission);
    s.open = 0;
    s.given_up = false;
    s.work = 0;
    s.doubt = 0;
    while (NUM_CERTIFIED && find_ends(&s, s.ends))
        span->count = (span->count + 1) / 2;
    if (NUM_CERTIFIED)
        span_error_points(&s.spans->primary, &s.spans->spheres[span->object], s.ends, num_bound(30), &s.error);
    s.shadows.tried = s.shadows.divided = false;
    s.words = NUM_CERTIFIED && span->count >= WORTH && is_worded(&s);
    s.uncoloured = s.words && s.spans->dim;
    s.shadows.doubt = s.words ? span_error_coarse(&s.error) : 0;
    begin_sums(&s);
    if (s.words)
        s.spans->coherence->lights(&s);
    for (uint32_t l = 0; !s.words && l < view->light_count && !s.given_up && !span_work_stops(view, &s.work); l++)
        if (s.spans->tinted)
            shade_from_tinted_light(&s, l);
        else
            shade_from_light(&s, l, NULL);
    const num_u *const rgb[3] = {s.sum[0], s.sum[s.grey ? 0 : 1], s.sum[s.grey ? 0 : 2]};
    if (NUM_CERTIFIED && s.doubt > NUM_DOUBT_MOST) {
        give_up(&s);
        s.doubt = 0;
    }
    pixel_set near = s.spans->kernels->pack(rgb, s.doubt, threshold, span->x, span->count, pixels) & ~s.open;
    if (NUM_CERTIFIED && near)
        s.open |= decide_levels(&s, near, threshold, pixels);
    span_put_colours(rgb, 1, span->count, span->colours);
    return s.open;
}

/* Decides one pixel, which is in doubt as a part of a longer span. */
static NOINLINE void settle(const struct tia_view *view, const struct shaded_span *span, int i,
                            const num_u threshold[THRESHOLDS], tia_rgb565 *pixel)
{
    struct shaded_span one = {span->object,
                              span->x + i,
                              span->y,
                              1,
                              span->t + i,
                              span->path_hash ? span->path_hash + i : NULL,
                              span->colours ? span->colours + 3 * i : NULL};

    if (one.path_hash)
        *one.path_hash = 0;
    if (span->count > 1 && !shade(view, &one, threshold, pixel))
        return;
    *pixel = span_order(threshold, span_shade_exactly(view, &one, threshold[one.x & 7]));
}

void shade_span(const struct tia_view *view, const struct shaded_span *span, const num_u threshold[THRESHOLDS],
                tia_rgb565 *pixels)
{
    struct shaded_span part = *span;

    for (int first = 0; first < span->count && !view_stops(view); first += part.count) {
        part.x = span->x + first;
        part.t = span->t + first;
        part.path_hash = span->path_hash ? span->path_hash + first : NULL;
        part.colours = span->colours ? span->colours + 3 * first : NULL;
        part.count = span->count - first;
        pixel_set open = shade(view, &part, threshold, pixels + first);
        for (int i = 0; NUM_CERTIFIED && open && i < part.count; i++)
            if (open >> i & 1 && !view_stops(view))
                settle(view, &part, i, threshold, pixels + first + i);
    }
}
