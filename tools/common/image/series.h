/* series.h - where a film goes: into one file, or a picture a frame. */
#ifndef PORT_IMAGE_SERIES_H
#define PORT_IMAGE_SERIES_H

#include "image.h"

struct series {
    /* What its maker fills in; all else zero. */
    const char *name; /* with a pattern: a picture a frame */
    enum image_format format;
    struct image_film film;
    char *why; /* [PORT_WHY] */

    /* Its own. */
    struct image *image; /* of the frame now, or of the film; NULL: none */
    char *path;          /* of the frame now */
};

/* Whether a file's name has a place for the frame's number, %d or %03d. */
bool series_is_pattern(const char *name);

/* The name with the number in its place; free() it. NULL: no memory. */
char *series_path(const char *name, uint32_t frame);

/* Before and after each frame's bands, which go to series->image. A frame that has begun but not ended is
 * removed by series_discard; as is the film in one file. Negative: *why says why. */
int series_begin(struct series *series, uint32_t frame);
int series_end(struct series *series);

/* Ends the film. On failure nothing stays but the pictures of frames that were ended. */
int series_finish(struct series *series);
void series_discard(struct series *series);

#endif
