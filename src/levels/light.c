/* light.c - a tile by a level: rows, runs of one object, and what becomes of each. */
#include "exact.h"
#include "level.h"
#include "render/dither.h"
#include "render/span/shade.h"
#include "seen.h"

/* Frames of scenes with the eye in a sphere are for plain C. */
bool tia_level_draws(const struct tia_view *view)
{
    const struct span_view *spans = span_view_of(view);

    for (uint32_t n = 0; n < view->scene->sphere_count; n++)
        if (spans->spheres[n].radius > 0 && spans->spheres[n].c <= 0)
            return false;
    return true;
}

/* ---- rows ---- */

static void fill(tia_rgb565 *out, int count, tia_rgb565 pixel)
{
    for (int i = 0; i < count; i++)
        out[i] = pixel;
}

/* The background, or a light itself: one colour, but for dithering. */
static void light_flat(const struct span_view *spans, const struct tia_rgb *colour, const struct level_span *span,
                       const num_u threshold[8], tia_rgb565 *out)
{
    const tia_q30 channel[3] = {colour->r, colour->g, colour->b};
    int count = span->end - span->first;
    num_u rgb[3][8];
    tia_rgb565 pixels[8];

    for (int c = 0; c < 3; c++)
        for (int i = 0; i < 8; i++)
            rgb[c][i] = num_clamp(num_colour(channel[c]));
    spans->kernels->pack(rgb[0], rgb[1], rgb[2], threshold, span->first, 8, pixels);
    if (threshold[0] == threshold[1])
        fill(out, count, pixels[0]);
    else
        for (int i = 0; i < count; i++)
            out[i] = pixels[i & 7];
}

static void light_part(const struct tia_view *view, const struct level_row *row, uint32_t sphere, int first, int end,
                       const num_u threshold[8], tia_rgb565 *out)
{
    struct level_fine fine;
    struct level_run run;
    uint16_t list[LEVEL_RUN + 64];

    if (!tia_level_fine(view, row, sphere, first, end, &fine) ||
        !tia_level_fine_bounds(&fine, LEVEL_FLOAT, LEVEL_FLOAT_CUT)) {
        tia_level_plain(view, sphere, first, row->y, end - first, threshold, out);
        return;
    }
    tia_level_run(&fine, threshold, &run);
    int count = view->level->kernels->shade(&run, out, list);
    tia_level_decide(&fine, list, count, threshold, out);
}

static void light_span(const struct tia_view *view, const struct level_row *row, const struct level_span *span,
                       const num_u threshold[8], tia_rgb565 *out)
{
    const struct tia_scene *scene = view->scene;

    if (span->object == TIA_NO_OBJECT) {
        light_flat(span_view_of(view), &scene->background, span, threshold, out);
        return;
    }
    if (span->object >= scene->sphere_count) {
        const struct tia_light *light = &view->lights[span->object - scene->sphere_count];
        light_flat(span_view_of(view), &light->emission, span, threshold, out);
        return;
    }
    for (int x = span->first; x < span->end; x += LEVEL_RUN) {
        int end = span->end - x < LEVEL_RUN ? span->end : x + LEVEL_RUN;
        light_part(view, row, span->object, x, end, threshold, out + (x - span->first));
    }
}

static void copy(const tia_rgb565 *pixels, unsigned count, char *out, ptrdiff_t step)
{
    for (unsigned i = 0; i < count; i++)
        *(tia_rgb565 *)(void *)(out + (ptrdiff_t)i * step) = pixels[i];
}

static void light_row(const struct tia_view *view, const struct level_row *row, struct tia_tile tile,
                      const struct level_line *line, const struct tia_surface *surface, bool dither)
{
    char *out = (char *)surface->pixels + (row->y - (int)tile.y) * surface->pitch;
    bool direct = surface->step == sizeof(tia_rgb565);
    tia_rgb565 pixels[LEVEL_STRIP], *place = direct ? (tia_rgb565 *)(void *)out : pixels;
    num_u threshold[8];

    dither_thresholds(dither, row->y, threshold);
    for (int i = 0; i < line->count; i++) {
        const struct level_span *span = &line->spans[line->which][i];
        light_span(view, row, span, threshold, place + (span->first - (int)tile.x));
    }
    if (!direct)
        copy(pixels, tile.width, out, surface->step);
}

static void light_strip(const struct tia_view *view, struct tia_tile tile, const struct tia_surface *surface,
                        bool dither)
{
    const struct span_view *spans = span_view_of(view);
    struct span guess[LEVEL_GUESSES] = {{0, 0}};
    struct level_line line;

    for (int y = (int)tile.y; y < tile_bottom(tile) && !view_stops(view); y++) {
        struct level_row row;
        tia_level_row(&spans->primary, y, &row);
        tia_level_find(view, &row, tile, guess, &line);
        light_row(view, &row, tile, &line, surface, dither);
    }
}

void tia_level_light(const struct tia_view *view, struct tia_tile tile, const struct tia_surface *surface,
                     const struct tia_options *options)
{
    struct tia_surface part = *surface;

    if (options->path_hash) {
        tia_level_light_plain(view, tile, surface, options);
        return;
    }
    for (int x = (int)tile.x, right = tile_right(tile); x < right; x += LEVEL_STRIP) {
        int width = right - x < LEVEL_STRIP ? right - x : LEVEL_STRIP;
        struct tia_tile strip = {(uint16_t)x, tile.y, (uint16_t)width, tile.height};
        part.pixels = (void *)((char *)surface->pixels + (ptrdiff_t)(x - (int)tile.x) * surface->step);
        light_strip(view, strip, &part, options->dither);
    }
}

const struct level_renderer tia_level_spans = {tia_level_pairs_size, tia_level_draws, NULL, tia_level_prepare,
                                               tia_level_light};
