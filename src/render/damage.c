/* damage.c - compares pixels with those that a display shows. */
#include "math/fast.h"

#include <tia/damage.h>

#include "math/tile.h"

/* The pixels of a part of a row. */
struct part {
    const char *pixels;
    ptrdiff_t step;
    unsigned count;
};

/* The changed columns of a part: first..end-1, none if first is not below end. */
struct changes {
    unsigned first, end;
};

static tia_rgb565 pixel_at(const char *pixel)
{
    return *(const tia_rgb565 *)(const void *)pixel;
}

static size_t size_of(unsigned width, unsigned height, unsigned shift)
{
    uint64_t columns = ((uint64_t)width + (1u << shift) - 1) >> shift;
    uint64_t size = height * (columns * sizeof(tia_rgb565) + (shift ? (columns + 7) / 8 : 0));

    return size < SIZE_MAX ? (size_t)size : SIZE_MAX;
}

static bool is_picture(unsigned width, unsigned height)
{
    return width - 1 < TIA_SIZE_MAX && height - 1 < TIA_SIZE_MAX;
}

size_t tia_damage_size(unsigned width, unsigned height, unsigned block)
{
    unsigned shift = 0;

    while (1u << shift < TIA_DAMAGE_BLOCK_MAX && block > 1u << shift)
        shift++;
    return is_picture(width, height) && block == 1u << shift ? size_of(width, height, shift) : SIZE_MAX;
}

int tia_damage_init(struct tia_damage *damage, void *memory, size_t size, unsigned width, unsigned height)
{
    const struct tia_surface probe = {.pixels = memory};
    unsigned shift = 0;

    if (!damage || !surface_is_usable(&probe) || !is_picture(width, height))
        return TIA_ERR_ARGUMENT;
    while (size_of(width, height, shift) > size)
        if (1u << ++shift > TIA_DAMAGE_BLOCK_MAX)
            return TIA_ERR_MEMORY;
    damage->colours = memory;
    damage->width = (uint16_t)width;
    damage->height = (uint16_t)height;
    damage->columns = (uint16_t)((width + (1u << shift) - 1) >> shift);
    damage->plain = shift ? (uint8_t *)(damage->colours + (size_t)damage->columns * height) : NULL;
    damage->shift = (uint8_t)shift;
    damage->complete = false;
    return TIA_OK;
}

void tia_damage_complete(struct tia_damage *damage)
{
    if (damage)
        damage->complete = true;
}

void tia_damage_forget(struct tia_damage *damage)
{
    if (damage)
        damage->complete = false;
}

/* ---- single pixels ---- */

/* Replaces the pixels that are shown between the first and the last changed one. */
static struct changes update_pixels(tia_rgb565 *shown, const struct part *part)
{
    const char *pixel = part->pixels, *last = pixel + (ptrdiff_t)(part->count - 1) * part->step;
    struct changes changes = {0, part->count};

    for (; changes.first < changes.end && pixel_at(pixel) == shown[changes.first]; pixel += part->step)
        changes.first++;
    for (; changes.first < changes.end && pixel_at(last) == shown[changes.end - 1]; last -= part->step)
        changes.end--;
    for (unsigned i = changes.first; i < changes.end; i++, pixel += part->step)
        shown[i] = pixel_at(pixel);
    return changes;
}

/* ---- blocks ---- */

static bool is_plain(const char *pixel, ptrdiff_t step, unsigned count)
{
    tia_rgb565 first = pixel_at(pixel);

    while (--count) {
        pixel += step;
        if (pixel_at(pixel) != first)
            return false;
    }
    return true;
}

/* Updates a block of which the part has some or all pixels. True if they may have changed. */
static bool update_block(tia_rgb565 *colour, uint8_t *plain, uint8_t bit, const struct part *part, bool whole,
                         bool known)
{
    bool one_colour = is_plain(part->pixels, part->step, part->count);
    tia_rgb565 first = pixel_at(part->pixels);

    if (one_colour && known && *plain & bit && *colour == first)
        return false;
    *colour = first;
    *plain = (uint8_t)(one_colour && whole ? *plain | bit : *plain & ~bit);
    return true;
}

/* Updates the blocks of row y from column x on. */
static struct changes update_blocks(struct tia_damage *damage, unsigned x, unsigned y, const struct part *part)
{
    uint8_t *plain = damage->plain + (size_t)y * ((damage->columns + 7u) / 8);
    tia_rgb565 *colours = damage->colours + (size_t)y * damage->columns;
    struct changes changes = {part->count, 0};
    struct part block = *part;

    for (unsigned i = 0; i < part->count; i += block.count) {
        unsigned column = (x + i) >> damage->shift, first = column << damage->shift;
        unsigned end = first + (1u << damage->shift) < damage->width ? first + (1u << damage->shift) : damage->width;
        block.count = end - (x + i) < part->count - i ? end - (x + i) : part->count - i;
        if (update_block(&colours[column], &plain[column / 8], (uint8_t)(1u << column % 8), &block,
                         block.count == end - first, damage->complete)) {
            changes.first = i < changes.first ? i : changes.first;
            changes.end = i + block.count;
        }
        block.pixels += (ptrdiff_t)block.count * part->step;
    }
    return changes;
}

/* ---- tiles ---- */

static bool is_usable(const struct tia_damage *damage, struct tia_tile tile, const struct tia_surface *surface)
{
    return damage && surface_is_usable(surface) &&
           tile_is_inside(tile, (struct tia_tile){.width = damage->width, .height = damage->height});
}

bool tia_damage_update(struct tia_damage *damage, struct tia_tile tile, const struct tia_surface *surface,
                       struct tia_tile *changed)
{
    struct changes all = {tile.width, 0};
    unsigned top = tile.height, bottom = 0;

    if (!is_usable(damage, tile, surface) || !changed)
        return false;
    for (unsigned y = 0; y < tile.height; y++) {
        const struct part part = {(const char *)surface->pixels + (ptrdiff_t)y * surface->pitch, surface->step,
                                  tile.width};
        struct changes row =
            damage->plain ? update_blocks(damage, tile.x, tile.y + y, &part)
                          : update_pixels(damage->colours + (size_t)(tile.y + y) * damage->width + tile.x, &part);
        if (!damage->complete)
            row = (struct changes){0, tile.width};
        if (row.first >= row.end)
            continue;
        top = top < y ? top : y;
        bottom = y + 1;
        all.first = row.first < all.first ? row.first : all.first;
        all.end = row.end > all.end ? row.end : all.end;
    }
    if (bottom)
        *changed = (struct tia_tile){(uint16_t)(tile.x + all.first), (uint16_t)(tile.y + top),
                                     (uint16_t)(all.end - all.first), (uint16_t)(bottom - top)};
    return bottom != 0;
}
