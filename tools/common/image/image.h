/* image.h - a picture file or a film, written a band of rows at a time, whole or not at all.
 *
 * A regular file appears under its name only when image_finish succeeds: until then its bytes
 * are in a temporary file beside it. A device, a pipe or standard output ("-") is written
 * directly. The memory needed is one row and a buffer, whatever the picture's size.
 */
#ifndef PORT_IMAGE_H
#define PORT_IMAGE_H

#include <tia/fixed.h>

enum image_format { IMAGE_UNKNOWN, IMAGE_PNG, IMAGE_PPM, IMAGE_BMP, IMAGE_565, IMAGE_Y4M, IMAGE_PART };

struct image;

/* A film, of which a file holds some frames, and of each some rows: all of one frame for a picture. */
struct image_film {
    unsigned width, height;   /* of a whole frame */
    unsigned first_row, rows; /* in the file */
    uint32_t first_frame, frames;
    uint32_t all_frames; /* of the whole film */
    uint32_t rate[2];    /* frames a second: numerator, denominator */
    uint32_t crc;        /* of what is drawn, and how: the same for all parts of a film */
};

/* The format called `name` ("png"), or the one that a file's name ends in ("a.PNG"). */
enum image_format image_format_called(const char *name);
enum image_format image_format_of(const char *path);
const char *image_format_name(enum image_format format);

/* Whether this build writes `format`: without libpng, there is no IMAGE_PNG. */
bool image_format_built(enum image_format format);

/* Whether a file of `format` holds many frames. */
bool image_format_films(enum image_format format);

/* Starts the picture `path`, width x height pixels. NULL: *why ([PORT_WHY], it must last as long
 * as the image) says what failed. */
struct image *image_create(const char *path, enum image_format format, unsigned width, unsigned height, char *why);

/* Starts a file with those frames and rows of the film: their bands follow, frame by frame. */
struct image *image_create_film(const char *path, enum image_format format, const struct image_film *film, char *why);

/* Some formats begin with the lowest row: then the bands come from the last to the first. */
bool image_bottom_up(const struct image *image);

/* Whether image_discard has a file to remove: a program that is stopped must call it then. */
bool image_temporary(const struct image *image);

/* The next `count` whole rows, top row first, close together in `pixels`. Errors are kept: it
 * suffices to look at the result of image_finish. */
int image_band(struct image *image, const tia_rgb565 *pixels, unsigned count);

/* Ends the picture and frees `image`; on failure nothing stays, and *why says why. */
int image_finish(struct image *image);
void image_discard(struct image *image);

#endif
