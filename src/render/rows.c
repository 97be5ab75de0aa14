/* rows.c - a picture row by row. */
#include <tia/rows.h>

#include "math/align.h"
#include "math/tile.h"

/* Offsets in the caller's memory, which begins with the view. */
struct layout {
    size_t hits, pixels, end; /* of a part of a row, of a row, and the number of bytes */
};

static bool is_valid(const struct tia_rows *rows)
{
    return rows && rows->core && rows->scene && rows->width - 1u < TIA_SIZE_MAX && rows->height - 1u < TIA_SIZE_MAX &&
           (rows->lights || !rows->light_count);
}

static uint32_t light_capacity(const struct tia_rows *rows)
{
    uint32_t own = rows->scene->light_count;

    return rows->light_count > own ? rows->light_count : own;
}

/* Returns the part of row y from column x on. */
static struct tia_tile part_at(const struct tia_rows *rows, unsigned x, unsigned y)
{
    unsigned most = rows->columns ? rows->columns : rows->width, rest = rows->width - x;

    return (struct tia_tile){(uint16_t)x, (uint16_t)y, (uint16_t)(rest < most ? rest : most), 1};
}

/* Returns a + b rounded up to a multiple of 2 or 8; SIZE_MAX when it does not fit. */
static size_t sum(size_t a, size_t b, size_t multiple)
{
    return a > SIZE_MAX - multiple || b > SIZE_MAX - multiple - a ? SIZE_MAX
                                                                  : (a + b + multiple - 1) / multiple * multiple;
}

static struct layout layout_of(const struct tia_rows *rows)
{
    const struct tia_core *core = rows->core;
    struct layout layout;

    layout.hits = sum(0, core->view_size(core, rows->scene, light_capacity(rows)), 8);
    layout.pixels = sum(layout.hits, core->hits_size(core, rows->scene, part_at(rows, 0, 0)), sizeof(tia_rgb565));
    layout.end = sum(layout.pixels, rows->width * sizeof(tia_rgb565), sizeof(tia_rgb565));
    return layout;
}

size_t tia_draw_rows_size(const struct tia_rows *rows)
{
    return is_valid(rows) ? layout_of(rows).end : SIZE_MAX;
}

static int prepare(const struct tia_rows *rows, void *memory, size_t size, struct tia_view **view)
{
    int status = rows->core->view_init(rows->core, view, memory, size, rows->scene, light_capacity(rows), rows->width,
                                       rows->height, NULL);

    return status || !rows->lights ? status : tia_view_set_lights(*view, rows->lights, rows->light_count);
}

static INLINED bool rows_swap(const struct tia_rows *rows)
{
#if TIA_SWAP
    return rows->swap;
#else
    (void)rows;
    return false;
#endif
}

static int draw_row(const struct tia_rows *rows, struct tia_view *view, void *memory, const struct layout *layout,
                    unsigned y)
{
    const struct tia_options options = {.dither = rows->dither};
    struct tia_surface surface = {.step = sizeof(tia_rgb565), .pitch = sizeof(tia_rgb565)};
    int status = TIA_OK;

    surface_set_swap(&surface, rows_swap(rows));
    surface.pixels = (tia_rgb565 *)(void *)((char *)memory + layout->pixels);
    for (unsigned x = 0; x < rows->width && !status;) {
        struct tia_tile part = part_at(rows, x, y);
        struct tia_hits *hits;
        status = tia_hits_init(&hits, (char *)memory + layout->hits, layout->pixels - layout->hits, view, part);
        if (!status)
            status = tia_view_draw(view, hits, part, &surface, &options);
        surface.pixels += part.width;
        x += part.width;
    }
    return status;
}

int tia_draw_rows(const struct tia_rows *rows, void *memory, size_t size,
                  int (*row)(void *ctx, unsigned y, const tia_rgb565 *pixels, unsigned width), void *ctx)
{
    struct tia_view *view;

    if (!is_valid(rows) || !memory_is_usable(memory) || !row)
        return TIA_ERR_ARGUMENT;
    int status = prepare(rows, memory, size, &view); /* first: only a scene that it accepts has sizes */
    if (status)
        return status;
    const struct layout layout = layout_of(rows);
    if (size < layout.end)
        return TIA_ERR_MEMORY;
    for (unsigned y = 0; y < rows->height && !status; y++) {
        status = draw_row(rows, view, memory, &layout, y);
        if (!status)
            status = row(ctx, y, (const tia_rgb565 *)(const void *)((const char *)memory + layout.pixels), rows->width);
    }
    return status;
}
