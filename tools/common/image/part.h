/* part.h - reads parts of a film, .tiapart and .y4m.
 *
 * A .tiapart begins with a line that describes it; its pixels follow. It may contain only some rows of each frame.
 *
 *     TIAPART2 W640 H480 R0+120 N0+50/100 F25:1 S89abcdef
 *
 * means rows 0 to 119 of frames 0 to 49 of a film of 100 frames, 640x480 each, 25 per second; S is image_film's crc.
 * The pixels are RGB565, little-endian, row by row, frame by frame. A checksum follows each frame, four bytes,
 * little-endian. A .y4m has the same description after XTIA= in its first line, and a frame's checksum after XTIA= in
 * the frame's own line. Its pixels can be converted back, since all 65536 colours differ in Y, U or V.
 *
 * The checksum is the CRC-32 of four 32-bit numbers, little-endian, and of the frame's pixels. The numbers are the
 * frame's number in the film, the first row, the number of rows, and S, so that pixels in the wrong place are detected.
 */
#ifndef TOOLS_IMAGE_PART_H
#define TOOLS_IMAGE_PART_H

#include "film.h"

#define IMAGE_PART_HEADER 160 /* bytes of the line and its end, at most */

/* Writes the line of a .tiapart and its end; returns the length. */
size_t image_part_print(char text[IMAGE_PART_HEADER], const struct image_film *film);

/* Writes the first line of a .y4m and its end; returns the length. */
size_t image_y4m_print(char text[IMAGE_PART_HEADER], const struct image_film *film);

/* Parses the first line of a .tiapart and checks its numbers. Returns its length; 0 if it is not valid. */
size_t image_part_parse(struct image_film *film, const char *text, size_t length);

/* Parses the first line of a .y4m as image_part_parse does. */
size_t image_y4m_parse(struct image_film *film, const char *text, size_t length);

#define IMAGE_PART_SUM 4   /* bytes after each frame of a .tiapart */
#define IMAGE_Y4M_FRAME 20 /* bytes before each frame of a .y4m: "FRAME XTIA=89abcdef\n" */

/* Returns the initial value of a frame's checksum, which tia_crc32 continues with the pixels. */
uint32_t image_part_begin_sum(const struct image_film *film, uint32_t frame);

void image_part_put_sum(unsigned char bytes[IMAGE_PART_SUM], uint32_t sum);
void image_y4m_put_frame(unsigned char bytes[IMAGE_Y4M_FRAME], uint32_t sum);

/* Returns a pixel's Y, U and V, 8 bits each, Y in the highest bits. */
uint32_t image_y4m_colour(tia_rgb565 pixel);

#endif
