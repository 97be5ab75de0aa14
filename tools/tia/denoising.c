/* denoising.c - gathered samples without noise, and what a denoiser goes by. */
#include <stdlib.h>

#include "estimation.h"
#include "pixels/pages.h"

struct denoising {
    struct estimation *e;
    const struct tia_gathered *gathered;
    struct tia_denoiser *denoiser;
    unsigned pass;
};

static struct tia_tile row_of(const struct denoising *d, unsigned y)
{
    return (struct tia_tile){0, (uint16_t)y, (uint16_t)d->e->film.width, 1};
}

static struct tia_gathered gathered_row(const struct denoising *d, unsigned y)
{
    struct tia_gathered row = *d->gathered;
    size_t place = y * row.pitch;

    row.sums += place;
    row.guides += place;
    row.squares += place;
    return row;
}

static void put(void *arg, unsigned y)
{
    struct denoising *d = arg;
    struct tia_gathered row = gathered_row(d, y);

    (void)tia_denoise_put(d->denoiser, row_of(d, y), &row, d->e->sums.count);
}

static void pass(void *arg, unsigned y)
{
    struct denoising *d = arg;

    (void)tia_denoise_pass(d->denoiser, d->pass, row_of(d, y));
}

static void get(void *arg, unsigned y)
{
    struct denoising *d = arg;
    struct tia_gathered row = gathered_row(d, y);

    (void)tia_denoise_get(d->denoiser, row_of(d, y), d->e->sums.count, row.sums, row.pitch);
}

int denoise_sums(struct estimation *e, const struct tia_gathered *gathered)
{
    struct denoising d = {.e = e, .gathered = gathered};
    unsigned height = e->film.height;
    size_t size = tia_denoise_size(e->film.width, height);
    void *memory = pages_alloc(size);
    int status = memory ? tia_denoise_init(&d.denoiser, memory, size, e->film.width, height) : TIA_ERR_MEMORY;

    if (!status) {
        threads_workers.run(e->pool, put, &d, height);
        for (; d.pass < TIA_DENOISE_PASSES; d.pass++)
            threads_workers.run(e->pool, pass, &d, height);
        threads_workers.run(e->pool, get, &d, height);
    }
    free(memory);
    return status;
}

int show_guide(struct estimation *e, const struct tia_gathered *gathered)
{
    const enum tia_shown_guide guide = (enum tia_shown_guide)e->options->guide;
    const int64_t unit = guide == TIA_SHOW_DEPTH ? INT64_C(1) << e->options->scene.scale_bits : 1;
    size_t pixels = (size_t)e->film.width * e->film.height;

    for (size_t i = 0; i < pixels; i++) {
        struct tia_sum sum = tia_guide_shown(guide, gathered, i, e->sums.count);
        for (int c = 0; c < 3; c++)
            gathered->sums[i].rgb[c] = sum.rgb[c] / unit;
    }
    return TIA_OK;
}
