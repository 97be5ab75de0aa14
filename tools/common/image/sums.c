#include "sums.h"

#include <stdio.h>
#include <string.h>
#include <tia/tone.h>

#include "bytes.h"
#include "common/checksum.h"

enum { CHANNEL = 8, CHECK = 4, MAGIC = 8, NUMBERS = 3 + 3 + 1 + 3 + 1 };

static const char *magic_of(const struct sums *s)
{
    return s->guided ? "TIAGUIDE" : "TIASUMS1";
}

size_t sums_print(char text[SUMS_HEADER], const struct sums *s)
{
    return (size_t)snprintf(text, SUMS_HEADER, "%s W%u H%u N%u+%u T%u E%d S%08x\n", magic_of(s), s->width, s->height,
                            (unsigned)s->first, (unsigned)s->count, (unsigned)s->tone, (int)s->exposure,
                            (unsigned)s->crc);
}

static bool is_sound(const struct sums *s)
{
    return s->width && s->height && s->width <= TIA_SIZE_MAX && s->height <= TIA_SIZE_MAX && s->count &&
           s->first <= TIA_SPP_MAX && s->count <= TIA_SPP_MAX - s->first &&
           (s->tone == TIA_TONE_LINEAR || s->tone == TIA_TONE_SRGB) && s->exposure >= -TIA_EXPOSURE_MAX &&
           s->exposure <= TIA_EXPOSURE_MAX;
}

/* Parses the line. Only the spelling of sums_print is valid: for example, no number has leading zeros. */
size_t sums_parse(struct sums *s, const char *text, size_t length)
{
    char line[SUMS_HEADER], again[SUMS_HEADER], magic[MAGIC + 1];
    const char *end = memchr(text, '\n', length < SUMS_HEADER - 1 ? length : SUMS_HEADER - 1);
    unsigned n[6];
    int exposure;

    if (!end)
        return 0;
    size_t used = (size_t)(end - text) + 1;
    memcpy(line, text, used);
    line[used] = '\0';
    if (sscanf(line, "%8s W%u H%u N%u+%u T%u E%d S%8x", magic, &n[0], &n[1], &n[2], &n[3], &n[4], &exposure, &n[5]) !=
        8)
        return 0;
    *s = (struct sums){n[0], n[1], n[2], n[3], (enum tia_tone)n[4], exposure, n[5], !strcmp(magic, "TIAGUIDE")};
    return is_sound(s) && sums_print(again, s) == used && !memcmp(again, line, used) ? used : 0;
}

size_t sums_row_bytes(const struct sums *s)
{
    return (size_t)s->width * (s->guided ? NUMBERS : 3) * CHANNEL + CHECK;
}

static uint64_t get(const unsigned char *at, unsigned bytes)
{
    uint64_t value = 0;

    for (unsigned i = 0; i < bytes; i++)
        value |= (uint64_t)at[i] << 8 * i;
    return value;
}

static uint32_t check_of(const struct sums *s, unsigned y, const unsigned char *bytes)
{
    unsigned char place[8];

    (void)put_bytes(put_bytes(place, y, 4), s->crc, 4);
    return checksum_bytes(checksum_bytes(0, place, sizeof place), bytes, sums_row_bytes(s) - CHECK);
}

/* Stores a guide in the order of the file. */
static void put_guide(unsigned char *at, const struct tia_guide *guide, uint64_t squares)
{
    for (int c = 0; c < 3; c++)
        at = put_bytes(at, (uint64_t)guide->normal[c], CHANNEL);
    at = put_bytes(at, (uint64_t)guide->depth, CHANNEL);
    for (int c = 0; c < 3; c++)
        at = put_bytes(at, (uint64_t)guide->albedo[c], CHANNEL);
    (void)put_bytes(at, squares, CHANNEL);
}

void sums_put_gathered(unsigned char *bytes, const struct sums *s, unsigned y, const struct tia_gathered *row)
{
    unsigned char *at = bytes;

    for (unsigned x = 0; x < s->width; x++)
        for (unsigned c = 0; c < 3; c++)
            at = put_bytes(at, (uint64_t)row->sums[x].rgb[c], CHANNEL);
    for (unsigned x = 0; x < s->width && s->guided; x++, at += (NUMBERS - 3) * CHANNEL)
        put_guide(at, &row->guides[x], row->squares[x]);
    (void)put_bytes(at, check_of(s, y, bytes), CHECK);
}

void sums_put_row(unsigned char *bytes, const struct sums *s, unsigned y, const struct tia_sum *row)
{
    struct tia_sum *sums = (struct tia_sum *)(uintptr_t)row; /* the sums are only read */

    sums_put_gathered(bytes, s, y, &(struct tia_gathered){.sums = sums});
}

/* Adds a row's sums. Returns true if all are in their range. */
static bool add_sums(struct tia_sum *row, const struct sums *s, const unsigned char *at)
{
    const uint64_t most = (uint64_t)s->count << 38; /* samples of up to 2^14 in units of 2^-24 */
    bool sound = true;

    for (unsigned x = 0; x < s->width; x++)
        for (unsigned c = 0; c < 3; c++, at += CHANNEL) {
            uint64_t sum = get(at, CHANNEL);
            sound = sound && sum <= most;
            row[x].rgb[c] += (int64_t)(sum <= most ? sum : 0);
        }
    return sound;
}

static bool checks(const struct sums *s, unsigned y, const unsigned char *bytes)
{
    return get(bytes + sums_row_bytes(s) - CHECK, CHECK) == check_of(s, y, bytes);
}

bool sums_add_row(struct tia_sum *row, const struct sums *s, unsigned y, const unsigned char *bytes)
{
    return add_sums(row, s, bytes) && checks(s, y, bytes);
}

/* Reads a guide. Returns false if a mean is out of range. The coordinates of normals are in -1..1 and those of albedos
 * in 0..2^14, in units of 2^-24; the depth is not negative. */
static bool get_guide(struct tia_guide *guide, uint32_t count, const unsigned char *at)
{
    const int64_t one = (int64_t)count << 24, most = (int64_t)count << 38;
    bool sound = true;

    for (int c = 0; c < 3; c++, at += CHANNEL) {
        guide->normal[c] = (int64_t)get(at, CHANNEL);
        sound = sound && guide->normal[c] >= -one && guide->normal[c] <= one;
    }
    guide->depth = (int64_t)get(at, CHANNEL);
    for (int c = 0; c < 3; c++) {
        guide->albedo[c] = (int64_t)get(at += CHANNEL, CHANNEL);
        sound = sound && guide->albedo[c] >= 0 && guide->albedo[c] <= most;
    }
    return sound && guide->depth >= 0;
}

bool sums_get_gathered(const struct tia_gathered *row, const struct sums *s, unsigned y, const unsigned char *bytes)
{
    const unsigned char *at = bytes + (size_t)s->width * 3 * CHANNEL;

    memset(row->sums, 0, s->width * sizeof *row->sums);
    bool sound = add_sums(row->sums, s, bytes) && checks(s, y, bytes);
    for (unsigned x = 0; x < s->width && s->guided && sound; x++, at += (NUMBERS - 3) * CHANNEL) {
        sound = get_guide(&row->guides[x], s->count, at);
        row->squares[x] = get(at + 7 * CHANNEL, CHANNEL);
    }
    return sound;
}

/* Stores the mean as a float. It needs no exposure, since a float has 24 significant bits at any brightness. Returns
 * the position behind it. */
static unsigned char *put_float(unsigned char *at, int64_t sum, uint32_t count)
{
    return put_float_bytes(at, (float)((double)sum / (16777216.0 * count)));
}

void sums_develop(unsigned char *bytes, const struct sums *s, const struct tia_sum *row, unsigned depth)
{
    const struct tia_exposure exposure = tia_exposure_of(s->exposure);

    for (unsigned i = 0; i < 3 * s->width; i++) {
        int64_t sum = row[i / 3].rgb[i % 3];
        uint32_t value = tia_exposed(&exposure, sum, s->count);
        if (depth == 32) {
            bytes = put_float(bytes, sum, s->count);
        } else if (depth == 16) {
            unsigned level = tia_tone_level(TIA_TONE_LINEAR, value, 16);
            *bytes++ = (unsigned char)(level >> 8);
            *bytes++ = (unsigned char)(level & 255u);
        } else {
            *bytes++ = (unsigned char)tia_tone_level(s->tone, value, 8);
        }
    }
}

enum image_transfer sums_transfer(const struct sums *s, unsigned depth)
{
    return depth == 8 && s->tone == TIA_TONE_SRGB ? IMAGE_SRGB : IMAGE_LINEAR;
}
