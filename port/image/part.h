/* part.h - a part of a picture or film (.tiapart): one line that says which, and its pixels.
 *
 *     TIAPART1 W640 H480 R0+120 N0+50/100 F25:1 S89abcdef
 *
 * are the rows 0 to 119 of the frames 0 to 49 of a film of 100 frames, 640x480 each, 25 a second; S is
 * image_film's crc. The pixels follow as RGB565, little endian, row by row, frame by frame.
 */
#ifndef PORT_IMAGE_PART_H
#define PORT_IMAGE_PART_H

#include "image/image.h"

#define IMAGE_PART_HEADER 128 /* bytes that the line and its end fit in */

/* The line with its end; returns its length. */
size_t image_part_print(char text[IMAGE_PART_HEADER], const struct image_film *film);

/* Reads the line at the start of `text`, all of whose numbers must make sense; 0 when it is none. */
size_t image_part_parse(struct image_film *film, const char *text, size_t length);

#endif
