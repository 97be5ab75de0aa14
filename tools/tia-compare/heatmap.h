/* heatmap.h - a picture of where the arithmetics differ. */
#ifndef TIA_COMPARE_HEATMAP_H
#define TIA_COMPARE_HEATMAP_H

#include "common/image/image.h"
#include "corpus/measure.h"

struct heatmap {
    unsigned width, height, core_count;
    tia_rgb565 *picture;                   /* the reference's */
    unsigned char *verdict[MEASURE_CORES]; /* enum verdict, by pixel */
};

/* Allocates memory for a frame; false: no memory. Call heatmap_free in either case. */
bool heatmap_alloc(struct heatmap *map, unsigned width, unsigned height, unsigned core_count);
void heatmap_free(struct heatmap *map);

/* The callback of struct measure; its arg is the heatmap. */
void heatmap_mark(void *map, unsigned core, enum verdict verdict, const struct measure_pixel *want,
                  const struct measure_pixel *got);

/* Draws `path`: for each core, from left to right, the reference's picture in dark grey with a square on each pixel
 * that differs. It appears when *sealed is published; `path` and `why`, [PORT_WHY] bytes, must outlive that. A negative
 * tia_status on failure, with the reason in `why`. */
int heatmap_draw(const struct heatmap *map, const char *path, char *why, struct image **sealed);

#endif
