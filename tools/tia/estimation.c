#include "estimation.h"

#include <stdlib.h>

#include "common/image/image.h"
#include "common/sink.h"

/* Most pixels of a band, and least number of bands. A pixel of a band takes two sums and 4 bytes, that is, 52 bytes,
 * apart from the denoiser's guides. So a band, a quarter of the picture, takes less than 16 bytes for each pixel of the
 * picture. */
enum { BAND_PIXELS = 1 << 16, BANDS_MIN = 4 };

unsigned estimation_band_rows(const struct estimation *e)
{
    unsigned most = BAND_PIXELS / e->film.width, part = e->film.height / BANDS_MIN, rows = part < most ? part : most;

    return rows ? rows : 1;
}

int estimation_open(struct estimation *e)
{
    const struct options *options = e->options;

    if (tap_chooses(options->tap))
        return TIA_OK;
    if (options->format != IMAGE_PART) {
        e->image = image_create_film(options->output, options->format, &e->film, e->why);
        return e->image ? TIA_OK : TIA_ERR_DEVICE;
    }
    e->sink = calloc(1, sizeof *e->sink);
    if (!e->sink)
        return TIA_ERR_MEMORY;
    int status = sink_open(e->sink, options->output, e->why);
    if (status) {
        free(e->sink);
        e->sink = NULL;
        return status;
    }
    return TIA_OK;
}

int estimation_head(struct estimation *e)
{
    char header[SUMS_HEADER];

    return e->sink ? sink_write(e->sink, header, sums_print(header, &e->sums)) : TIA_OK;
}

void estimation_develop(struct estimation *e, unsigned y, unsigned row, const struct tia_sum *sums)
{
    unsigned char *at = e->bytes + row * e->row_bytes;

    if (e->options->format == IMAGE_PART)
        sums_put_row(at, &e->sums, y + row, sums);
    else
        sums_develop(at, &e->sums, sums, e->film.depth);
}

/* The denoiser needs all rows. */
bool estimation_wants(const struct estimation *e, unsigned y)
{
    return e->options->denoise || tap_wants(e->options->tap, 0, y);
}

int estimation_write(struct estimation *e, unsigned y, unsigned rows)
{
    tap_rows(e->options->tap, 0, y, rows, e->bytes, e->row_bytes);
    if (tap_chooses(e->options->tap))
        return TIA_OK;
    return e->sink ? sink_write(e->sink, e->bytes, rows * e->row_bytes) : image_rows(e->image, e->bytes, rows);
}
