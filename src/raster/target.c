#include "depth.h"

#include "math/align.h"
#include "math/tile.h"
#include "target.h"

#define ALL_BUFFERS (TIA_BUFFER_DEPTH | TIA_BUFFER_STENCIL | TIA_BUFFER_COLOUR | TIA_BUFFER_SUM | TIA_BUFFER_COUNT)

/* Returns the bytes of the planes. Buffers are ordered by alignment: planes and nearness, with elements of 8 bytes,
 * come first. */
static uint64_t planes_bytes(unsigned buffers, uint32_t faces)
{
    return buffers & TIA_BUFFER_DEPTH ? (uint64_t)faces * sizeof(struct tia_raster_plane) : 0;
}

static unsigned pixel_bytes(unsigned buffers)
{
    return (buffers & TIA_BUFFER_DEPTH ? 12u : 0) + (buffers & TIA_BUFFER_SUM ? 12u : 0) +
           (buffers & TIA_BUFFER_COUNT ? 4u : 0) + (buffers & TIA_BUFFER_COLOUR ? 6u : 0) +
           (buffers & TIA_BUFFER_STENCIL ? 1u : 0);
}

size_t tia_raster_size(struct tia_tile area, unsigned buffers, uint32_t faces)
{
    uint64_t pixels = (uint64_t)area.width * area.height;
    uint64_t bytes = ALIGN(planes_bytes(buffers, faces) + pixels * pixel_bytes(buffers));

    return bytes < SIZE_MAX ? (size_t)bytes : SIZE_MAX;
}

static void place(struct tia_raster_target *t, char *memory, unsigned buffers)
{
    size_t pixels = (size_t)t->area.width * t->area.height;

    if (buffers & TIA_BUFFER_DEPTH) {
        t->planes = (struct tia_raster_plane *)(void *)memory;
        t->nearness = (uint64_t *)(void *)(memory + planes_bytes(buffers, t->face_count));
        t->face = (uint32_t *)(void *)(t->nearness + pixels);
        memory = (char *)(t->face + pixels);
    }
    if (buffers & TIA_BUFFER_SUM) {
        t->sum = (uint32_t *)(void *)memory;
        memory = (char *)(t->sum + 3 * pixels);
    }
    if (buffers & TIA_BUFFER_COUNT) {
        t->count = (uint32_t *)(void *)memory;
        memory = (char *)(t->count + pixels);
    }
    if (buffers & TIA_BUFFER_COLOUR) {
        t->colour = (uint16_t *)(void *)memory;
        memory = (char *)(t->colour + 3 * pixels);
    }
    if (buffers & TIA_BUFFER_STENCIL)
        t->stencil = (uint8_t *)memory;
}

int tia_raster_init(struct tia_raster_target *target, void *memory, size_t size, const struct tia_raster_grid *grid,
                    struct tia_tile area, unsigned buffers, uint32_t faces)
{
    static const uint16_t black[3] = {0};
    size_t needed = tia_raster_size(area, buffers, faces);

    if (!target || !grid || !tile_is_inside(area, (struct tia_tile){0, 0, grid->width, grid->height}) ||
        (buffers & (TIA_BUFFER_SUM | TIA_BUFFER_COLOUR)) == TIA_BUFFER_SUM || buffers > ALL_BUFFERS ||
        (needed && !memory_is_usable(memory)))
        return TIA_ERR_ARGUMENT;
    if (needed == SIZE_MAX || size < needed)
        return TIA_ERR_MEMORY;
    *target = (struct tia_raster_target){.grid = grid, .area = area, .face_count = faces, .pitch = area.width};
    place(target, memory, buffers);
    (void)tia_raster_clear_depth(target);
    (void)tia_raster_clear_stencil(target, 0, 255);
    (void)tia_raster_clear_count(target, 0);
    (void)tia_raster_clear_colour(target, black);
    (void)tia_raster_clear_sum(target);
    return TIA_OK;
}

#define ADVANCED(pointer, values) ((pointer) ? (pointer) + (values) : NULL)

int tia_raster_part(struct tia_raster_target *part, const struct tia_raster_target *target, struct tia_tile area)
{
    if (!part || !target || !tile_is_inside(area, target->area))
        return TIA_ERR_ARGUMENT;
    size_t skip = target_index(target, (int)area.x, (int)area.y);
    *part = *target;
    part->area = area;
    part->face = ADVANCED(target->face, skip);
    part->nearness = ADVANCED(target->nearness, skip);
    part->stencil = ADVANCED(target->stencil, skip);
    part->count = ADVANCED(target->count, skip);
    part->colour = ADVANCED(target->colour, 3 * skip);
    part->sum = ADVANCED(target->sum, 3 * skip);
    return TIA_OK;
}

#define FOR_PIXELS(t, i)                                                                                               \
    for (size_t row = 0; row < (t)->area.height; row++)                                                                \
        for (size_t i = row * (size_t)(t)->pitch, end = i + (t)->area.width; i < end; i++)

int tia_raster_clear_depth(struct tia_raster_target *target)
{
    if (!target)
        return TIA_ERR_ARGUMENT;
    if (!target->face)
        return TIA_OK;
    for (unsigned row = 0; row < target->area.height; row++) {
        uint64_t *nearness = target->nearness + (size_t)row * target->pitch;
        uint32_t *face = target->face + (size_t)row * target->pitch;
        __builtin_memset(nearness, 0, target->area.width * sizeof *nearness);
        __builtin_memset(face, 255, target->area.width * sizeof *face); /* TIA_NO_FACE */
    }
    return TIA_OK;
}

int tia_raster_clear_stencil(struct tia_raster_target *target, uint8_t value, uint8_t write)
{
    if (!target)
        return TIA_ERR_ARGUMENT;
    if (!target->stencil)
        return TIA_OK;
    FOR_PIXELS(target, i)
    {
        target->stencil[i] = (uint8_t)((target->stencil[i] & ~write) | (value & write));
    }
    return TIA_OK;
}

int tia_raster_clear_count(struct tia_raster_target *target, uint32_t value)
{
    if (!target)
        return TIA_ERR_ARGUMENT;
    if (!target->count)
        return TIA_OK;
    for (unsigned row = 0; row < target->area.height; row++) {
        uint32_t *count = target->count + (size_t)row * target->pitch;
        for (unsigned i = 0, width = target->area.width; i < width; i++)
            count[i] = value;
    }
    return TIA_OK;
}

int tia_raster_clear_colour(struct tia_raster_target *target, const uint16_t colour[3])
{
    if (!target || !colour)
        return TIA_ERR_ARGUMENT;
    if (!target->colour)
        return TIA_OK;
    FOR_PIXELS(target, i)
    {
        for (size_t c = 0; c < 3; c++)
            target->colour[3 * i + c] = colour[c];
    }
    return TIA_OK;
}

int tia_raster_clear_sum(struct tia_raster_target *target)
{
    if (!target)
        return TIA_ERR_ARGUMENT;
    if (!target->sum)
        return TIA_OK;
    FOR_PIXELS(target, i)
    {
        for (size_t c = 0; c < 3; c++)
            target->sum[3 * i + c] = 0;
    }
    return TIA_OK;
}

#define WEIGHT_MOST 65536

int tia_raster_sum_add(struct tia_raster_target *target, uint32_t weight)
{
    if (!target || weight > WEIGHT_MOST)
        return TIA_ERR_ARGUMENT;
    if (!target->sum || !target->colour)
        return TIA_OK;
    FOR_PIXELS(target, i)
    {
        for (size_t c = 0; c < 3; c++)
            target->sum[3 * i + c] += target->colour[3 * i + c] * weight;
    }
    return TIA_OK;
}

int tia_raster_sum_return(struct tia_raster_target *target, uint32_t total)
{
    if (!target || !total || total > WEIGHT_MOST)
        return TIA_ERR_ARGUMENT;
    if (!target->sum || !target->colour)
        return TIA_OK;
    FOR_PIXELS(target, i)
    {
        for (size_t c = 0; c < 3; c++)
            target->colour[3 * i + c] = (uint16_t)(((uint64_t)target->sum[3 * i + c] + total / 2) / total);
    }
    return TIA_OK;
}
