/* series.h - writes a film to one file, or each frame to a picture of its own. */
#ifndef TOOLS_IMAGE_SERIES_H
#define TOOLS_IMAGE_SERIES_H

#include "image.h"

struct series {
    /* Set by the caller; all else zero. */
    const char *name; /* with a pattern for the frame's number: one picture per frame */
    enum image_format format;
    struct image_film film;
    char *why; /* receives the reason of a failure, [PORT_WHY] */

    /* Private, but readable. */
    struct image *image; /* file of the current frame or the film; NULL: none */
    char *path;          /* path of the current frame */
};

/* True if a file name has a pattern for the frame's number, %d or %03d. */
bool series_is_pattern(const char *name);

/* Returns the name with the number in place of the pattern, to be freed by free(); NULL if there is no memory. */
char *series_path(const char *name, uint32_t frame);

/* True if the file is that of the film or, with a pattern, of a frame. */
bool series_has(const char *name, const char *file);

/* Begins a frame; its bands go to series->image. Returns a negative status on failure, with the reason in `why`. */
int series_begin(struct series *series, uint32_t frame);
/* Ends a frame. Returns a negative status on failure, with the reason in `why`. */
int series_end(struct series *series);

/* Completes the film. After a failure only the pictures of finished frames are left. */
int series_finish(struct series *series);
/* Removes an unfinished frame, or the film if it is one file. */
void series_discard(struct series *series);

#endif
