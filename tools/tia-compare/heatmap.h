/* heatmap.h - a picture of where the arithmetics differ. */
#ifndef TIA_COMPARE_HEATMAP_H
#define TIA_COMPARE_HEATMAP_H

#include "corpus/measure.h"

struct heatmap {
    unsigned width, height, core_count;
    tia_rgb565 *picture;                   /* the reference's */
    unsigned char *verdict[MEASURE_CORES]; /* enum verdict, by pixel */
};

/* Memory for a frame; false: there is none. Either way heatmap_free it. */
bool heatmap_alloc(struct heatmap *map, unsigned width, unsigned height, unsigned core_count);
void heatmap_free(struct heatmap *map);

/* For struct measure, whose arg is the heatmap. */
void heatmap_mark(void *map, unsigned core, enum verdict verdict, const struct measure_pixel *want,
                  const struct measure_pixel *got);

/* Writes `path`: for each core a panel, left to right, of the reference's picture in dark grey with
 * a square on each pixel that differs. A negative tia_status and *why ([PORT_WHY]) when it fails. */
int heatmap_write(const struct heatmap *map, const char *path, char *why);

#endif
