/* span_rows.c - from hits to pixels: a row is divided into pieces, and a piece into spans of one object. */
#include "math/fast.h"

#include "math/noinline.h"
#include "render/core/dither.h"
#include "span.h"
#include "span_parts.h"
#include "span_shade.h"
#include "steps/steps.h"

#define PIECE 1024 /* most pixels of a row drawn at once; CHUNK if lights may be visible or pixels are copied */

/* Consecutive pixels of a row that are being drawn. */
struct chunk {
    const struct tia_view *view;
    const struct span_view *spans;
    int x, y, count;
    const num_u *t;
    const uint32_t *object;
    uint32_t *path_hash; /* path hashes of the row, or NULL */
    uint16_t *colours;   /* colours of the row, or NULL */
    bool lights;         /* the row may show lights */
    bool empty;          /* the row shows no sphere of the scene */
    tia_rgb565 *pixels;  /* contiguous pixels for output */
};

/* Draws a span of the background or of a light: one colour, except for dithering, which repeats after 8 pixels. */
static void flat_span(struct chunk *chunk, int first, int count, const struct tia_rgb *colour,
                      const num_u threshold[THRESHOLDS])
{
    const num_u rgb[3] = {num_clamp(num_colour(colour->r)), num_clamp(num_colour(colour->g)),
                          num_clamp(num_colour(colour->b))};
    const num_u *const colours[3] = {&rgb[0], &rgb[1], &rgb[2]};
    bool dithered = threshold[0] != threshold[1];
    tia_rgb565 pixels[8];

    for (int i = 0; i < (dithered ? 8 : 1); i++)
        pixels[i] = span_order(threshold, span_pixel(rgb, threshold[(chunk->x + first + i) & 7]));
    if (!dithered)
        span_fill(chunk->pixels + first, count, pixels[0]);
    for (int i = 0; dithered && i < count; i++)
        chunk->pixels[first + i] = pixels[i & 7];
    span_put_colours(colours, 0, count, chunk->colours ? chunk->colours + 3 * first : NULL);
}

/* Marks the pixels of a chunk where light `n` is nearer than their object. */
static void see_light(const struct chunk *chunk, uint32_t n, num_u *nearest, uint32_t *object)
{
    const struct span_view *spans = chunk->spans;
    struct span span = {chunk->x, chunk->x + chunk->count};
    num_u t[CHUNK];

    span = span_within(span_sphere_row(chunk->view, n, chunk->y, span), chunk->x, chunk->x + chunk->count);
    if (span.first >= span.end)
        return;
    span_distances(spans, n, chunk->y, span.first, span.end - span.first, t);
    span_keep_nearer(chunk->view, n, chunk->y, span.first, t, span.end - span.first, nearest + (span.first - chunk->x),
                     object + (span.first - chunk->x));
}

static bool row_sees(const struct chunk *chunk, uint32_t sphere)
{
    struct span rows = chunk->spans->spheres[sphere].rows;

    return chunk->y >= rows.first && chunk->y < rows.end;
}

/* True if the row may show one of the balls first..end-1. */
static bool row_sees_some(const struct chunk *chunk, uint32_t first, uint32_t end)
{
    for (uint32_t n = first; n < end; n++)
        if (row_sees(chunk, n))
            return true;
    return false;
}

/* Gives the distances of pixels first..end-1, which show one object. */
static void distances_of(const struct chunk *chunk, int first, int end, num_u *t)
{
    uint32_t object = chunk->object[first];

    if (object != TIA_NO_OBJECT && chunk->spans->spheres[object].steps)
        span_distances(chunk->spans, object, chunk->y, chunk->x + first, end - first, t);
    else
        for (int i = first; i < end; i++)
            t[i - first] = chunk->t[i];
}

/* Adds the visible lights to the chunk's objects. Hits do not include lights, as lights can move. So `object` receives
 * a copy of the chunk's objects, replaced by lights where these are nearer. */
static NOINLINE void see_lights(struct chunk *chunk, uint32_t object[CHUNK])
{
    const struct tia_view *view = chunk->view;
    num_u nearest[CHUNK];
    int end;

    for (int first = 0; first < chunk->count; first = end) {
        end = first + span_same(chunk->object + first, chunk->count - first);
        distances_of(chunk, first, end, nearest + first);
        for (int i = first; i < end; i++)
            object[i] = chunk->object[first];
    }
    for (uint32_t n = view->scene->sphere_count; n < view->scene->sphere_count + view->light_count; n++)
        if (row_sees(chunk, n) && !view_stops(view))
            see_light(chunk, n, nearest, object);
    chunk->object = object;
}

/* Draws a span that shows light number n. */
static void light_span(struct chunk *chunk, int first, int count, uint32_t n, const num_u threshold[THRESHOLDS])
{
    flat_span(chunk, first, count, &chunk->view->lights[n].emission, threshold);
    for (int i = first; chunk->path_hash && i < first + count; i++)
        chunk->path_hash[i] = UINT32_C(0xffff0000) | (n & 0xffff);
}

/* Shades a span pixel by pixel. If hits do not store the distances, computes the distances first. */
static NOINLINE void shade_pixels(const struct chunk *chunk, uint32_t object, int first, int end,
                                  const num_u threshold[THRESHOLDS])
{
    num_u t[CHUNK];

    for (int count; first < end && !view_stops(chunk->view); first += count) {
        struct shaded_span span = {object, chunk->x + first, chunk->y, 0, chunk->t + first, NULL, NULL};
        count = end - first < CHUNK ? end - first : CHUNK;
        span.count = count;
        if (chunk->spans->spheres[object].steps) {
            span_distances(chunk->spans, object, chunk->y, span.x, count, t);
            span.t = t;
        }
        span.path_hash = chunk->path_hash ? chunk->path_hash + first : NULL;
        span.colours = chunk->colours ? chunk->colours + 3 * first : NULL;
        shade_span(chunk->view, &span, threshold, chunk->pixels + first);
    }
}

static const struct colour_steps *steps_of(const struct chunk *chunk, uint32_t object)
{
    return steps_number(chunk->spans->steps, chunk->spans->spheres[object].steps);
}

/* Draws a span of a sphere by the steps of its colour. */
static NOINLINE void draw_steps(const struct chunk *chunk, uint32_t object, int first, int end,
                                const num_u threshold[THRESHOLDS])
{
    struct step_row row;

    steps_begin(&chunk->spans->primary, &chunk->spans->spheres[object], steps_of(chunk, object), chunk->x + first,
                chunk->y, end - first, &row);
    if (TIA_SWAP)
        row.swap = span_swaps(threshold);
    for (int at; (at = first + row.at) < end;) {
        uint64_t open = steps_draw(&row, chunk->pixels + at);
        for (int i = 0; open; i++, open >>= 1)
            if (open & 1)
                shade_pixels(chunk, object, at + i, at + i + 1, threshold);
    }
}

static void draw_part(const struct chunk *chunk, uint32_t object, enum span_part part, int first, int end,
                      const num_u threshold[THRESHOLDS])
{
    if (part == SPAN_LIT)
        draw_steps(chunk, object, first, end, threshold);
    else if (part == SPAN_DARK)
        span_fill(chunk->pixels + first, end - first, span_order(threshold, steps_of(chunk, object)->pixel[0]));
    else
        shade_pixels(chunk, object, first, end, threshold);
}

/* Draws a span of a sphere part by part. */
static NOINLINE void draw_parts(const struct chunk *chunk, uint32_t object, int first, int end,
                                const num_u threshold[THRESHOLDS])
{
    struct span_run runs[SPAN_RUNS];

    for (int from = first; first < end; from = first) {
        int count = span_divide(chunk->view, object, chunk->x + first, chunk->y, end - first, runs);
        for (int i = 0; i < count; i++) {
            draw_part(chunk, object, runs[i].part, first, from + runs[i].end, threshold);
            first = from + runs[i].end;
        }
    }
}

static void shade_sphere(const struct chunk *chunk, int first, int end, const num_u threshold[THRESHOLDS])
{
    uint32_t object = chunk->object[first];
    const struct colour_steps *steps = steps_of(chunk, object);

    if (steps && steps->usable && threshold[0] == threshold[1] && !chunk->path_hash && !chunk->colours &&
        !chunk->lights)
        (steps->shaded ? draw_parts : draw_steps)(chunk, object, first, end, threshold);
    else
        shade_pixels(chunk, object, first, end, threshold);
}

static void light_chunk(struct chunk *chunk, const num_u threshold[THRESHOLDS])
{
    const struct tia_view *view = chunk->view;
    int end;

    for (int first = 0; first < chunk->count; first = end) {
        uint32_t object = chunk->object[first];
        end = chunk->empty ? chunk->count : first + span_same(chunk->object + first, chunk->count - first);
        if (object == TIA_NO_OBJECT)
            flat_span(chunk, first, end - first, &view->scene->background, threshold);
        else if (object >= view->scene->sphere_count)
            light_span(chunk, first, end - first, object - view->scene->sphere_count, threshold);
        else
            shade_sphere(chunk, first, end, threshold);
    }
}

/* Draws a chunk where the row may show lights. */
static NOINLINE void light_chunk_with_lights(struct chunk *chunk, const num_u threshold[THRESHOLDS])
{
    uint32_t object[CHUNK];

    see_lights(chunk, object);
    chunk->empty = false;
    light_chunk(chunk, threshold);
}

static void copy_pixels(const tia_rgb565 *pixels, int count, char *out, ptrdiff_t step)
{
    for (int i = 0; i < count; i++)
        *(tia_rgb565 *)(void *)(out + i * step) = pixels[i];
}

/* Draws the chunk at column x of the tile, directly into the surface if the surface's pixels are contiguous. Returns
 * the number of pixels drawn. */
static int light_columns(struct chunk *chunk, const struct tia_hits *hits, struct tia_tile tile, unsigned x,
                         const struct tia_surface *surface, const num_u threshold[THRESHOLDS])
{
    size_t at = hits_index(hits, tile.x + x, (unsigned)chunk->y);
    char *out = (char *)surface->pixels + (chunk->y - (int)tile.y) * surface->pitch + (ptrdiff_t)x * surface->step;
    bool direct = surface->step == sizeof(tia_rgb565);
    unsigned most = direct && !chunk->lights ? PIECE : CHUNK;
    tia_rgb565 pixels[CHUNK];

    chunk->x = (int)(tile.x + x);
    chunk->count = (int)(tile.width - x < most ? tile.width - x : most);
    chunk->t = span_distances_of(hits) + at;
    chunk->object = hits->object + at;
    chunk->pixels = direct ? (tia_rgb565 *)(void *)out : pixels;
    if (chunk->lights)
        light_chunk_with_lights(chunk, threshold);
    else
        light_chunk(chunk, threshold);
    if (!direct)
        copy_pixels(pixels, chunk->count, out, surface->step);
    return chunk->count;
}

static void light_row(struct chunk *chunk, const struct tia_hits *hits, struct tia_tile tile,
                      const struct tia_surface *surface, const struct tia_options *options)
{
    size_t before = (size_t)(chunk->y - (int)tile.y) * tile.width;
    uint32_t *path_hash = options_debug(options).path_hash;
    num_u threshold[THRESHOLDS];

    path_hash = path_hash ? path_hash + before : NULL;
    dither_thresholds(options->dither, chunk->y, threshold);
    span_set_order(threshold, surface_swaps(surface));
    for (unsigned x = 0; path_hash && x < tile.width; x++)
        path_hash[x] = 0;
    for (unsigned x = 0; x < tile.width;) {
        chunk->path_hash = path_hash ? path_hash + x : NULL;
        chunk->colours = options->colours ? options->colours + 3 * (before + x) : NULL;
        x += (unsigned)light_columns(chunk, hits, tile, x, surface, threshold);
    }
}

void span_light(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile,
                const struct tia_surface *surface, const struct tia_options *options)
{
    const uint32_t spheres = view->scene->sphere_count;
    struct chunk chunk;

    chunk.view = view;
    chunk.spans = view->prepared;
    for (int y = (int)tile.y; y < tile_bottom(tile) && !view_stops(view); y++) {
        chunk.y = y;
        chunk.lights = row_sees_some(&chunk, spheres, spheres + view->light_count);
        chunk.empty = !row_sees_some(&chunk, 0, spheres);
        light_row(&chunk, hits, tile, surface, options);
    }
}
