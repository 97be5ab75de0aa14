/* parts.h - reads the parts of a film and checks that they fit together. */
#ifndef TIA_JOIN_PARTS_H
#define TIA_JOIN_PARTS_H

#include "common/image/image.h"

#define PARTS_WHY 512

struct part {
    const char *path;
    struct image_film film;
    uint64_t frames; /* offset of the first frame in the file */
    bool is_y4m;
};

struct parts {
    struct part *array;
    unsigned count, capacity;
    uint64_t *colours;   /* for .y4m: for each pixel value its Y, U and V, and the pixel in the lowest 16 bits; sorted.
                            NULL: not built yet */
    char why[PARTS_WHY]; /* reason of a failure, one line */
};

/* Reads the parts' headers, also those of several parts in one .tiapart. Checks that the parts make one film, without
 * gaps or overlaps. Returns 0, or -1 if they do not. */
int parts_open(struct parts *parts, char *const *paths, unsigned count);
void parts_close(struct parts *parts);

/* Reads the pixels of a whole frame from all parts that have rows of it. Returns 0, or -1 on failure. */
int parts_frame(struct parts *parts, uint32_t frame, tia_rgb565 *pixels);

#endif
