/* sums.h - files of sums, .tiapart: for each pixel the sum of some of its samples.
 *
 *     TIASUMS1 W640 H480 N0+16 T2 E-32768 S89abcdef
 *
 * means samples 0 to 15 of each pixel of a picture of 640x480; T and E are the tone and the exposure of the finished
 * picture, as in tia/integrator.h; S is a CRC of the scene and the options. The rows follow, top row first. A row is
 * red, green and blue of each pixel, 64 bits each, little-endian, in units of 2^-24, and then a CRC-32, little-endian.
 * The CRC-32 is checksum_bytes of the row's number and S, 32 bits each, continued by checksum_bytes of the row's
 * colours. A file that ends after a row was left by an interrupted run.
 *
 * A file with guides, for --denoise and --guide, begins with TIAGUIDE instead. A row has the guides between its colours
 * and its CRC-32: for each pixel the normal, the depth, the albedo and the sum of squares of struct tia_gathered, 64
 * bits each.
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

/* Returns the arrays, beginning with pixel number `place`. */
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

/* Adds a row of the file to `row`. Returns false if its checksum is wrong, or if a sum is out of range. */
bool sums_add_row(struct tia_sum *row, const struct sums *sums, unsigned y, const unsigned char *bytes);

/* Stores a row with its guides, if there are any. */
void sums_put_gathered(unsigned char *bytes, const struct sums *sums, unsigned y, const struct tia_gathered *row);
/* Reads a row with its guides. Returns false if its checksum is wrong, or if a number is out of range. */
bool sums_get_gathered(const struct tia_gathered *row, const struct sums *sums, unsigned y, const unsigned char *bytes);

/* Converts a row to one of a picture of `depth` bits a channel, see struct image_film and image_rows. */
void sums_develop(unsigned char *bytes, const struct sums *sums, const struct tia_sum *row, unsigned depth);

/* Returns the transfer function of a picture with `depth` bits a channel. */
enum image_transfer sums_transfer(const struct sums *sums, unsigned depth);

#endif
