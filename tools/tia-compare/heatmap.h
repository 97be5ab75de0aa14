/* heatmap.h - a picture of where the arithmetics differ. */
#ifndef TIA_COMPARE_HEATMAP_H
#define TIA_COMPARE_HEATMAP_H

#include "measure.h"

/* Memory for the map of a frame; false: there is none. Either way heatmap_free it. */
bool heatmap_alloc(struct measure_map *map, unsigned width, unsigned height, unsigned core_count);
void heatmap_free(struct measure_map *map);

/* Writes `path`: for each core a panel, left to right, of the reference's picture in dark grey with
 * a square on each pixel that differs. A negative tia_status and *why ([PORT_WHY]) when it fails. */
int heatmap_write(const struct measure_map *map, unsigned width, unsigned height, unsigned core_count, const char *path,
                  char *why);

#endif
