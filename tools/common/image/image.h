/* image.h - writes a picture or film file, a band of rows at a time; the file appears complete or not at all.
 *
 * A regular file gets its name only when image_finish succeeds; until then it is a temporary file in the same
 * directory. A device, a pipe or standard output ("-") is written directly. Memory is needed for a buffer and one row,
 * or one frame of a .y4m, whatever the picture's size.
 */
#ifndef TOOLS_IMAGE_H
#define TOOLS_IMAGE_H

#include "film.h"

struct image;

/* Returns the format called `name` ("png"). */
enum image_format image_format_called(const char *name);
/* Returns the format of a file by its extension ("a.PNG"). */
enum image_format image_format_of(const char *path);
const char *image_format_name(enum image_format format);

/* True if this build can write `format`: IMAGE_PNG needs libpng. */
bool image_format_built(enum image_format format);

/* True if a file of `format` can hold many frames. */
bool image_format_films(enum image_format format);

/* Starts the picture `path`, width x height pixels. NULL on failure, with the reason in `why`, [PORT_WHY] bytes that
 * must outlive the image. */
struct image *image_create(const char *path, enum image_format format, unsigned width, unsigned height, char *why);

/* Starts a file with the given frames and rows of a film, frame by frame. Returns as image_create. */
struct image *image_create_film(const char *path, enum image_format format, const struct image_film *film, char *why);

/* True if the format stores the bottom row first. The last band must then be written first. */
bool image_bottom_up(const struct image *image);

/* Writes the next `count` full rows, top row first, without gaps in `pixels`. Errors are stored; checking image_finish
 * is enough. */
int image_band(struct image *image, const tia_rgb565 *pixels, unsigned count);

/* True if a file of `format` can have `depth` bits a channel, see struct image_film. */
bool image_format_has(enum image_format format, unsigned depth);

/* Writes rows of a picture with a `depth` of 8, 16 or 32 bits: width x 3 numbers each. Numbers of 16 bits are
 * big-endian, those of 32 bits little-endian. */
int image_rows(struct image *image, const unsigned char *bytes, unsigned count);

/* Minimises the time spent on compression from the next row on. */
void image_hurry(struct image *image);

/* Completes the picture and frees `image`. After a failure no file is left, and `why` has the reason. */
int image_finish(struct image *image);

/* Completes the picture under its temporary name, so that several pictures can appear together. Frees `image` on
 * failure. */
int image_seal(struct image *image);
/* Gives a sealed picture its name, and frees `image`. */
int image_publish(struct image *image);

void image_discard(struct image *image);

#endif
