/* light.c - from hits to pixels: a row is taken in chunks, a chunk in runs of one object, and a
 * run goes through the kernels, light by light and shadow by shadow. */
#include "hits.h"
#include "kernels.h"
#include "rgb565.h"
#include "shadow.h"
#include "shape/sphere.h"

/* Up to CHUNK pixels of a row on their way to the display. */
struct chunk {
    const struct tia_view *view;
    int x, y, count;
    const num_u *t;
    const uint32_t *object;
    uint32_t *reached;  /* NULL, or the sets of lights */
    tia_rgb565 *pixels; /* side by side */
};

/* A run of one sphere's pixels in a chunk, and the colour it has so far. */
struct shading {
    const struct chunk *chunk;
    const struct tia_material *material;
    uint32_t object;
    int first, count;
    bool grey; /* red stands for all three */
    num_u sum[3][CHUNK];
};

/* The exponent e_p of t^2 v.v = |P|^2, which is at most c on the tangent, or (2r)^2 from inside: it
 * keeps |P|^2 below 2^60, and t v.v = |P| |v|, where |v| < 2^(30 - f), a mantissa below 2^31 with the
 * exponent e_p - e_t. */
static int reach_exponent(const struct tia_view *view, const struct body *body)
{
    int bits = body->c < 0 ? num_bits(body->radius * body->radius) + 2 : num_bits(body->c);
    int by_mantissa = body->t_exponent + 31 - ((bits - 31) >> 1) - 30 + view->exponent;

    return 92 - bits < by_mantissa ? 92 - bits : by_mantissa;
}

/* The exponent e_d of |Q - P|^2 = Q.Q - 2 t Q.v + |P|^2: each term stays below 2^61, t Q.v as a product
 * of t (31 bits) and Q.v (29 bits). It is even, for the root. */
static int distance_exponent(const struct tia_view *view, const struct body *body, struct num_vec light, int e_p)
{
    int by_product = body->t_exponent + view->exponent - 16 + 61 - num_bits(view_reach(view, light));
    int by_light = 92 - num_bits(num_dot(light, light)), e = by_light < by_product ? by_light : by_product;

    return (e < e_p ? e : e_p) & ~1;
}

/* The exponent e_s of t G.v keeps it below 2^61, a product of t (31 bits) and G.v (30 bits), like the
 * constant beside it. r N.w/|w| is at most r, so r N.w 2^(e_s + half) times
 * 2^(15 - bits - e_s + e_d/2) is at most |w| 2^(e_d/2 + half - 1) < 2^31, with 16 of the radius's
 * bits behind the point. */
static void prepare_light(const struct tia_view *view, struct shadow_source *source, int x, int y,
                          struct light_line *line)
{
    const struct body *body = source->body;
    struct num_vec g = num_vec_sub(source->light, body->centre);
    num_wide facing = body->c - num_dot(body->centre, source->light), square = num_dot(source->light, source->light);
    int to_top = body->t_exponent + view->exponent - 16, limit = 93 - num_bits(facing);
    int e_s = to_top + 62 - num_bits(view_reach(view, g));

    e_s = e_s < limit ? e_s : limit;
    source->reach_exponent = reach_exponent(view, body);
    source->exponent = distance_exponent(view, body, source->light, source->reach_exponent);
    struct row_form form = view_row_form(view, g, x, y, e_s - to_top);
    line->g = form.start;
    line->g_step = form.step;
    form = view_row_form(view, source->light, x, y, source->exponent - to_top);
    line->q = form.start;
    line->q_step = form.step;
    line->square = view_row_square(view, x, y);
    line->facing = num_shift(facing, e_s - 32);
    line->distance = num_shift(square, source->exponent - 32);
    line->distance_down = num_count(source->reach_exponent - source->exponent);
    line->reach_down =
        num_count(2 * body->t_exponent + 2 * view->exponent + view->square_shift - 32 - source->reach_exponent);
    line->scale = 15 - body->radius_bits - e_s + (source->exponent >> 1);
}

/* What half-transparent spheres leave of a light on its way to each pixel of a run. */
struct tint {
    num_u left[3][CHUNK];
    uint16_t passed[CHUNK]; /* the sum of index + 1 of the spheres on the way */
};

/* Where `lit` is dark and was not before, the light passes `sphere`, which lets `through` pass:
 * tints it, and gives it back unless nothing is left. */
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

/* The pixels' light states, as tia_options has them. */
static void note_reached(const struct lit *lit, const struct tint *tint, uint32_t l, int count, uint32_t *reached)
{
    for (int i = 0; i < count; i++)
        if (lit->facing[i] > 0) {
            uint32_t way = tint ? tint->passed[i] * (l + 1) & 0xffff : 0;
            way = ((reached[i] >> 16) + way) & 0xffff;
            reached[i] = way << 16 | (reached[i] & 0xffff) | UINT32_C(1) << l;
        }
}

static void cast_shadows(const struct shading *s, const struct shadow_source *source, struct lit *lit,
                         struct tint *tint)
{
    const struct chunk *chunk = s->chunk;
    const struct tia_scene *scene = chunk->view->scene;

    for (uint32_t j = 0; j < scene->sphere_count; j++) {
        const struct tia_rgb *through = &scene->materials[scene->spheres[j].material].transmission;
        struct shadow_line line;
        num_u before[CHUNK];

        if (j == s->object ||
            !shadow_line_prepare(chunk->view, source, &chunk->view->bodies[j], chunk->x + s->first, chunk->y, &line))
            continue;
        line.count = s->count;
        for (int i = 0; !rgb565_is_black(through) && i < s->count; i++)
            before[i] = lit->facing[i];
        kernel_shadow(&line, chunk->t + s->first, lit);
        if (!rgb565_is_black(through))
            tint_light(through, j, before, lit, s->count, tint);
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
        for (int i = 0; tint && i < s->count; i++)
            tinted[i] = num_colour_product(lambert[i], tint->left[c][i]);
        kernel_add(s->sum[c], tint ? tinted : lambert, product[c], s->count);
    }
}

/* The light that arrives, the same with `tint` for what half-transparent spheres take from it. */
static void shade_light(struct shading *s, uint32_t l, struct tint *tint)
{
    const struct chunk *chunk = s->chunk;
    const struct tia_view *view = chunk->view;
    struct shadow_source source = {.body = &view->bodies[s->object],
                                   .light = num_vec_between(view->scene->camera.eye, view->lights[l].centre)};
    struct light_line line;
    struct lit lit;
    num_u lambert[CHUNK];

    prepare_light(view, &source, chunk->x + s->first, chunk->y, &line);
    line.count = s->count;
    if (!kernel_light(&line, chunk->t + s->first, &lit))
        return;
    cast_shadows(s, &source, &lit, tint);
    if (chunk->reached && l < 16)
        note_reached(&lit, tint, l, s->count, chunk->reached + s->first);
    kernel_lambert(&lit, source.body->inverse, s->count, lambert);
    add_light(s, &view->lights[l], lambert, tint);
}

static void shade_tinted_light(struct shading *s, uint32_t l)
{
    struct tint tint;

    for (int i = 0; i < s->count; i++) {
        tint.left[0][i] = tint.left[1][i] = tint.left[2][i] = NUM_ONE;
        tint.passed[i] = 0;
    }
    shade_light(s, l, &tint);
}

static void shade_run(struct chunk *chunk, int first, int count, const num_u threshold[8])
{
    const struct tia_view *view = chunk->view;
    const struct tia_scene *scene = view->scene;
    struct shading s; /* not zeroed: the sums are large */

    s.chunk = chunk;
    s.object = chunk->object[first];
    s.first = first;
    s.count = count;
    s.material = &scene->materials[scene->spheres[s.object].material];
    s.grey = view->grey && rgb565_is_grey(&s.material->colour) && rgb565_is_grey(&s.material->emission);
    for (int i = 0; i < count; i++) {
        s.sum[0][i] = num_colour(s.material->emission.r);
        s.sum[1][i] = num_colour(s.material->emission.g);
        s.sum[2][i] = num_colour(s.material->emission.b);
    }
    for (uint32_t l = 0; l < view->light_count; l++) {
        if (view->tinted)
            shade_tinted_light(&s, l);
        else
            shade_light(&s, l, NULL);
    }
    kernel_pack(s.sum[0], s.sum[s.grey ? 0 : 1], s.sum[s.grey ? 0 : 2], threshold, chunk->x + first, count,
                chunk->pixels + first);
}

/* A run that sees the background or a light: one colour, but for the dithering. */
static void flat_run(struct chunk *chunk, int first, int count, const struct tia_rgb *colour, const num_u threshold[8])
{
    num_u rgb[3][8];
    tia_rgb565 pixels[8];

    for (int i = 0; i < 8; i++) {
        rgb[0][i] = num_clamp(num_colour(colour->r));
        rgb[1][i] = num_clamp(num_colour(colour->g));
        rgb[2][i] = num_clamp(num_colour(colour->b));
    }
    kernel_pack(rgb[0], rgb[1], rgb[2], threshold, chunk->x + first, 8, pixels);
    if (threshold[0] == threshold[1]) { /* not dithered: all eight are the same */
        for (int i = 0; i < count; i++)
            chunk->pixels[first + i] = pixels[0];
        return;
    }
    for (int i = 0; i < count; i++)
        chunk->pixels[first + i] = pixels[i & 7];
}

/* Marks the pixels of a chunk where light `n` is nearer than what they see. */
static void see_light(const struct chunk *chunk, uint32_t n, num_u *nearest, uint32_t *object)
{
    const struct tia_view *view = chunk->view;
    const struct body *body = &view->bodies[n];
    struct run run = {chunk->x, chunk->x + chunk->count};
    num_u t[CHUNK];

    run = run_within(sphere_run(view, body, chunk->y, run), chunk->x, chunk->x + chunk->count);
    if (run.first >= run.end)
        return;
    sphere_distances(view, body, chunk->y, run.first, run.end - run.first, t);
    for (int i = run.first; i < run.end; i++) {
        num_u distance = t[i - run.first];
        uint32_t *seen = &object[i - chunk->x];
        if (*seen == TIA_NO_OBJECT ||
            num_nearer(distance, body->t_exponent, nearest[i - chunk->x], view->bodies[*seen].t_exponent)) {
            nearest[i - chunk->x] = distance;
            *seen = n;
        }
    }
}

/* Lights are not in the hits, since they move. Where the row may see one, the chunk gets its own
 * copy of the objects, with the lights among them. */
static void see_lights(struct chunk *chunk, uint32_t object[CHUNK])
{
    const struct tia_view *view = chunk->view;
    num_u nearest[CHUNK];
    bool copied = false;

    for (uint32_t n = view->scene->sphere_count; n < view->scene->sphere_count + view->light_count; n++) {
        if (chunk->y < view->bodies[n].rows.first || chunk->y >= view->bodies[n].rows.end)
            continue;
        for (int i = 0; !copied && i < chunk->count; i++) {
            object[i] = chunk->object[i];
            nearest[i] = chunk->t[i];
        }
        copied = true;
        see_light(chunk, n, nearest, object);
    }
    if (copied)
        chunk->object = object;
}

/* A run that sees light number n itself. */
static void light_run(struct chunk *chunk, int first, int count, uint32_t n, const num_u threshold[8])
{
    flat_run(chunk, first, count, &chunk->view->lights[n].emission, threshold);
    for (int i = first; chunk->reached && i < first + count; i++)
        chunk->reached[i] = UINT32_C(0xffff0000) | (n & 0xffff);
}

static void light_chunk(struct chunk *chunk, const num_u threshold[8])
{
    const struct tia_view *view = chunk->view;
    uint32_t copy[CHUNK];
    int end;

    see_lights(chunk, copy);
    for (int first = 0; first < chunk->count; first = end) {
        uint32_t object = chunk->object[first];
        for (end = first + 1; end < chunk->count && chunk->object[end] == object; end++)
            ;
        if (object == TIA_NO_OBJECT)
            flat_run(chunk, first, end - first, &view->scene->background, threshold);
        else if (object >= view->scene->sphere_count)
            light_run(chunk, first, end - first, object - view->scene->sphere_count, threshold);
        else
            shade_run(chunk, first, end - first, threshold);
    }
}

static void copy_pixels(const tia_rgb565 *pixels, int count, char *out, ptrdiff_t step)
{
    for (int i = 0; i < count; i++)
        *(tia_rgb565 *)(void *)(out + i * step) = pixels[i];
}

/* The chunk at column x of the tile: in the surface itself where its pixels are side by side. */
static void light_columns(struct chunk *chunk, const struct tia_hits *hits, struct tia_tile tile, unsigned x,
                          const struct tia_surface *surface, const num_u threshold[8])
{
    size_t at = hits_index(hits, tile.x + x, (unsigned)chunk->y);
    char *out = (char *)surface->pixels + (chunk->y - tile.y) * surface->pitch + (ptrdiff_t)x * surface->step;
    bool direct = surface->step == sizeof(tia_rgb565);
    tia_rgb565 pixels[CHUNK];

    chunk->x = tile.x + (int)x;
    chunk->count = tile.width - x < CHUNK ? (int)(tile.width - x) : CHUNK;
    chunk->t = hits->t + at;
    chunk->object = hits->object + at;
    chunk->pixels = direct ? (tia_rgb565 *)(void *)out : pixels;
    light_chunk(chunk, threshold);
    if (!direct)
        copy_pixels(pixels, chunk->count, out, surface->step);
}

static void light_row(struct chunk *chunk, const struct tia_hits *hits, struct tia_tile tile,
                      const struct tia_surface *surface, const struct tia_options *options)
{
    uint32_t *reached = options->reached ? options->reached + (size_t)(chunk->y - tile.y) * tile.width : NULL;
    num_u threshold[8];

    rgb565_thresholds(options->dither, chunk->y, threshold);
    for (unsigned x = 0; reached && x < tile.width; x++)
        reached[x] = 0;
    for (unsigned x = 0; x < tile.width; x += CHUNK) {
        chunk->reached = reached ? reached + x : NULL;
        light_columns(chunk, hits, tile, x, surface, threshold);
    }
}

int tia_light_tile(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile,
                   const struct tia_surface *surface, const struct tia_options *options)
{
    static const struct tia_options plain = {false, NULL};
    struct tia_tile area = hits->area;
    struct chunk chunk;

    if (!view_tile_inside(tile, 0, 0, (unsigned)view->width, (unsigned)view->height) ||
        !view_tile_inside(tile, area.x, area.y, area.width, area.height) || !surface->pixels)
        return TIA_ERR_ARGUMENT;
    chunk.view = view;
    for (int y = tile.y; y < tile.y + tile.height; y++) {
        chunk.y = y;
        light_row(&chunk, hits, tile, surface, options ? options : &plain);
    }
    return TIA_OK;
}
