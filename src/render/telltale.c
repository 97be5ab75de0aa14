/* telltale.c - compares rectangles of a picture with CRCs that were computed when the program was built. */
#include "math/tile.h"

#include <tia/debug.h>
#include <tia/trust.h>

static bool is_usable(const struct tia_telltales *all)
{
    return all && all->telltales && all->telltale_count && (all->keys || !all->key_count);
}

/* Adds the pixels of a row, from the tile's surface. */
static void add_row(struct tia_telltale_sum *sum, struct tia_tile area, uint32_t y, struct tia_tile tile,
                    const struct tia_surface *surface)
{
    const char *at = (const char *)surface->pixels + (ptrdiff_t)(y - tile.y) * surface->pitch +
                     (ptrdiff_t)(area.x - tile.x) * surface->step;

    if (surface->step == sizeof(tia_rgb565) && !surface_swaps(surface))
        sum->crc = tia_crc32(sum->crc, (const tia_rgb565 *)(const void *)at, area.width);
    else
        for (uint16_t x = 0; x < area.width; x++, at += surface->step) {
            tia_rgb565 pixel = surface_order(surface, *(const tia_rgb565 *)(const void *)at);
            sum->crc = tia_crc32(sum->crc, &pixel, 1);
        }
    sum->rows++;
}

/* Adds the rows of one telltale that are in the tile; false if they are not the next ones, or not whole. */
static bool add(struct tia_tile area, struct tia_telltale_sum *sum, struct tia_tile tile,
                const struct tia_surface *surface)
{
    uint32_t right = (uint32_t)tile.x + tile.width, bottom = (uint32_t)tile.y + tile.height;
    uint32_t area_right = (uint32_t)area.x + area.width, area_bottom = (uint32_t)area.y + area.height;
    uint32_t first = tile.y > area.y ? tile.y : area.y, end = bottom < area_bottom ? bottom : area_bottom;

    if (first >= end || tile.x >= area_right || right <= area.x)
        return true;
    if (first == area.y)
        *sum = (struct tia_telltale_sum){0, 0};
    if (tile.x > area.x || right < area_right || first - area.y != sum->rows) {
        *sum = (struct tia_telltale_sum){0, 0};
        return false;
    }
    for (uint32_t y = first; y < end; y++)
        add_row(sum, area, y, tile, surface);
    return true;
}

int tia_telltales_add(const struct tia_telltales *all, struct tia_telltale_sum *sums, struct tia_tile tile,
                      const struct tia_surface *surface)
{
    bool fine = true;

    if (!is_usable(all) || !sums || !surface_is_usable(surface) ||
        !tile_is_inside(tile, (struct tia_tile){0, 0, all->width, all->height}))
        return TIA_ERR_ARGUMENT;
    for (uint32_t i = 0; i < all->telltale_count; i++)
        fine = add(all->telltales[i].area, &sums[i], tile, surface) && fine;
    return fine ? TIA_OK : TIA_ERR_ARGUMENT;
}

int tia_telltales_check(const struct tia_telltales *all, struct tia_telltale_sum *sums, uint32_t state, uint32_t *wrong)
{
    int status = TIA_OK;

    if (!is_usable(all) || !sums || state > all->key_count)
        return TIA_ERR_ARGUMENT;
    for (uint32_t i = 0; i < all->telltale_count; i++) {
        const struct tia_telltale *telltale = &all->telltales[i];
        bool right = sums[i].rows == telltale->area.height && sums[i].crc == telltale->crcs[state];
        if (!right && !status && wrong)
            *wrong = i;
        status = right ? status : TIA_ERR_DAMAGED;
        sums[i] = (struct tia_telltale_sum){0, 0};
    }
    return status;
}
