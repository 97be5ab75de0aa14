#include "span_shade.h"

#include "scene/colour.h"
#include "span_shadow.h"

/* A span being shaded. */
struct shading {
    const struct shaded_span *span;
    const struct tia_view *view;
    const struct span_view *spans;
    const struct tia_material *material;
    bool grey; /* red serves as all three channels */
    num_u sum[3][CHUNK];
};

/* The part of a light that half-transparent spheres transmit to each pixel of a span. */
struct tint {
    num_u left[3][CHUNK];
    uint16_t passed[CHUNK]; /* sum of (index + 1) of the spheres on the way */
};

/* Where `sphere` has just darkened `lit`, multiplies the tint by `through`, the sphere's transmission, and restores
 * `lit` from `before` unless no light is left. */
static void tint_light(const struct tia_rgb *through, uint32_t sphere, const num_u *before, struct lit *lit, int count,
                       struct tint *tint)
{
    for (int i = 0; i < count; i++) {
        if (before[i] == lit->facing[i])
            continue;
        tint->left[0][i] = num_colour_product(tint->left[0][i], num_colour(through->r));
        tint->left[1][i] = num_colour_product(tint->left[1][i], num_colour(through->g));
        tint->left[2][i] = num_colour_product(tint->left[2][i], num_colour(through->b));
        tint->passed[i] = (uint16_t)((tint->passed[i] + sphere + 1) & 0xffff);
        if (tint->left[0][i] > 0 || tint->left[1][i] > 0 || tint->left[2][i] > 0)
            lit->facing[i] = before[i];
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

static void cast_shadows(const struct shading *s, const struct light_source *source, struct lit *lit, struct tint *tint)
{
    const struct shaded_span *span = s->span;
    const struct tia_scene *scene = s->view->scene;

    for (uint32_t j = 0; j < scene->sphere_count; j++) {
        const struct tia_rgb *through = &scene->materials[scene->spheres[j].material].transmission;
        struct shadow_line line;
        num_u before[CHUNK];

        if (j == span->object ||
            !shadow_line_prepare(&s->spans->primary, source, &s->spans->spheres[j], span->x, span->y, &line))
            continue;
        line.count = span->count;
        for (int i = 0; !colour_is_black(through) && i < span->count; i++)
            before[i] = lit->facing[i];
        s->spans->kernels->shadow(&line, span->t, lit);
        if (!colour_is_black(through))
            tint_light(through, j, before, lit, span->count, tint);
    }
}

static void add_light(struct shading *s, const struct tia_light *light, const num_u *lambert, struct tint *tint)
{
    const struct tia_rgb *colour = &s->material->colour, *emission = &light->emission;
    num_u product[3] = {num_colour_product(num_colour(colour->r), num_colour(emission->r)),
                        num_colour_product(num_colour(colour->g), num_colour(emission->g)),
                        num_colour_product(num_colour(colour->b), num_colour(emission->b))};

    for (int c = 0; c < (s->grey ? 1 : 3); c++) {
        num_u tinted[CHUNK];
        for (int i = 0; tint && i < s->span->count; i++)
            tinted[i] = num_colour_product(lambert[i], tint->left[c][i]);
        s->spans->kernels->add(s->sum[c], tint ? tinted : lambert, product[c], s->span->count);
    }
}

/* Adds the light that arrives from one light, tinted by half-transparent spheres unless `tint` is NULL. */
static void shade_from_light(struct shading *s, uint32_t l, struct tint *tint)
{
    const struct shaded_span *span = s->span;
    const struct tia_view *view = s->view;
    struct light_source source = {.sphere = &s->spans->spheres[span->object],
                                  .light = num_vec_between(view->scene->camera.eye, view->lights[l].centre)};
    struct light_line line;
    struct lit lit;
    num_u *lambert = lit.facing; /* shares memory with `facing`, as the stack may be small */

    light_line_prepare(&s->spans->primary, &source, span->x, span->y, &line);
    line.count = span->count;
    if (!s->spans->kernels->light(&line, span->t, &lit))
        return;
    cast_shadows(s, &source, &lit, tint);
    if (span->path_hash && l < 16)
        note_reached(&lit, tint, l, span->count, span->path_hash);
    s->spans->kernels->lambert(&lit, source.sphere->inverse, span->count, lambert);
    add_light(s, &view->lights[l], lambert, tint);
}

static void shade_from_tinted_light(struct shading *s, uint32_t l)
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

void shade_span(const struct tia_view *view, const struct shaded_span *span, const num_u threshold[8],
                tia_rgb565 *pixels)
{
    const struct tia_scene *scene = view->scene;
    struct shading s; /* not zeroed, since the sums are large */

    s.span = span;
    s.view = view;
    s.spans = view->prepared;
    s.material = &scene->materials[scene->spheres[span->object].material];
    s.grey = s.spans->grey && colour_is_grey(&s.material->colour) && colour_is_grey(&s.material->emission);
    for (int i = 0; i < span->count; i++) {
        s.sum[0][i] = num_colour(s.material->emission.r);
        s.sum[1][i] = num_colour(s.material->emission.g);
        s.sum[2][i] = num_colour(s.material->emission.b);
    }
    for (uint32_t l = 0; l < view->light_count; l++) {
        if ((l & 63) == 63 && view_stops(view)) /* a row with many lights may take a while */
            break;
        if (s.spans->tinted)
            shade_from_tinted_light(&s, l);
        else
            shade_from_light(&s, l, NULL);
    }
    const num_u *const rgb[3] = {s.sum[0], s.sum[s.grey ? 0 : 1], s.sum[s.grey ? 0 : 2]};
    s.spans->kernels->pack(rgb[0], rgb[1], rgb[2], threshold, span->x, span->count, pixels);
    span_put_colours(rgb, 1, span->count, span->colours);
}
