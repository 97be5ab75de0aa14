/* part.h - reads parts of a film, .tiapart and .y4m.
 *
 * A .tiapart has a line that describes it, and then its pixels. It may have only some rows of each frame.
 *
 *     TIAPART1 W640 H480 R0+120 N0+50/100 F25:1 S89abcdef
 *
 * means rows 0 to 119 of frames 0 to 49 of a film of 100 frames, 640x480 each, 25 per second; S is image_film's
 * crc. The pixels follow as RGB565, little-endian, row by row, frame by frame. A .y4m has the same description after
 * XTIA= in its first line. Its pixels can be read back too, since all 65536 pixels differ in Y, U or V.
 */
#ifndef PORT_IMAGE_PART_H
#define PORT_IMAGE_PART_H

#include "film.h"

#define IMAGE_PART_HEADER 160 /* bytes, enough for the line and its end */

/* Writes the line and its end; returns the length. */
size_t image_part_print(char text[IMAGE_PART_HEADER], const struct image_film *film);

size_t image_y4m_print(char text[IMAGE_PART_HEADER], const struct image_film *film);

/* Reads the first line of either file from `text` and checks its numbers. Returns its length, 0 if it is not valid. */
size_t image_part_parse(struct image_film *film, const char *text, size_t length);
size_t image_y4m_parse(struct image_film *film, const char *text, size_t length);

#define IMAGE_Y4M_FRAME 6 /* bytes before each frame's planes: "FRAME\n" */

/* Y, U and V of a pixel, 8 bits each, Y in the highest bits. */
uint32_t image_y4m_colour(tia_rgb565 pixel);

#endif
