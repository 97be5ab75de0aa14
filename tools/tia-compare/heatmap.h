/* heatmap.h - a picture of the places where arithmetics, or techniques for shadows, differ from the reference. */
#ifndef TIA_COMPARE_HEATMAP_H
#define TIA_COMPARE_HEATMAP_H

#include "common/corpus/measure.h"
#include "common/image/image.h"

#define HEATMAP_PANELS 16

struct heatmap {
    unsigned width, height, panels;
    const tia_rgb565 *colours;              /* colour of each verdict from 1 on; verdict 0 means no difference */
    tia_rgb565 *picture;                    /* the reference's picture */
    unsigned char *verdict[HEATMAP_PANELS]; /* verdict of each pixel */
};

/* Allocates memory for a frame. Returns false if there is none. Call heatmap_free in either case. */
bool heatmap_alloc(struct heatmap *map, unsigned width, unsigned height, unsigned panels, const tia_rgb565 *colours);
void heatmap_free(struct heatmap *map);

/* The colours of enum verdict. */
extern const tia_rgb565 heatmap_verdicts[];
void heatmap_mark(void *map, unsigned core, enum verdict verdict, const struct measure_pixel *want,
                  const struct measure_pixel *got);

#define HEATMAP_MANY 1000

/* Draws `path`: for each panel, from left to right, the reference's picture in dark grey with a square on each pixel
 * that differs, or only that pixel coloured if more than HEATMAP_MANY differ. Where squares overlap, the highest
 * verdict is visible. The file appears when *sealed is published; until then `path` and `why`, [PORT_WHY] bytes, must
 * exist. Returns a negative tia_status on failure, with the reason in `why`. */
int heatmap_draw(const struct heatmap *map, const char *path, char *why, struct image **sealed);

#endif
