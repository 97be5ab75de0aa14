/* denoising.c - removes noise from gathered samples, and draws the denoiser's guides. */
#include <stdlib.h>
#include <tia/debug.h>

#include "estimation.h"
#include "pixels/pages.h"

static struct tia_tile row_of(const struct denoising *d, unsigned y)
{
    return (struct tia_tile){0, (uint16_t)y, (uint16_t)d->e->film.width, 1};
}

int denoising_begin(struct denoising *d, struct estimation *e)
{
    size_t size = tia_denoise_size(e->film.width, e->film.height);

    *d = (struct denoising){.e = e, .memory = pages_alloc(size)};
    return d->memory ? tia_denoise_init(&d->denoiser, d->memory, size, e->film.width, e->film.height) : TIA_ERR_MEMORY;
}

void denoising_end(struct denoising *d)
{
    free(d->memory);
    d->memory = NULL;
}

void denoising_put(struct denoising *d, unsigned y, const struct tia_gathered *row)
{
    (void)tia_denoise_put(d->denoiser, row_of(d, y), row, d->e->sums.count);
}

static void pass(void *arg, unsigned y)
{
    struct denoising *d = arg;

    (void)tia_denoise_pass(d->denoiser, d->pass, row_of(d, y));
}

void denoising_filter(struct denoising *d)
{
    for (d->pass = 0; d->pass < TIA_DENOISE_PASSES; d->pass++)
        threads_run(d->e->pool, pass, d, d->e->film.height);
}

void denoising_get(const struct denoising *d, unsigned y, struct tia_sum *row)
{
    (void)tia_denoise_get(d->denoiser, row_of(d, y), d->e->sums.count, row, d->e->film.width);
}

void show_guide(const struct estimation *e, const struct tia_gathered *row)
{
    const enum tia_shown_guide guide = (enum tia_shown_guide)e->options->guide;
    const int bits = guide == TIA_SHOW_DEPTH ? (int)e->options->scene.scale_bits : 0;
    const int64_t over = INT64_C(1) << (bits > 0 ? bits : 0), times = INT64_C(1) << (bits < 0 ? -bits : 0);

    for (size_t x = 0; x < e->film.width; x++) {
        struct tia_sum sum = tia_guide_shown(guide, row, x, e->sums.count);
        for (int c = 0; c < 3; c++)
            row->sums[x].rgb[c] = sum.rgb[c] / over * times;
    }
}
