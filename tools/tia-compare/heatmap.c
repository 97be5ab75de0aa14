#include "heatmap.h"

#include <stdlib.h>

#define REACH 2  /* half the width of a square: a single pixel of a large picture would be invisible */
#define GUTTER 4 /* white columns between two panels */

bool heatmap_alloc(struct heatmap *map, unsigned width, unsigned height, unsigned core_count)
{
    size_t count = (size_t)width * height;

    *map = (struct heatmap){.width = width, .height = height, .core_count = core_count};
    bool ok = (map->picture = malloc(count * sizeof *map->picture)) != NULL;
    for (unsigned i = 0; i < core_count; i++)
        ok &= (map->verdict[i] = calloc(count, 1)) != NULL;
    return ok;
}

void heatmap_free(struct heatmap *map)
{
    free(map->picture);
    for (unsigned i = 0; i < MEASURE_CORES; i++)
        free(map->verdict[i]);
}

void heatmap_mark(void *arg, unsigned core, enum verdict verdict, const struct measure_pixel *want,
                  const struct measure_pixel *got)
{
    struct heatmap *map = arg;

    (void)got;
    map->verdict[core][(size_t)want->y * map->width + want->x] = (unsigned char)verdict;
}

/* The worst verdict in the square around (x, y). */
static unsigned worst_near(const struct heatmap *map, unsigned core, unsigned x, unsigned y)
{
    unsigned left = x > REACH ? x - REACH : 0, top = y > REACH ? y - REACH : 0, worst = SAME;

    for (unsigned v = top; v <= y + REACH && v < map->height; v++)
        for (unsigned u = left; u <= x + REACH && u < map->width; u++) {
            unsigned verdict = map->verdict[core][(size_t)v * map->width + u];
            worst = verdict > worst ? verdict : worst;
        }
    return worst;
}

/* A quarter of the mean of the three channels; green's maximum is 63, that of the others 31. */
static tia_rgb565 dark_grey(tia_rgb565 c)
{
    unsigned level = ((c >> 11) + (c >> 6 & 31) + (c & 31u)) / 12;

    return (tia_rgb565)(level << 11 | level << 6 | level);
}

static void panel_row(const struct heatmap *map, unsigned core, unsigned y, tia_rgb565 *out)
{
    static const tia_rgb565 colours[] = {[ONE_LEVEL] = 0xffe0, [MORE] = 0xf800, [FLIP] = 0x07ff};

    for (unsigned x = 0; x < map->width; x++) {
        unsigned worst = worst_near(map, core, x, y);
        out[x] = worst != SAME ? colours[worst] : dark_grey(map->picture[(size_t)y * map->width + x]);
    }
}

int heatmap_draw(const struct heatmap *map, const char *path, char *why, struct image **sealed)
{
    unsigned stride = map->width + GUTTER, total = map->core_count * stride - GUTTER;
    struct image *image = image_create(path, IMAGE_PNG, total, map->height, why);
    tia_rgb565 *row = image ? malloc(total * sizeof *row) : NULL;

    if (!image)
        return TIA_ERR_DEVICE;
    if (!row) {
        image_discard(image);
        return TIA_ERR_MEMORY;
    }
    for (unsigned i = 0; i < total; i++)
        row[i] = 0xffff;
    for (unsigned y = 0; y < map->height; y++) {
        for (unsigned core = 0; core < map->core_count; core++)
            panel_row(map, core, y, row + core * stride);
        (void)image_band(image, row, 1);
    }
    free(row);
    int status = image_seal(image);
    *sealed = !status ? image : NULL;
    return status;
}
