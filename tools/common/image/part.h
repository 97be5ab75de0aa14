/* part.h - files that can be a part of a film, read back: .tiapart and .y4m.
 *
 * A .tiapart, which may also have some rows only, is one line that says which, and its pixels.
 *
 *     TIAPART1 W640 H480 R0+120 N0+50/100 F25:1 S89abcdef
 *
 * are the rows 0 to 119 of the frames 0 to 49 of a film of 100 frames, 640x480 each, 25 a second; S is
 * image_film's crc. The pixels follow as RGB565, little endian, row by row, frame by frame. A .y4m says the
 * same behind XTIA= in its first line; and as no two of the 65536 pixels have the same Y, U and V, it holds
 * its pixels as well.
 */
#ifndef PORT_IMAGE_PART_H
#define PORT_IMAGE_PART_H

#include "image.h"

#define IMAGE_PART_HEADER 160 /* bytes that the line and its end fit in */

/* The line with its end; returns its length. */
size_t image_part_print(char text[IMAGE_PART_HEADER], const struct image_film *film);

size_t image_y4m_print(char text[IMAGE_PART_HEADER], const struct image_film *film);

/* Reads the line of either at the start of `text`, all of whose numbers must make sense, and returns its
 * length; 0 when it is none. */
size_t image_part_parse(struct image_film *film, const char *text, size_t length);
size_t image_y4m_parse(struct image_film *film, const char *text, size_t length);

#define IMAGE_Y4M_FRAME 6 /* bytes before each frame's planes: "FRAME\n" */

/* Y, U and V of a pixel, 8 bits each, Y the highest. */
uint32_t image_y4m_colour(tia_rgb565 pixel);

#endif
