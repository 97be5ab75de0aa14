/* parts.h - the parts of a film: read, and whether they fit together. */
#ifndef TIA_JOIN_PARTS_H
#define TIA_JOIN_PARTS_H

#include "common/image/image.h"

#define PARTS_WHY 512

struct part {
    const char *path;
    struct image_film film;
    size_t header; /* bytes before the first frame */
    bool is_y4m;
};

struct parts {
    struct part *array;
    unsigned count;
    uint64_t *colours;   /* of a .y4m: for each pixel its Y, U and V above it, in their order; NULL: not yet */
    char why[PARTS_WHY]; /* one line, after a failure */
};

/* Reads the parts' headers and checks that they are of one film, without a gap, without an overlap. 0, or -1
 * when they are not. */
int parts_open(struct parts *parts, char *const *paths, unsigned count);
void parts_close(struct parts *parts);

/* A whole frame's pixels from all parts that have rows of it. 0 or -1. */
int parts_frame(struct parts *parts, uint32_t frame, tia_rgb565 *pixels);

#endif
