#include "oracle/against.h"

#include <stdlib.h>
#include <string.h>

#define BAND_ROWS 32u

struct job {
    const struct tia_core *core;
    const struct tia_view *view;
    const struct tia_scene *truth;
    unsigned width, height;
    bool dither;
    int *status;
    struct against *parts;
};

/* One band as the library draws it. */
struct band {
    struct tia_tile tile;
    tia_rgb565 *pixels;
    uint32_t *reached;
    struct tia_hits *hits;
    void *memory;
};

void against_add(struct against *sum, const struct against *part)
{
    sum->pixels += part->pixels;
    sum->identical += part->identical;
    sum->one += part->one;
    sum->flips += part->flips;
    sum->undecided += part->undecided;
    sum->stray += part->stray;
    sum->margin = part->margin > sum->margin ? part->margin : sum->margin;
    for (unsigned i = 0; i < part->note_count && sum->note_count < AGAINST_NOTES; i++)
        sum->notes[sum->note_count++] = part->notes[i];
}

static unsigned distance(unsigned a, unsigned b)
{
    return a > b ? a - b : b - a;
}

static unsigned levels_apart(tia_rgb565 a, tia_rgb565 b)
{
    unsigned r = distance(a >> 11, b >> 11), g = distance(a >> 5 & 63, b >> 5 & 63), d = distance(a & 31, b & 31);

    return r > g ? (r > d ? r : d) : (g > d ? g : d);
}

static void judge(const struct job *job, struct against *out, const struct against_note *note)
{
    unsigned levels = levels_apart(note->colour, note->want.colour);
    bool flip = note->object != note->want.sphere || note->reached != note->want.reached;

    out->pixels++;
    out->identical += levels == 0;
    out->one += levels == 1;
    out->flips += flip;
    out->undecided += flip && oracle_undecided(job->truth, job->width, job->height, note->x, note->y, AGAINST_REACH);
    out->stray += levels > 1 && !flip;
    if (levels == 1 && !flip && note->want.margin > out->margin)
        out->margin = note->want.margin;
    if ((levels > 0 || flip) && out->note_count < AGAINST_NOTES)
        out->notes[out->note_count++] = *note;
}

static void compare(const struct job *job, const struct band *band, struct against *out)
{
    size_t i = 0;

    for (unsigned y = band->tile.y; y < band->tile.y + (unsigned)band->tile.height; y++) {
        for (unsigned x = 0; x < job->width; x++, i++) {
            struct against_note note = {.x = x, .y = y, .colour = band->pixels[i], .reached = band->reached[i]};
            note.object = job->core->hits_object(band->hits, x, y);
            note.want = oracle_pixel(job->truth, job->width, job->height, x, y, job->dither);
            judge(job, out, &note);
        }
    }
}

static int draw(const struct job *job, struct band *band)
{
    size_t count = (size_t)band->tile.width * band->tile.height, size = job->core->hits_size(band->tile);
    struct tia_surface surface = {NULL, 2, 2 * (ptrdiff_t)band->tile.width};
    struct tia_options options = {.dither = job->dither};

    band->pixels = surface.pixels = malloc(count * sizeof *band->pixels);
    band->reached = options.reached = malloc(count * sizeof *band->reached);
    band->memory = malloc(size);
    if (band->pixels == NULL || band->reached == NULL || band->memory == NULL)
        return TIA_ERR_MEMORY;
    int status = job->core->hits_init(&band->hits, band->memory, size, band->tile);
    if (status == TIA_OK)
        status = job->core->trace(job->view, band->hits, band->tile);
    if (status == TIA_OK)
        status = job->core->light(job->view, band->hits, band->tile, &surface, &options);
    return status;
}

static void compare_band(void *arg, unsigned index)
{
    struct job *job = arg;
    unsigned y = index * BAND_ROWS, left = job->height - y;
    struct band band = {
        .tile = {0, (uint16_t)y, (uint16_t)job->width, (uint16_t)(left < BAND_ROWS ? left : BAND_ROWS)}};

    job->status[index] = draw(job, &band);
    if (job->status[index] == TIA_OK)
        compare(job, &band, &job->parts[index]);
    free(band.pixels);
    free(band.reached);
    free(band.memory);
}

static int run(struct job *job, const struct tia_workers *workers, void *workers_ctx, struct against *out)
{
    unsigned count = (job->height + BAND_ROWS - 1) / BAND_ROWS;
    int status = TIA_OK;

    job->status = calloc(count, sizeof *job->status);
    job->parts = calloc(count, sizeof *job->parts);
    if (job->status == NULL || job->parts == NULL)
        status = TIA_ERR_MEMORY;
    else
        workers->run(workers_ctx, compare_band, job, count);
    for (unsigned i = 0; i < count && status == TIA_OK; i++) {
        status = job->status[i];
        against_add(out, &job->parts[i]);
    }
    free(job->status);
    free(job->parts);
    return status;
}

int against_oracle(const struct tia_core *core, const struct tia_scene *scene, const struct tia_scene *truth,
                   unsigned width, unsigned height, bool dither, const struct tia_workers *workers, void *workers_ctx,
                   struct against *out)
{
    size_t size = core->view_size(scene, scene->light_count);
    void *memory = malloc(size);
    struct tia_view *view = NULL;
    int status = memory == NULL ? TIA_ERR_MEMORY
                                : core->view_init(&view, memory, size, scene, scene->light_count, width, height);
    struct job job = {.core = core, .truth = truth, .width = width, .height = height, .dither = dither};

    memset(out, 0, sizeof *out);
    job.view = view;
    if (status == TIA_OK)
        status = run(&job, workers, workers_ctx, out);
    free(memory);
    return status;
}
