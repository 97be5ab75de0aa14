/* light.c - draws a tile by vector units: divides it into rows, and rows into runs of one object, and chooses a method
 * for each run. */
#include "bound_cache.h"
#include "crowd.h"
#include "exact.h"
#include "render/span/span_shade.h"
#include "seen.h"
#include "simd/simd.h"

/* True if the span kernels draw the view. Views with the eye inside a sphere are left to plain C. */
bool tia_simd_draws(const struct tia_view *view)
{
    const struct span_view *spans = span_view_of(view);

    for (uint32_t n = 0; n < view->scene->sphere_count; n++)
        if (spans->spheres[n].radius > 0 && spans->spheres[n].c <= 0)
            return false;
    return true;
}

/* ---- rows ---- */

/* Pixels of a sphere with many casters that are drawn at once: at most, and at least if their casters are still too
 * many. */
#define PIECE 64
#define PIECE_LEAST 8

/* Pixels of the background, or of a light that is seen directly; without dithering all are the same. */
struct flat {
    tia_rgb565 pixels[8];
    uint32_t object;
    bool known, dithered; /* dithered: the pixels are valid for one span only */
};

/* A picture with more pixels than this (8 MB) is drawn into a buffer of one row, which is then streamed past the
 * caches. Ordinary stores into the picture would first read each cache line. Streaming takes four fifths of the time at
 * 3840x2160, the same time at 2560x1440, and more for smaller pictures. */
#define STREAMED (4u << 20)

/* Data that one row leaves for the next, and data of a row that may be too large for a thread's stack. */
struct carried {
    bool streams;
    struct span guess[SIMD_GUESSES];
    struct simd_line line;
    tia_rgb565 pixels[SIMD_STRIP];
    struct simd_fine fine;
    struct simd_run run;
    struct simd_crowd crowd;
    uint16_t list[SIMD_RUN + SIMD_MORE];
    struct flat flat;
    struct simd_dither dither;
    struct simd_bound_cache caches[SIMD_CACHES];
};

static void find_flat(const struct tia_rgb *colour, int first, const num_u threshold[THRESHOLDS], struct flat *flat)
{
    const num_u rgb[3] = {num_colour(colour->r), num_colour(colour->g), num_colour(colour->b)};

    for (int i = 0; i < 8; i++)
        flat->pixels[i] = span_pixel(rgb, threshold[(first + i) & 7]);
}

static void light_flat(const struct tia_view *view, const struct simd_span *span, struct carried *carried,
                       tia_rgb565 *out)
{
    const num_u *threshold = carried->dither.threshold;
    struct flat *flat = &carried->flat;
    const struct tia_scene *scene = view->scene;
    bool light = span->object != TIA_NO_OBJECT;
    int count = span->end - span->first;

    if (!flat->known || flat->dithered || flat->object != span->object) {
        find_flat(light ? &view->lights[span->object - scene->sphere_count].emission : &scene->background, span->first,
                  threshold, flat);
        flat->known = true;
        flat->dithered = threshold[0] != threshold[1];
        flat->object = span->object;
    }
    if (!flat->dithered)
        view->simd->kernels->fill(out, count, flat->pixels[0]);
    else
        for (int i = 0; i < count; i++)
            out[i] = flat->pixels[i & 7];
}

static size_t room(const struct tia_simd *simd)
{
    return simd_room(sizeof(struct carried), simd->kernels->cells);
}

/* Draws pixels first..end-1 in plain C, which finds few casters for each chunk. */
static void light_plainly(const struct tia_view *view, int y, uint32_t sphere, int first, int end,
                          const num_u threshold[THRESHOLDS], tia_rgb565 *out)
{
    num_u t[CHUNK];

    for (int x = first; x < end; x += CHUNK) {
        const struct shaded_span span = {sphere, x, y, end - x < CHUNK ? end - x : CHUNK, t, NULL, NULL};
        span_distances(span_view_of(view), sphere, y, x, span.count, t);
        shade_span(view, &span, threshold, out + (x - first));
    }
}

/* Draws pixels first..end-1 by the kernels, with the casters of the given lamps, which are the sphere's own or those of
 * the crowd, for these pixels alone. */
static void light_part(const struct tia_view *view, const struct simd_row *row, uint32_t sphere,
                       const struct simd_lamp *lamps, int first, int end, struct carried *carried, tia_rgb565 *out)
{
    const struct simd_pixels pixels = {view, row, sphere, lamps, first, carried->dither.threshold, out};
    struct simd_fine *fine = &carried->fine;

    if (!tia_simd_fine(view, row, sphere, lamps, first, end, fine) ||
        !tia_simd_fine_bounds(fine, lamps == carried->crowd.lamp ? NULL : simd_cache_of(carried->caches, fine))) {
        tia_simd_decide(&pixels, NULL, end - first);
        return;
    }
    tia_simd_run(fine, &carried->dither, &carried->run);
    int count =
        view->simd->kernels->shade(&carried->run, out, carried->list, simd_kernels_room(carried, sizeof *carried));
    tia_simd_decide(&pixels, carried->list, count);
}

/* Draws pixels first..end-1 of a sphere with many casters in pieces, which have few. */
static void light_pieces(const struct tia_view *view, const struct simd_row *row, int first, int end,
                         struct carried *carried, tia_rgb565 *out)
{
    struct simd_crowd *crowd = &carried->crowd;
    uint32_t sphere = crowd->span.object;

    for (int x = first, next, most = PIECE; x < end; x = next) {
        next = end - x < most ? end : x + most;
        bool fits = tia_simd_crowd_lamps(view, crowd, x, next);
        if (!fits && next - x > PIECE_LEAST) {
            most = (next - x) / 2;
            next = x;
            continue;
        }
        if (fits)
            light_part(view, row, sphere, crowd->lamp, x, next, carried, out + (x - first));
        else
            light_plainly(view, row->y, sphere, x, next, carried->dither.threshold, out + (x - first));
        most = 2 * most < PIECE ? 2 * most : PIECE;
    }
}

static void light_span(const struct tia_view *view, const struct simd_row *row, const struct simd_span *span,
                       struct carried *carried, tia_rgb565 *out)
{
    if (span->object >= view->scene->sphere_count) { /* a light or TIA_NO_OBJECT */
        light_flat(view, span, carried, out);
        return;
    }
    if (view->light_count > SIMD_LIGHTS) {
        light_plainly(view, row->y, span->object, span->first, span->end, carried->dither.threshold, out);
        return;
    }
    bool crowded = tia_simd_is_crowded(view, span->object);
    int most = crowded ? SIMD_CROWD : SIMD_RUN;
    for (int x = span->first, end; x < span->end; x = end) {
        end = span->end - x < most ? span->end : x + most;
        if (crowded) {
            tia_simd_crowd(view, span->object, row->y, x, end, &carried->crowd);
            light_pieces(view, row, x, end, carried, out + (x - span->first));
        } else {
            light_part(view, row, span->object, simd_lamp_of(view, span->object, 0), x, end, carried,
                       out + (x - span->first));
        }
    }
}

static void copy(const tia_rgb565 *pixels, unsigned count, char *out, const struct tia_surface *surface)
{
    for (unsigned i = 0; i < count; i++)
        *(tia_rgb565 *)(void *)(out + (ptrdiff_t)i * surface->step) = surface_order(surface, pixels[i]);
}

static void light_row(const struct tia_view *view, const struct simd_row *row, struct tia_tile tile,
                      const struct tia_surface *surface, struct carried *carried)
{
    const struct simd_line *line = &carried->line;
    char *out = (char *)surface->pixels + (row->y - (int)tile.y) * surface->pitch;
    bool compact = surface->step == sizeof(tia_rgb565) && !surface_swaps(surface),
         direct = compact && !carried->streams;
    tia_rgb565 *pixels = carried->pixels, *place = direct ? (tia_rgb565 *)(void *)out : pixels;

    for (int i = 0; i < line->count; i++) {
        const struct simd_span *span = &line->spans[line->which][i];
        light_span(view, row, span, carried, place + (span->first - (int)tile.x));
    }
    if (compact && !direct)
        view->simd->kernels->stream((void *)out, pixels, (int)tile.width);
    else if (!direct)
        copy(pixels, tile.width, out, surface);
}

#define ROWS 8 /* rows between two calls of `stop`, which takes a lock that threads share */

static void light_strip(const struct tia_view *view, struct tia_tile tile, const struct tia_surface *surface,
                        bool dither, bool streams, struct carried *carried)
{
    const struct span_view *spans = span_view_of(view);
    struct simd_row row;

    tia_simd_row(spans, (int)tile.y, &row);
    carried->streams = streams;
    carried->flat.known = false;
    for (int i = 0; i < SIMD_GUESSES; i++)
        carried->guess[i] = (struct span){0, 0};
    for (int i = 0; i < SIMD_CACHES; i++)
        carried->caches[i].known = false;
    for (int y = (int)tile.y; y < tile_bottom(tile) && !(y % ROWS == 0 && view_stops(view)); y++) {
        if (dither || y == (int)tile.y)
            tia_simd_dither(dither, y, &carried->dither);
        simd_row_to(&spans->primary, y, &row);
        tia_simd_find(view, &row, tile, carried->guess, &carried->line);
        light_row(view, &row, tile, surface, carried);
    }
}

void tia_simd_light(const struct tia_view *view, struct tia_tile tile, const struct tia_surface *surface,
                    const struct tia_options *options, void *carried)
{
    const struct simd_kernels *kernels = view->simd->kernels;
    struct tia_surface part = *surface;
    bool streams = kernels->stream && (uint32_t)view->width * (uint32_t)view->height > STREAMED;

    if (options_debug(options).path_hash) {
        tia_simd_light_plain(view, tile, surface, options);
        return;
    }
    for (int x = (int)tile.x, right = tile_right(tile); x < right; x += SIMD_STRIP) {
        int width = right - x < SIMD_STRIP ? right - x : SIMD_STRIP;
        struct tia_tile strip = {(uint16_t)x, tile.y, (uint16_t)width, tile.height};
        part.pixels = (void *)((char *)surface->pixels + (ptrdiff_t)(x - (int)tile.x) * surface->step);
        light_strip(view, strip, &part, options->dither, streams, carried);
    }
    if (streams)
        kernels->settle();
}

const struct simd_renderer tia_simd_spans = {tia_simd_pairs_size, tia_simd_draws, NULL, tia_simd_prepare, room,
                                             tia_simd_light,      NULL,           NULL};
