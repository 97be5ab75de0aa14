#include "prepare.h"

#include <math.h>

#include "bound_table.h"
#include "render/core/dither.h"
#include "scene/colour.h"

static void cast_forms(const struct simd_fine *fine, const struct simd_fine_light *light,
                       const struct simd_caster *from, struct simd_fine_cast *cast)
{
    const struct span_view *spans = span_view_of(fine->view);
    double centre[2];

    tia_simd_form(&spans->primary, fine->row, &fine->place, spans->spheres[from->sphere].centre, centre);
    cast->a[0] = from->aq;
    cast->k[0] = from->p0;
    for (int i = 0; i < 2; i++) {
        cast->a[i + 1] = light->q[i] / 2 - centre[i] - light->lamp->swell * light->g[i];
        cast->k[i + 1] = -2 * centre[i];
    }
}

void tia_simd_fine_light(struct simd_fine *fine, const struct simd_lamp *lamp)
{
    const struct span_view *spans = span_view_of(fine->view);

    if (simd_is_black(lamp->colour))
        return;
    struct simd_fine_light *light = &fine->light[fine->lights++];
    light->lamp = lamp;
    light->first = fine->casts;
    fine->casts += lamp->casts;
    tia_simd_form(&spans->primary, fine->row, &fine->place, lamp->g, light->g);
    tia_simd_form(&spans->primary, fine->row, &fine->place, lamp->light, light->q);
    light->q[0] *= -2;
    light->q[1] *= -2;
    for (int j = 0; j < lamp->casts; j++)
        cast_forms(fine, light, &lamp->cast[j], &fine->cast[light->first + j]);
}

bool tia_simd_fine_place(const struct tia_view *view, const struct simd_row *row, uint32_t sphere, int first, int end,
                         struct simd_fine *fine)
{
    const struct span_view *spans = span_view_of(view);
    const struct tia_material *material = &view->scene->materials[view->scene->spheres[sphere].material];

    fine->view = view;
    fine->row = row;
    fine->sphere = sphere;
    fine->first = first;
    fine->end = end;
    fine->lights = fine->casts = 0;
    tia_simd_place(&spans->primary, row, first, end, &fine->place);
    fine->grey = spans->grey && colour_is_grey(&material->colour) && colour_is_grey(&material->emission);
    simd_channels(&material->emission, fine->emission);
    return tia_simd_see(&spans->primary, row, &fine->place, simd_sphere_of(fine), &fine->seen);
}

bool tia_simd_fine(const struct tia_view *view, const struct simd_row *row, uint32_t sphere,
                   const struct simd_lamp *lamps, int first, int end, struct simd_fine *fine)
{
    bool good = tia_simd_fine_place(view, row, sphere, first, end, fine);

    for (uint32_t l = 0; good && l < view->light_count; l++)
        tia_simd_fine_light(fine, &lamps[l]);
    return good;
}

/* ---- for the kernels ---- */

/* Converts coefficients of a form in s to those of the form in S = c s. */
static void scaled(const double from[3], double per_c, float *square, float *start, float *step)
{
    *square = (float)(from[0] * per_c * per_c);
    *start = (float)(from[1] * per_c);
    *step = (float)(from[2] * per_c);
}

/* A factor with which |w|^2 is above every A'.w: |A'| is below 2^18, and |w| is above 2^-40 where |w|^2 is known. */
#define ENDLESS 1e20f

/* Gives a caster's transmission, which is not black. */
static void run_through(const struct simd_fine *fine, const struct simd_caster *from, struct simd_cast *cast)
{
    const struct tia_scene *scene = fine->view->scene;
    double through[3];

    simd_channels(&scene->materials[scene->spheres[from->sphere].material].transmission, through);
    for (int c = 0; c < 3; c++)
        cast->through[c] = (float)through[c];
}

static void run_cast(const struct simd_fine *fine, const struct simd_fine_light *light, int j, double per_c,
                     struct simd_cast *cast)
{
    const struct simd_lamp *lamp = light->lamp;
    const struct simd_caster *from = &lamp->cast[j];
    const struct simd_fine_cast *fine_cast = &fine->cast[light->first + j];
    const struct simd_cast_bounds *b = &fine_cast->bounds;
    double size = from->size + fine->depth.p_most + BOUND(SPAN_EDGE_BIAS);
    double sizes = 1 + BOUND(SPAN_EDGE_SIZES);

    scaled(fine_cast->a, per_c, &cast->aq, &cast->h0, &cast->h1);
    scaled(fine_cast->k, per_c, &cast->p0, &cast->c0, &cast->c1);
    cast->swell = (float)(1 + lamp->swell);
    cast->ends = from->encloses ? ENDLESS : 1;
    cast->ea = (float)(b->a * per_c * per_c * (1 + BOUND(SPAN_VERDICT_A)));
    cast->ek = (float)(b->k * per_c * per_c * (1 + BOUND(SPAN_RUN_K)));
    cast->ew = (float)(b->w * (1 + BOUND(SPAN_VERDICT_W)));
    cast->clear = from->clear;
    if (from->clear)
        run_through(fine, from, cast);
    cast->radius = (float)(from->radius * sizes);
    cast->turn = (float)((from->apart + SIMD_BIAS) * sizes);
    cast->shift = (float)(SIMD_BIAS * lamp->per_r * sizes);
    cast->size = (float)(size * sizes);
    cast->fuzz_a = (float)BOUND_OF(SPAN_EDGE_A, (2 + BOUND(SPAN_EDGE_A_SECOND)) * size * b->a);
    cast->fuzz_k = (float)BOUND_OF(SPAN_EDGE_K, (b->k + size * size * b->w) * (1 + BOUND(SPAN_EDGE_K_SECOND)));
}

/* Gives a light's constants, with those of its casters in `cast`. */
static void run_light(const struct simd_fine *fine, const struct simd_fine_light *from, struct simd_cast *cast,
                      struct simd_light *light)
{
    const struct simd_lamp *lamp = from->lamp;
    double per_c = 1 / fine->seen.c;

    light->k = (float)(lamp->k * per_c);
    light->g0 = (float)from->g[0];
    light->g1 = (float)from->g[1];
    scaled((const double[3]){lamp->qq, from->q[0], from->q[1]}, per_c, &light->qq, &light->q0, &light->q1);
    light->per_r = (float)lamp->per_r;
    light->colour_most = 0;
    for (int c = 0; c < 3; c++) {
        light->colour[c] = (float)lamp->colour[c];
        light->colour_most = light->colour[c] > light->colour_most ? light->colour[c] : light->colour_most;
    }
    light->faint = (float)from->bounds.lambert;
    light->casts = lamp->casts;
    light->cast = cast;
    for (int j = 0; j < lamp->casts; j++)
        run_cast(fine, from, j, per_c, &cast[j]);
}

void tia_simd_dither(bool on, int y, struct simd_dither *dither)
{
    dither_thresholds(on, y, dither->threshold);
    span_set_order(dither->threshold, false);
    for (int i = 0; i < SIMD_MORE; i++)
        dither->half[i] = (float)((double)dither->threshold[i & 7] * 0x1p-30 - .5);
}

/* True if a channel without light is on a boundary between two levels, or too near one for floats. */
static bool is_tied(double emission, double levels, double threshold, double near)
{
    double y = emission * levels + threshold, rest = y - (int)y;

    return fabs(rest - .5) > near;
}

/* Sets the pixel without light, exactly, if one of its channels is tied. */
static void run_unlit(const struct simd_fine *fine, const struct simd_dither *dither, struct simd_run *run)
{
    const struct tia_scene *scene = fine->view->scene;
    const struct tia_rgb *own = &scene->materials[scene->spheres[fine->sphere].material].emission;
    num_u t = dither->threshold[0];
    double threshold = (double)t * 0x1p-30;

    run->tied = is_tied(fine->emission[0], 31, threshold, fine->near31) ||
                is_tied(fine->emission[1], 63, threshold, fine->near63) ||
                (!fine->grey && is_tied(fine->emission[2], 31, threshold, fine->near31));
    if (!run->tied)
        return;
    unsigned r = num_quantise(num_clamp(num_colour(own->r)), 31, t),
             g = num_quantise(num_clamp(num_colour(own->g)), 63, t),
             b = num_quantise(num_clamp(num_colour(own->b)), 31, t);
    run->unlit = (uint16_t)(r << 11 | g << 5 | b);
}

void tia_simd_run_place(const struct simd_fine *fine, const struct simd_dither *dither, struct simd_run *run)
{
    const struct simd_seen *seen = &fine->seen;
    const struct simd_place *place = &fine->place;
    const double *d = seen->d;
    double wider = 1 + BOUND(SPAN_CELL_WIDER) + BOUND_OF(SPAN_CELL_WIDER_S, 4 * fine->depth.es);

    run->count = fine->end - fine->first;
    run->grey = fine->grey;
    run->x0 = (float)place->low;
    run->b0 = (float)seen->b[0];
    run->b1 = (float)seen->b[1];
    run->d0 = (float)d[0];
    run->d1 = (float)d[1];
    run->d2 = (float)d[2];
    run->cut = (float)fine->depth.cut;
    run->c = (float)seen->c;
    run->v0 = (float)place->v0;
    run->v1 = (float)place->v1;
    run->v2 = (float)place->v2;
    run->v_step = (float)(place->v_step * wider);
    run->v_most = (float)(place->v_most * wider);
    run->bend = (float)(fabs(4 * d[0] * d[2] - d[1] * d[1]) / 4 * (1 + BOUND(SPAN_CELL_CURVE)));
    run->d_sag = (float)(BOUND_OF(SPAN_CELL_SAG, d[2] > 0 ? d[2] * SIMD_CELL * SIMD_CELL / 4 : 0) +
                         seen->size * BOUND(SPAN_CELL_SAG_ROUNDING));
    run->b_off = (float)(fabs(seen->b[1]) * BOUND(SPAN_CELL_TURN));
    run->d_off = (float)((fabs(d[1]) + 2 * fabs(d[2]) * place->reach) * BOUND(SPAN_CELL_SLOPE) * SIMD_FLOAT);
    for (int c = 0; c < 3; c++)
        run->emission[c] = (float)fine->emission[c];
    run->threshold = dither->half + (fine->first & 7);
}

void tia_simd_run_lights(const struct simd_fine *fine, struct simd_run *run)
{
    run->lights = fine->lights;
    for (int l = 0; l < run->lights; l++)
        run_light(fine, &fine->light[l], &run->cast[fine->light[l].first], &run->light[l]);
}

void tia_simd_run_levels(const struct simd_fine *fine, const struct simd_dither *dither, struct simd_run *run)
{
    run->near31 = (float)fine->near31;
    run->near63 = (float)fine->near63;
    run_unlit(fine, dither, run);
}

void tia_simd_run(const struct simd_fine *fine, const struct simd_dither *dither, struct simd_run *run)
{
    tia_simd_run_place(fine, dither, run);
    tia_simd_run_lights(fine, run);
    tia_simd_run_levels(fine, dither, run);
}
