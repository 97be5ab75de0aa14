/* light.c - draws a tile by vector units: divides it into rows, and rows into runs of one object, and chooses a method
 * for each run. */
#include "bound_cache.h"
#include "crowd.h"
#include "exact.h"
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
    view->simd->kernels->fill(out, count, flat->pixels);
}

static size_t room(const struct tia_simd *simd)
{
    return simd_room(sizeof(struct carried), simd->kernels->cells);
}

/* Draws a run with all its lights at once. */
static void light_run(const struct simd_pixels *pixels, int count, struct carried *carried)
{
    const struct tia_view *view = pixels->view;
    struct simd_fine *fine = &carried->fine;
    int first = pixels->first;

    if (!tia_simd_fine(view, pixels->row, pixels->sphere, simd_lamp_of(view, pixels->sphere, 0), first, first + count,
                       fine) ||
        !tia_simd_fine_bounds(fine, simd_cache_of(carried->caches, fine))) {
        tia_simd_decide(pixels, NULL, count);
        return;
    }
    tia_simd_run(fine, &carried->dither, &carried->run);
    int open = view->simd->kernels->shade(&carried->run, pixels->out, carried->list,
                                          simd_kernels_room(carried, sizeof *carried));
    tia_simd_decide(pixels, carried->list, open);
}

/* Adds the lights to a run, whose place is known; false when their bounds are too large. */
static bool add_lights(const struct simd_pixels *pixels, struct carried *carried, struct simd_sums *sums)
{
    const struct tia_view *view = pixels->view;
    struct simd_fine *fine = &carried->fine;
    double off[3] = {0, 0, 0};

    for (uint32_t l = 0; l < view->light_count; l++) {
        const struct simd_lamp *lamp = tia_simd_crowd_lamp(view, &carried->crowd, l);
        if (!lamp)
            continue;
        fine->lights = fine->casts = 0;
        tia_simd_fine_light(fine, lamp);
        if (!tia_simd_fine_lights(fine, off))
            return false;
        tia_simd_run_lights(fine, &carried->run);
        int open = view->simd->kernels->add(&carried->run, sums, carried->list);
        tia_simd_decide_lamp(pixels, lamp, fine->light[0].bounds.lambert, carried->list, open, sums);
    }
    return tia_simd_fine_levels(fine, off);
}

/* Draws a run of a crowd light by light, each with its casters near the run. */
static void light_crowd(const struct simd_pixels *pixels, int count, struct carried *carried)
{
    const struct tia_view *view = pixels->view;
    const struct simd_kernels *kernels = view->simd->kernels;
    struct simd_fine *fine = &carried->fine;
    struct simd_sums *sums = simd_kernels_room(carried, sizeof *carried);
    int end = pixels->first + count;

    tia_simd_crowd(view, pixels->sphere, pixels->row->y, pixels->first, end, &carried->crowd);
    bool good =
        tia_simd_fine_place(view, pixels->row, pixels->sphere, pixels->first, end, fine) && tia_simd_fine_depth(fine);
    if (good) {
        tia_simd_run_place(fine, &carried->dither, &carried->run);
        kernels->start(&carried->run, sums);
        good = add_lights(pixels, carried, sums);
    }
    if (!good) {
        tia_simd_decide(pixels, NULL, count);
        return;
    }
    tia_simd_run_levels(fine, &carried->dither, &carried->run);
    int open = kernels->finish(&carried->run, sums, pixels->out, carried->list);
    tia_simd_decide(pixels, carried->list, open);
}

static void light_span(const struct tia_view *view, const struct simd_row *row, const struct simd_span *span,
                       struct carried *carried, tia_rgb565 *out)
{
    if (span->object >= view->scene->sphere_count) { /* a light or TIA_NO_OBJECT */
        light_flat(view, span, carried, out);
        return;
    }
    bool crowded = tia_simd_is_crowded(view, span->object);
    int most = crowded ? SIMD_BLOCK : SIMD_RUN;
    for (int x = span->first, end; x < span->end; x = end) {
        end = span->end - x < most ? span->end : x + most;
        const struct simd_pixels pixels = {view,
                                           row,
                                           span->object,
                                           crowded ? &carried->crowd : NULL,
                                           x,
                                           carried->dither.threshold,
                                           out + (x - span->first)};
        if (crowded)
            light_crowd(&pixels, end - x, carried);
        else
            light_run(&pixels, end - x, carried);
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
