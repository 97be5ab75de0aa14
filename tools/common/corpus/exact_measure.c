#include "exact_measure.h"

#include <stdlib.h>
#include <string.h>
#include <tia/debug.h>

#define BAND_ROWS 16u /* rows of a job */

struct band {
    int status;
    struct exact_tally tally;
};

/* A picture's views, one for each drawer, and the results of its bands. */
struct frame {
    const struct exact_measure *what;
    struct tia_view *views[EXACT_DRAWERS];
    void *memory[EXACT_DRAWERS], *simd_memory[EXACT_DRAWERS];
    struct band *bands;
};

/* Returns the name of an instruction set. */
static const char *name_of(const struct tia_simd *simd)
{
    static const char *const names[] = {"scalar", "sse41", "avx2", "avx512", "neon", "rvv", "wasm"};
    const struct tia_simd *named;

    for (unsigned i = 0; i < sizeof names / sizeof names[0]; i++)
        if (!tia_simd_named(names[i], &named) && named == simd)
            return names[i];
    return "other";
}

void exact_drawers(struct exact_measure *what)
{
    const struct tia_simd *simd;

    what->drawers[0] = (struct exact_drawer){"plain", &tia_core_q16, NULL, false};
    what->drawers[1] = (struct exact_drawer){"small", &tia_core_spheres_small, NULL, false};
    what->drawer_count = 2;
    for (unsigned i = 0; (simd = tia_simd_at(i)) != NULL && what->drawer_count < EXACT_DRAWERS; i++)
        what->drawers[what->drawer_count++] = (struct exact_drawer){name_of(simd), &tia_core_q16, simd, false};
}

void exact_add(struct exact_measure *what, const struct tia_core *core)
{
    if (what->drawer_count < EXACT_DRAWERS)
        what->drawers[what->drawer_count++] = (struct exact_drawer){core->name, core, NULL, true};
}

static void drawn_add(struct exact_drawn *sum, const struct exact_drawn *part)
{
    struct exact_drawn first = sum->differ ? *sum : *part;

    first.pixels = sum->pixels + part->pixels;
    first.differ = sum->differ + part->differ;
    *sum = first;
}

void exact_tally_add(struct exact_tally *sum, const struct exact_tally *part)
{
    sum->pixels += part->pixels;
    sum->ties += part->ties;
    for (unsigned i = 0; i < EXACT_STAGES; i++)
        sum->stage[i] += part->stage[i];
    for (unsigned i = 0; i < EXACT_DRAWERS; i++)
        drawn_add(&sum->by[i], &part->by[i]);
}

/* Compares pixels of a tile. `exact` has every `step`th pixel of the picture from number `first` on. */
static void compare(const struct exact_measure *what, struct tia_tile tile, const tia_rgb565 *drawn, uint32_t first,
                    uint32_t count, const struct tia_exact *exact, struct exact_drawn *result)
{
    for (uint32_t i = 0; i < count; i++) {
        uint32_t number = first + i * what->step;
        tia_rgb565 got = drawn[number - (uint32_t)tile.y * tile.width], want = exact[i].colour;
        struct exact_drawn pixel = {1, got != want, number % tile.width, number / tile.width, want, got};
        drawn_add(result, &pixel);
    }
}

static void count_stages(struct exact_tally *tally, const struct tia_exact *exact, uint32_t count)
{
    tally->pixels += count;
    for (uint32_t i = 0; i < count; i++) {
        tally->ties += exact[i].tie;
        for (unsigned k = 0; k < EXACT_STAGES; k++)
            tally->stage[k] += exact[i].bits == 64u << k;
    }
}

static int draw(const struct frame *frame, unsigned n, struct tia_tile tile, tia_rgb565 *pixels)
{
    const struct tia_core *core = frame->what->drawers[n].core;
    struct tia_surface surface = {.pixels = pixels, .step = 2, .pitch = 2 * (ptrdiff_t)tile.width};
    struct tia_options options = {.dither = frame->what->dither};
    size_t size = core->hits_size(core, frame->what->scene, tile);
    void *memory = malloc(size);
    struct tia_hits *hits = NULL;
    int status = !memory ? TIA_ERR_MEMORY : tia_hits_init(&hits, memory, size, frame->views[n], tile);

    if (!status)
        status = tia_view_draw(frame->views[n], hits, tile, &surface, &options);
    free(memory);
    return status;
}

/* Computes the exact pixels of a tile, and compares those of each drawer with them. */
static int measure_tile(const struct frame *frame, struct tia_tile tile, tia_rgb565 *pixels, struct tia_exact *exact,
                        struct exact_tally *tally)
{
    const struct exact_measure *what = frame->what;
    uint32_t begin = (uint32_t)tile.y * tile.width, end = begin + (uint32_t)tile.width * tile.height;
    uint32_t first = (begin + what->step - 1) / what->step * what->step;
    uint32_t count = first < end ? (end - 1 - first) / what->step + 1 : 0;
    int status = tia_view_exact(frame->views[0], first, what->step, count, what->dither, exact);

    for (unsigned n = 0; n < what->drawer_count && !status; n++) {
        if (!frame->views[n])
            continue;
        status = draw(frame, n, tile, pixels);
        if (!status)
            compare(what, tile, pixels, first, count, exact, &tally->by[n]);
    }
    if (!status)
        count_stages(tally, exact, count);
    return status;
}

static void measure_band(void *arg, unsigned index)
{
    struct frame *frame = arg;
    unsigned width = frame->what->width, y = index * BAND_ROWS, left = frame->what->height - y;
    struct tia_tile tile = {0, (uint16_t)y, (uint16_t)width, (uint16_t)(left < BAND_ROWS ? left : BAND_ROWS)};
    size_t count = (size_t)tile.width * tile.height;
    tia_rgb565 *pixels = malloc(count * sizeof *pixels);
    struct tia_exact *exact = malloc(count * sizeof *exact);
    struct band *band = &frame->bands[index];

    band->status = pixels && exact ? measure_tile(frame, tile, pixels, exact, &band->tally) : TIA_ERR_MEMORY;
    free(pixels);
    free(exact);
}

static int open_view(struct frame *frame, unsigned n)
{
    const struct exact_measure *what = frame->what;
    const struct exact_drawer *drawer = &what->drawers[n];
    uint32_t lights = what->scene->light_count;
    size_t size = drawer->core->view_size(drawer->core, what->scene, lights);
    size_t more = tia_simd_size(drawer->simd, what->scene, lights, what->workers->count);

    frame->memory[n] = malloc(size);
    frame->simd_memory[n] = more ? malloc(more) : NULL;
    if (!frame->memory[n] || (more && !frame->simd_memory[n]))
        return TIA_ERR_MEMORY;
    int status = drawer->core->view_init(drawer->core, &frame->views[n], frame->memory[n], size, what->scene, lights,
                                         what->width, what->height, NULL);
    return status || !drawer->simd ? status
                                   : tia_view_set_simd(frame->views[n], drawer->simd, frame->simd_memory[n], more);
}

/* Opens the views. One stays NULL where the smaller code refuses parts of the scene that others ignore, or where the
 * vector units leave the scene to plain C. */
static int open_views(struct frame *frame)
{
    struct tia_exact pixel;
    int status = open_view(frame, 0);

    if (!status)
        status = tia_view_exact(frame->views[0], 0, 1, 0, false, &pixel);
    for (unsigned n = 1; n < frame->what->drawer_count && !status; n++) {
        const struct exact_drawer *drawer = &frame->what->drawers[n];
        status = open_view(frame, n);
        bool refused = status == TIA_ERR_RANGE || status == TIA_ERR_UNSUPPORTED;
        if (refused || (!status && drawer->simd && strcmp(tia_view_simd(frame->views[n]), drawer->name) != 0))
            frame->views[n] = NULL;
        status = refused ? TIA_OK : status;
    }
    return status;
}

static int sum_up(const struct frame *frame, unsigned band_count, struct exact_tally *tally)
{
    for (unsigned i = 0; i < band_count; i++) {
        if (frame->bands[i].status)
            return frame->bands[i].status;
        exact_tally_add(tally, &frame->bands[i].tally);
    }
    return TIA_OK;
}

static void close_frame(struct frame *frame)
{
    for (unsigned n = 0; n < frame->what->drawer_count; n++) {
        free(frame->memory[n]);
        free(frame->simd_memory[n]);
    }
    free(frame->bands);
}

int exact_measure(const struct exact_measure *what, struct exact_tally *tally)
{
    unsigned band_count = (what->height + BAND_ROWS - 1) / BAND_ROWS;
    struct frame frame = {.what = what};

    memset(tally, 0, sizeof *tally);
    frame.bands = calloc(band_count, sizeof *frame.bands);
    int status = !frame.bands ? TIA_ERR_MEMORY : open_views(&frame);
    if (!status) {
        what->workers->run(what->workers->ctx, measure_band, &frame, band_count);
        status = sum_up(&frame, band_count, tally);
    }
    close_frame(&frame);
    return status;
}
