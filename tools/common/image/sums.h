/* sums.h - files of summed samples, .tiapart: a part of all the samples of each pixel.
 *
 *     TIASUMS1 W640 H480 N0+16 T2 E-32768 S89abcdef
 *
 * means samples 0 to 15 of each pixel of a picture of 640x480; T and E are the tone and the exposure of the finished
 * picture, as in tia/integrator.h; S is a CRC of the scene and the options. The rows follow, from the top: for each
 * pixel red, green and blue, 64 bits each, little-endian, in units of 2^-24; then, little-endian, a CRC-32: by
 * checksum_bytes of the row's number and S, 32 bits each, and continued by checksum_bytes of the row. A file that ends
 * after some row was left by an interrupted run.
 *
 * If the file has guides as well, for --denoise and --guide, the line begins with TIAGUIDE, and a row has before its
 * CRC-32 for each pixel the normal, the depth, the albedo and the sum of squares of struct tia_gathered, 64 bits each.
 */
#ifndef TOOLS_IMAGE_SUMS_H
#define TOOLS_IMAGE_SUMS_H

#include <tia/render.h>

#include "image.h"

#define SUMS_HEADER 120 /* bytes of the line and its end, at most */

struct sums {
    unsigned width, height;
    uint32_t first, count; /* first sample; number of samples */
    enum tia_tone tone;
    tia_q16 exposure;
    uint32_t crc;
    bool guided; /* the file has guides for a denoiser */
};

/* Returns the arrays from pixel number `place` on. */
static inline struct tia_gathered gathered_at(const struct tia_gathered *gathered, size_t place)
{
    struct tia_gathered from = *gathered;

    from.sums += place;
    from.guides = from.guides ? from.guides + place : NULL;
    from.squares = from.squares ? from.squares + place : NULL;
    return from;
}

/* Writes the line and its end; returns the length. */
size_t sums_print(char text[SUMS_HEADER], const struct sums *sums);

/* Parses the line and checks its numbers. Returns its length, 0 if it is not valid. */
size_t sums_parse(struct sums *sums, const char *text, size_t length);

/* Returns the number of bytes of a row in the file. */
size_t sums_row_bytes(const struct sums *sums);
/* Stores a row. */
void sums_put_row(unsigned char *bytes, const struct sums *sums, unsigned y, const struct tia_sum *row);

/* Adds a row of the file to `row`; false: its checksum is wrong, or a sum is out of range. */
bool sums_add_row(struct tia_sum *row, const struct sums *sums, unsigned y, const unsigned char *bytes);

/* Stores a row with its guides, if there are any. */
void sums_put_gathered(unsigned char *bytes, const struct sums *sums, unsigned y, const struct tia_gathered *row);
/* Reads a row with its guides; false: its checksum is wrong, or a number is out of range. */
bool sums_get_gathered(const struct tia_gathered *row, const struct sums *sums, unsigned y, const unsigned char *bytes);

/* Converts a row to one of a picture of `depth` bits a channel, see struct image_film and image_rows. */
void sums_develop(unsigned char *bytes, const struct sums *sums, const struct tia_sum *row, unsigned depth);

/* Returns the meaning of the numbers of a picture of `depth` bits a channel. */
enum image_transfer sums_transfer(const struct sums *sums, unsigned depth);

#endif
