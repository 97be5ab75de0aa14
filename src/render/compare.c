/* compare.c - draws pixels again and compares them with those that a display shows. */
#include "renderer.h"

#include <tia/trust.h>

static void compare_row(struct tia_difference *difference, const tia_rgb565 *drawn, const tia_rgb565 *read,
                        struct tia_tile row)
{
    for (uint16_t x = 0; x < row.width; x++) {
        if (drawn[x] == read[x])
            continue;
        if (!difference->count++) {
            difference->x = (uint16_t)(row.x + x);
            difference->y = row.y;
            difference->drawn = drawn[x];
            difference->read = read[x];
        }
    }
}

/* Draws a row to `pixels`, reads it behind these, and compares. */
static int draw_and_compare(const struct tia_sealed *sealed, struct tia_tile row, bool dither,
                            const struct tia_readback *readback, tia_rgb565 *pixels, struct tia_difference *difference)
{
    const struct tia_surface surface = {
        .pixels = pixels, .step = sizeof *pixels, .pitch = (ptrdiff_t)(sizeof *pixels * row.width)};
    const struct tia_options options = {.dither = dither};
    struct tia_hits *hits;
    int status = tia_hits_init(&hits, sealed->hits, sealed->hits_size, sealed->view, row);

    if (!status)
        status = tia_view_draw(sealed->view, hits, row, &surface, &options);
    if (!status)
        status = readback->read(readback->ctx, row, pixels + row.width);
    if (!status)
        compare_row(difference, pixels, pixels + row.width, row);
    return status;
}

int tia_view_compare(const struct tia_sealed *sealed, struct tia_tile tile, bool dither,
                     const struct tia_readback *readback, tia_rgb565 *pixels, size_t count,
                     struct tia_difference *difference)
{
    struct tia_difference found = {0};

    if (!readback || !readback->read || !pixels || !tile.width || !tile.height)
        return TIA_ERR_ARGUMENT;
    if (count / 2 < tile.width)
        return TIA_ERR_MEMORY;
    int status = tia_view_check(sealed);
    for (uint32_t y = 0; y < tile.height && !status; y++) {
        const struct tia_tile row = {tile.x, (uint16_t)(tile.y + y), tile.width, 1};
        status = draw_and_compare(sealed, row, dither, readback, pixels, &found);
    }
    int checked = tia_view_check(sealed);
    if (checked)
        found.count = 0;
    if (difference)
        *difference = found;
    if (checked || status)
        return checked ? checked : status;
    return found.count ? TIA_ERR_DAMAGED : TIA_OK;
}
