/* parts.h - reads the parts of a film and checks that they fit together. */
#ifndef TOOLS_IMAGE_PARTS_H
#define TOOLS_IMAGE_PARTS_H

#include "image.h"

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
/* Reads the headers of a single file, which may lack rows of its film. Returns as parts_open. */
int parts_read(struct parts *parts, const char *path);
void parts_close(struct parts *parts);

/* Returns the number of rows of all frames in all parts. */
uint64_t parts_rows(const struct parts *parts);
/* Returns the part with that row of a frame; NULL: none. */
const struct part *parts_find(const struct parts *parts, uint32_t frame, unsigned row);

/* Reads row `y` of a frame, both in the part, whose file is open, without verifying the frame's checksum. Returns 0, or
 * -1 on failure. */
int parts_row(struct parts *parts, const struct part *part, int fd, uint32_t frame, unsigned y, tia_rgb565 *pixels);

/* Reads the pixels of a whole frame from all parts that have rows of it. Returns 0, or -1 on failure. */
int parts_frame(struct parts *parts, uint32_t frame, tia_rgb565 *pixels);

#endif
