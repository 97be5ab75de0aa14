/* stored_file.h - an open picture or film as tia has written it, of which stored.h reads rows. */
#ifndef TOOLS_IMAGE_STORED_FILE_H
#define TOOLS_IMAGE_STORED_FILE_H

#include "image.h"
#include "parts.h"
#include "sums.h"

#define STORED_WHY 512

struct stored {
    const char *path;
    enum image_format format; /* of a picture; IMAGE_PART also for .y4m and sums */
    struct image_film film;   /* of a part: its film; of a picture: its size, and the depth of stored_depth */
    unsigned bits;            /* bits of a channel in the file; 0: RGB565 */
    bool is_part, is_sums;
    struct parts parts;
    struct sums sums;

    /* Private. */
    int fd;
    uint64_t at, stride; /* offset of the first row, and bytes from one row to the next */
    bool bottom_up;
    unsigned char *pixels; /* of a .png: all rows */
    unsigned char *line;   /* a row of the file */
    char why[STORED_WHY];  /* reason of a failure, one line */
};

/* Writes the reason, after the file's name. Returns -1. */
__attribute__((format(printf, 2, 3))) int stored_failed(struct stored *stored, const char *format, ...);

/* Reads bytes of the open file. Returns 0, or -1 on failure. */
int stored_read_at(struct stored *stored, void *bytes, size_t count, uint64_t offset);

#endif
