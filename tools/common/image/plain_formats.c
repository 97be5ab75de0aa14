/* plain_formats.c - the formats that need no library: PPM, BMP and raw RGB565. */
#include <stdio.h>

#include "bytes.h"
#include "codec.h"

static void nothing(struct image *image)
{
    (void)image;
}

static int done(struct image *image)
{
    (void)image;
    return TIA_OK;
}

void image_expand(unsigned char *rgb, const tia_rgb565 *pixels, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        unsigned r = pixels[i] >> 11, g = pixels[i] >> 5 & 63u, b = pixels[i] & 31u;
        *rgb++ = (unsigned char)(r << 3 | r >> 2);
        *rgb++ = (unsigned char)(g << 2 | g >> 4);
        *rgb++ = (unsigned char)(b << 3 | b >> 2);
    }
}

/* ---- PPM, binary (P6), 255 levels ---- */

int image_put_bytes(struct image *image, const unsigned char *row)
{
    return sink_write(&image->sink, row, (size_t)image->width * 3 * image->film.depth / 8);
}

static int ppm_begin(struct image *image)
{
    char header[40];
    int length = snprintf(header, sizeof header, "P6\n%u %u\n%u\n", image->width, image->height,
                          image->film.depth == 16 ? 65535u : 255u);
    return sink_write(&image->sink, header, (size_t)length);
}

static int ppm_row(struct image *image, const tia_rgb565 *pixels)
{
    image_expand(image->line, pixels, image->width);
    return sink_write(&image->sink, image->line, (size_t)image->width * 3);
}

const struct image_codec image_codec_ppm = {
    .name = "ppm", .begin = ppm_begin, .row = ppm_row, .bytes = image_put_bytes, .end = done, .free = nothing};

/* ---- PFM: floats, little-endian, the bottom row first ---- */

static int pfm_begin(struct image *image)
{
    char header[40];
    int length = snprintf(header, sizeof header, "PF\n%u %u\n-1.0\n", image->width, image->height);
    return sink_write(&image->sink, header, (size_t)length);
}

const struct image_codec image_codec_pfm = {
    .name = "pfm", .bottom_up = true, .begin = pfm_begin, .bytes = image_put_bytes, .end = done, .free = nothing};

/* ---- RGB565, little-endian, row by row ---- */

size_t image_put565(unsigned char *line, const tia_rgb565 *pixels, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        line[2 * i] = (unsigned char)(pixels[i] & 255u);
        line[2 * i + 1] = (unsigned char)(pixels[i] >> 8);
    }
    return 2 * count;
}

static int raw_row(struct image *image, const tia_rgb565 *pixels)
{
    size_t bytes = image_put565(image->line, pixels, image->width);
    return sink_write(&image->sink, image->line, bytes);
}

const struct image_codec image_codec_565 = {.name = "565", .begin = done, .row = raw_row, .end = done, .free = nothing};

/* ---- BMP: a BITMAPFILEHEADER, a BITMAPINFOHEADER and three masks (BI_BITFIELDS), then 16 bits per pixel, the bottom
 *      row first, each row padded to 4 bytes ---- */

enum { BMP_FILE_HEADER = 14, BMP_INFO_HEADER = 40, BMP_HEADER = BMP_FILE_HEADER + BMP_INFO_HEADER + 3 * 4 };
enum { BMP_BITFIELDS = 3, BMP_DOTS_PER_METRE = 2835 }; /* 72 dpi, the customary value */

static size_t bmp_pitch(unsigned width)
{
    return ((size_t)width * 2 + 3) / 4 * 4;
}

static int bmp_begin(struct image *image)
{
    uint32_t bytes = (uint32_t)(bmp_pitch(image->width) * image->height);
    unsigned char header[BMP_HEADER] = {'B', 'M'};
    (void)put_bytes(header + 2, BMP_HEADER + bytes, 4);
    (void)put_bytes(header + 10, BMP_HEADER, 4);
    (void)put_bytes(header + 14, BMP_INFO_HEADER, 4);
    (void)put_bytes(header + 18, image->width, 4);
    (void)put_bytes(header + 22, image->height, 4);
    (void)put_bytes(header + 26, 1 | 16u << 16, 4); /* one plane, 16 bits per pixel */
    (void)put_bytes(header + 30, BMP_BITFIELDS, 4);
    (void)put_bytes(header + 34, bytes, 4);
    (void)put_bytes(header + 38, BMP_DOTS_PER_METRE, 4);
    (void)put_bytes(header + 42, BMP_DOTS_PER_METRE, 4);
    (void)put_bytes(header + 54, 0xf800, 4);
    (void)put_bytes(header + 58, 0x07e0, 4);
    (void)put_bytes(header + 62, 0x001f, 4);
    return sink_write(&image->sink, header, sizeof header);
}

static int bmp_row(struct image *image, const tia_rgb565 *pixels)
{
    size_t bytes = image_put565(image->line, pixels, image->width);
    while (bytes < bmp_pitch(image->width))
        image->line[bytes++] = 0;
    return sink_write(&image->sink, image->line, bytes);
}

const struct image_codec image_codec_bmp = {
    .name = "bmp", .bottom_up = true, .begin = bmp_begin, .row = bmp_row, .end = done, .free = nothing};
