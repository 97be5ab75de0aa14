#include "measure.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <tia/debug.h>

#define BAND_ROWS 16u /* rows of a job: a band of the widest image takes some 5 MB */

/* A band drawn by one arithmetic. */
struct layer {
    tia_rgb565 *pixels;
    uint32_t *path_hash, *object;
};

/* The views of the cores, and then of the reference. */
struct frame {
    const struct measure *what;
    const struct tia_core *cores[MEASURE_CORES + 1];
    struct tia_view *views[MEASURE_CORES + 1];
    void *memory[MEASURE_CORES + 1];
    struct band *bands;
};

struct band {
    int status;
    struct tally tallies[MEASURE_CORES];
};

void tally_add(struct tally *sum, const struct tally *part)
{
    sum->pixels += part->pixels;
    sum->identical += part->identical;
    sum->one += part->one;
    sum->more += part->more;
    sum->flips += part->flips;
    sum->stray += part->stray;
    sum->largest = part->largest > sum->largest ? part->largest : sum->largest;
    sum->astray = part->astray > sum->astray ? part->astray : sum->astray;
    sum->squares += part->squares;
}

double tally_percent(const struct tally *tally)
{
    return 100.0 * (double)tally->identical / (double)tally->pixels;
}

double tally_psnr(const struct tally *tally)
{
    double mean = (double)tally->squares / (3.0 * (double)tally->pixels);

    return 10.0 * log10(31.0 * 63.0 * 31.0 * 63.0 / mean);
}

static enum verdict judge(struct tally *tally, tia_rgb565 want, tia_rgb565 got, bool flip)
{
    int64_t r = (got >> 11) - (want >> 11), g = (got >> 5 & 63) - (want >> 5 & 63), b = (got & 31) - (want & 31);
    uint64_t largest = (uint64_t)llabs(r);

    largest = (uint64_t)llabs(g) > largest ? (uint64_t)llabs(g) : largest;
    largest = (uint64_t)llabs(b) > largest ? (uint64_t)llabs(b) : largest;
    tally->pixels++;
    tally->identical += largest == 0;
    tally->one += largest == 1;
    tally->more += largest > 1;
    tally->flips += flip;
    tally->stray += largest > 1 && !flip;
    tally->largest = largest > tally->largest ? largest : tally->largest;
    tally->astray = !flip && largest > tally->astray ? largest : tally->astray;
    tally->squares += (uint64_t)((r * r + b * b) * 63 * 63 + g * g * 31 * 31);
    return flip ? FLIP : largest > 1 ? MORE : largest == 1 ? ONE_LEVEL : SAME;
}

static struct measure_pixel pixel_of(const struct layer *layer, struct tia_tile tile, size_t i)
{
    struct measure_pixel pixel = {.x = tile.x + (unsigned)(i % tile.width), .y = tile.y + (unsigned)(i / tile.width)};

    pixel.colour = layer->pixels[i];
    pixel.object = layer->object[i];
    pixel.path_hash = layer->path_hash[i];
    return pixel;
}

static void compare(struct frame *frame, unsigned core, struct tia_tile tile, const struct layer *want,
                    const struct layer *got)
{
    const struct measure *what = frame->what;
    struct tally *tally = &frame->bands[tile.y / BAND_ROWS].tallies[core];
    size_t count = (size_t)tile.width * tile.height;

    for (size_t i = 0; i < count; i++) {
        bool flip = want->object[i] != got->object[i] || want->path_hash[i] != got->path_hash[i];
        enum verdict verdict = judge(tally, want->pixels[i], got->pixels[i], flip);
        if (verdict != SAME && what->differs) {
            struct measure_pixel a = pixel_of(want, tile, i), b = pixel_of(got, tile, i);
            what->differs(what->arg, core, verdict, &a, &b);
        }
    }
}

static int draw(const struct frame *frame, unsigned n, struct tia_tile tile, struct layer *layer)
{
    const struct tia_core *core = frame->cores[n];
    struct tia_surface surface = {.pixels = layer->pixels, .step = 2, .pitch = 2 * (ptrdiff_t)tile.width};
    struct tia_options options = {.dither = frame->what->dither,
                                  .debug = &(struct tia_debug){.path_hash = layer->path_hash}};
    size_t size = core->hits_size(core, frame->what->scene, tile), i = 0;
    void *memory = malloc(size);
    struct tia_hits *hits = NULL;
    int status = !memory ? TIA_ERR_MEMORY : tia_hits_init(&hits, memory, size, frame->views[n], tile);

    if (!status)
        status = tia_view_trace(frame->views[n], hits, tile);
    if (!status)
        status = tia_view_light(frame->views[n], hits, tile, &surface, &options);
    if (!status)
        for (unsigned y = tile.y; y < tile.y + (unsigned)tile.height; y++)
            for (unsigned x = 0; x < tile.width; x++)
                layer->object[i++] = tia_hits_object(hits, x, y);
    free(memory);
    return status;
}

static bool layer_create(struct layer *layer, size_t count)
{
    layer->pixels = malloc(count * sizeof *layer->pixels);
    layer->path_hash = malloc(count * sizeof *layer->path_hash);
    layer->object = malloc(count * sizeof *layer->object);
    return layer->pixels && layer->path_hash && layer->object;
}

static void layer_destroy(struct layer *layer)
{
    free(layer->pixels);
    free(layer->path_hash);
    free(layer->object);
}

static void keep_picture(const struct measure *what, struct tia_tile tile, const struct layer *reference)
{
    if (what->picture)
        memcpy(what->picture + (size_t)tile.y * what->width, reference->pixels,
               (size_t)tile.width * tile.height * sizeof *reference->pixels);
}

static void measure_band(void *arg, unsigned index)
{
    struct frame *frame = arg;
    const struct measure *what = frame->what;
    unsigned y = index * BAND_ROWS, left = what->height - y;
    struct tia_tile tile = {0, (uint16_t)y, (uint16_t)what->width, (uint16_t)(left < BAND_ROWS ? left : BAND_ROWS)};
    size_t count = (size_t)tile.width * tile.height;
    struct layer want = {0}, got = {0};
    int status = layer_create(&want, count) && layer_create(&got, count) ? TIA_OK : TIA_ERR_MEMORY;

    if (!status)
        status = draw(frame, what->core_count, tile, &want);
    if (!status)
        keep_picture(what, tile, &want);
    for (unsigned core = 0; core < what->core_count && !status; core++) {
        status = draw(frame, core, tile, &got);
        if (!status)
            compare(frame, core, tile, &want, &got);
    }
    frame->bands[index].status = status;
    layer_destroy(&want);
    layer_destroy(&got);
}

static int prepare(struct frame *frame)
{
    const struct tia_scene *scene = frame->what->scene;
    int status = TIA_OK;

    for (unsigned i = 0; i <= frame->what->core_count && !status; i++) {
        size_t size = frame->cores[i]->view_size(frame->cores[i], scene, scene->light_count);
        frame->memory[i] = malloc(size);
        status = !frame->memory[i]
                     ? TIA_ERR_MEMORY
                     : frame->cores[i]->view_init(frame->cores[i], &frame->views[i], frame->memory[i], size, scene,
                                                  scene->light_count, frame->what->width, frame->what->height, NULL);
    }
    return status;
}

static int sum_up(const struct frame *frame, unsigned band_count, struct tally *tallies)
{
    memset(tallies, 0, frame->what->core_count * sizeof *tallies);
    for (unsigned i = 0; i < band_count; i++) {
        if (frame->bands[i].status)
            return frame->bands[i].status;
        for (unsigned core = 0; core < frame->what->core_count; core++)
            tally_add(&tallies[core], &frame->bands[i].tallies[core]);
    }
    return TIA_OK;
}

int measure(const struct measure *what, struct tally *tallies)
{
    unsigned band_count = (what->height + BAND_ROWS - 1) / BAND_ROWS;
    struct frame frame = {.what = what};

    memcpy(frame.cores, what->cores, sizeof what->cores);
    frame.cores[what->core_count] = what->reference;
    frame.bands = calloc(band_count, sizeof *frame.bands);
    int status = !frame.bands ? TIA_ERR_MEMORY : prepare(&frame);
    if (!status) {
        what->workers->run(what->workers->ctx, measure_band, &frame, band_count);
        status = sum_up(&frame, band_count, tallies);
    }
    for (unsigned i = 0; i <= what->core_count; i++)
        free(frame.memory[i]);
    free(frame.bands);
    return status;
}
