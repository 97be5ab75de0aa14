#include "heatmap.h"

#include <stdlib.h>

#include "image/image.h"

#define REACH 2  /* a square's half width: a lone pixel of a large picture would not be seen */
#define GUTTER 4 /* white columns between two panels */

bool heatmap_alloc(struct measure_map *map, unsigned width, unsigned height, unsigned core_count)
{
    size_t count = (size_t)width * height;
    bool ok = (map->picture = malloc(count * sizeof *map->picture)) != NULL;

    for (unsigned i = 0; i < MEASURE_CORES; i++)
        map->verdict[i] = NULL;
    for (unsigned i = 0; i < core_count; i++)
        ok &= (map->verdict[i] = malloc(count)) != NULL;
    return ok;
}

void heatmap_free(struct measure_map *map)
{
    free(map->picture);
    for (unsigned i = 0; i < MEASURE_CORES; i++)
        free(map->verdict[i]);
}

/* The worst verdict in the square around (x, y). */
static unsigned worst_near(const unsigned char *verdict, unsigned width, unsigned height, unsigned x, unsigned y)
{
    unsigned left = x > REACH ? x - REACH : 0, top = y > REACH ? y - REACH : 0, worst = SAME;

    for (unsigned v = top; v <= y + REACH && v < height; v++)
        for (unsigned u = left; u <= x + REACH && u < width; u++)
            if (verdict[(size_t)v * width + u] > worst)
                worst = verdict[(size_t)v * width + u];
    return worst;
}

/* A quarter of the mean of the three channels: green counts 63, the others 31. */
static tia_rgb565 dark_grey(tia_rgb565 c)
{
    unsigned level = ((c >> 11) + (c >> 6 & 31) + (c & 31u)) / 12;

    return (tia_rgb565)(level << 11 | level << 6 | level);
}

static void panel_row(const struct measure_map *map, unsigned core, unsigned width, unsigned height, unsigned y,
                      tia_rgb565 *out)
{
    static const tia_rgb565 colours[] = {[ONE_LEVEL] = 0xffe0, [MORE] = 0xf800, [FLIP] = 0x07ff};

    for (unsigned x = 0; x < width; x++) {
        unsigned worst = worst_near(map->verdict[core], width, height, x, y);
        out[x] = worst != SAME ? colours[worst] : dark_grey(map->picture[(size_t)y * width + x]);
    }
}

int heatmap_write(const struct measure_map *map, unsigned width, unsigned height, unsigned core_count, const char *path,
                  char *why)
{
    unsigned stride = width + GUTTER, total = core_count * stride - GUTTER;
    struct image *image = image_create(path, IMAGE_PNG, total, height, why);
    tia_rgb565 *row = image != NULL ? malloc(total * sizeof *row) : NULL;

    if (image == NULL)
        return TIA_ERR_DEVICE;
    if (row == NULL) {
        image_discard(image);
        return TIA_ERR_MEMORY;
    }
    for (unsigned i = 0; i < total; i++)
        row[i] = 0xffff;
    for (unsigned y = 0; y < height; y++) {
        for (unsigned core = 0; core < core_count; core++)
            panel_row(map, core, width, height, y, row + core * stride);
        (void)image_band(image, row, 1);
    }
    free(row);
    return image_finish(image);
}
