#include "stored_files.h"

#include <stdio.h>
#include <string.h>

#include "codec.h"
#include "stored_png.h"

enum { HEADER = 80, BMP_HEADER = 66 };

/* Accepts a file whose header takes `at` bytes and whose rows take the others. */
static int take(struct stored *s, uint64_t at, uint64_t stride, uint64_t length)
{
    s->at = at;
    s->stride = stride;
    if (length == at + stride * s->film.height)
        return 0;
    return stored_failed(s, "%llu bytes, not the %llu of %ux%u pixels", (unsigned long long)length,
                         (unsigned long long)(at + stride * s->film.height), s->film.width, s->film.height);
}

static bool is_size(unsigned width, unsigned height)
{
    return width && height && width <= TIA_SIZE_MAX && height <= TIA_SIZE_MAX;
}

/* Reads "P6\nW H\n255\n" or "PF\nW H\n-1.0\n", spelled as tia spells it. Returns the header's length; 0: another file.
 */
static size_t text_header(struct stored *s, const char *text, const char *magic, const char *last, const char **end)
{
    char again[HEADER];
    unsigned width, height;

    if (sscanf(text + strlen(magic), "%5u %5u", &width, &height) != 2 || !is_size(width, height))
        return 0;
    int used = snprintf(again, sizeof again, "%s%u %u\n", magic, width, height);
    *end = text + used;
    if (strncmp(text, again, (size_t)used) != 0 || strncmp(*end, last, strlen(last)) != 0)
        return 0;
    s->film.width = width;
    s->film.height = height;
    return (size_t)used + strlen(last);
}

static int open_text(struct stored *s, enum image_format format, uint64_t length)
{
    static const char *const last[] = {"255\n", "65535\n", "-1.0\n"};
    static const unsigned bits[] = {8, 16, 32};
    char text[HEADER + 1] = "";
    const char *end;
    size_t header = 0, count = length < HEADER ? (size_t)length : HEADER;
    bool floats = format == IMAGE_PFM;

    if (stored_read_at(s, text, count, 0))
        return -1;
    for (unsigned i = floats ? 2 : 0; i < (floats ? 3 : 2) && !header; i++) {
        header = count > 8 ? text_header(s, text, floats ? "PF\n" : "P6\n", last[i], &end) : 0;
        s->bits = bits[i];
    }
    s->bottom_up = floats;
    if (!header)
        return stored_failed(s, "not a .%s as tia writes it", image_format_name(format));
    return take(s, header, (uint64_t)s->film.width * 3 * s->bits / 8, length);
}

static uint32_t get32(const unsigned char *at)
{
    return (uint32_t)at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16 | (uint32_t)at[3] << 24;
}

static int open_bmp(struct stored *s, uint64_t length)
{
    unsigned char header[BMP_HEADER] = {0};

    if (stored_read_at(s, header, sizeof header, 0))
        return -1;
    s->film.width = get32(header + 18) <= TIA_SIZE_MAX ? get32(header + 18) : 0;
    s->film.height = get32(header + 22) <= TIA_SIZE_MAX ? get32(header + 22) : 0;
    if (memcmp(header, "BM", 2) != 0 || get32(header + 10) != BMP_HEADER || get32(header + 26) != (1 | 16u << 16) ||
        get32(header + 30) != 3 || get32(header + 54) != 0xf800 || get32(header + 58) != 0x07e0 ||
        get32(header + 62) != 0x001f || !is_size(s->film.width, s->film.height))
        return stored_failed(s, "not a .bmp as tia writes it");
    s->bottom_up = true;
    return take(s, BMP_HEADER, ((uint64_t)s->film.width * 2 + 3) / 4 * 4, length);
}

int stored_open_picture(struct stored *s, enum image_format format, uint64_t length)
{
    switch (format) {
    case IMAGE_PNG:
        return stored_open_png(s, length);
    case IMAGE_PPM:
    case IMAGE_PFM:
        return open_text(s, format, length);
    case IMAGE_BMP:
        return open_bmp(s, length);
    case IMAGE_565:
        return take(s, 0, (uint64_t)s->film.width * sizeof(tia_rgb565), length);
    default:
        return stored_failed(s, "such files are not verified (a .pfm has the same numbers)");
    }
}
