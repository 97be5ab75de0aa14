#include "heatmap.h"

#include <stdlib.h>

#define REACH 2  /* half the width of a square, since a single pixel of a large picture would be invisible */
#define GUTTER 4 /* white columns between two panels */

const tia_rgb565 heatmap_verdicts[] = {[ONE_LEVEL] = 0xffe0, [MORE] = 0xf800, [FLIP] = 0x07ff};

bool heatmap_alloc(struct heatmap *map, unsigned width, unsigned height, unsigned panels, const tia_rgb565 *colours)
{
    size_t count = (size_t)width * height;

    *map = (struct heatmap){.width = width, .height = height, .panels = panels, .colours = colours};
    bool ok = (map->picture = malloc(count * sizeof *map->picture)) != NULL;
    for (unsigned i = 0; i < panels; i++)
        ok &= (map->verdict[i] = calloc(count, 1)) != NULL;
    return ok;
}

void heatmap_free(struct heatmap *map)
{
    free(map->picture);
    for (unsigned i = 0; i < HEATMAP_PANELS; i++)
        free(map->verdict[i]);
}

void heatmap_mark(void *arg, unsigned core, enum verdict verdict, const struct measure_pixel *want,
                  const struct measure_pixel *got)
{
    struct heatmap *map = arg;

    (void)got;
    map->verdict[core][(size_t)want->y * map->width + want->x] = (unsigned char)verdict;
}

/* Returns the worst verdict in the square around (x, y). */
static unsigned worst_near(const struct heatmap *map, unsigned panel, unsigned reach, unsigned x, unsigned y)
{
    unsigned left = x > reach ? x - reach : 0, top = y > reach ? y - reach : 0, worst = 0;

    for (unsigned v = top; v <= y + reach && v < map->height; v++)
        for (unsigned u = left; u <= x + reach && u < map->width; u++) {
            unsigned verdict = map->verdict[panel][(size_t)v * map->width + u];
            worst = verdict > worst ? verdict : worst;
        }
    return worst;
}

/* Returns a quarter of the mean of the three channels; green's maximum is 63, that of the others 31. */
static tia_rgb565 dark_grey(tia_rgb565 c)
{
    unsigned level = ((c >> 11) + (c >> 6 & 31) + (c & 31u)) / 12;

    return (tia_rgb565)(level << 11 | level << 6 | level);
}

/* Returns half the width of the panel's squares; 0 if too many pixels differ. */
static unsigned reach_of(const struct heatmap *map, unsigned panel)
{
    size_t count = 0;

    for (size_t i = 0; i < (size_t)map->width * map->height; i++)
        count += map->verdict[panel][i] != 0;
    return count > HEATMAP_MANY ? 0 : REACH;
}

static void panel_row(const struct heatmap *map, unsigned panel, unsigned reach, unsigned y, tia_rgb565 *out)
{
    for (unsigned x = 0; x < map->width; x++) {
        unsigned worst = worst_near(map, panel, reach, x, y);
        out[x] = worst ? map->colours[worst] : dark_grey(map->picture[(size_t)y * map->width + x]);
    }
}

int heatmap_draw(const struct heatmap *map, const char *path, char *why, struct image **sealed)
{
    unsigned stride = map->width + GUTTER, total = map->panels * stride - GUTTER, reach[HEATMAP_PANELS];
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
    for (unsigned panel = 0; panel < map->panels; panel++)
        reach[panel] = reach_of(map, panel);
    for (unsigned y = 0; y < map->height; y++) {
        for (unsigned panel = 0; panel < map->panels; panel++)
            panel_row(map, panel, reach[panel], y, row + panel * stride);
        (void)image_band(image, row, 1);
    }
    free(row);
    int status = image_seal(image);
    *sealed = !status ? image : NULL;
    return status;
}
