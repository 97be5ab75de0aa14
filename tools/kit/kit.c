/* kit.c - memory, errors, and pixels after they are drawn. */
#include "kit.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <tia/debug.h>
#include <tia/tia.h>

#include "common/scene/file.h"

static char why[SCENE_WHY];

const char *kit_version(void)
{
    return TIA_VERSION;
}

const char *kit_why(void)
{
    return why;
}

void *kit_alloc(size_t size)
{
    return malloc(size ? size : 1);
}

void kit_free(void *memory)
{
    free(memory);
}

void kit_refuse(const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    (void)vsnprintf(why, sizeof why, format, arguments);
    va_end(arguments);
}

uint32_t kit_crc(const uint16_t *pixels, uint32_t count)
{
    return tia_crc32(0, pixels, count);
}

/* Expands a pixel by bit replication. */
static void expand(uint16_t pixel, uint8_t rgb[3])
{
    unsigned r = pixel >> 11, g = pixel >> 5 & 63, b = pixel & 31;

    rgb[0] = (uint8_t)(r << 3 | r >> 2);
    rgb[1] = (uint8_t)(g << 2 | g >> 4);
    rgb[2] = (uint8_t)(b << 3 | b >> 2);
}

void kit_expand(const uint16_t *pixels, uint32_t count, uint8_t *rgb)
{
    for (size_t i = 0; i < count; i++)
        expand(pixels[i], rgb + 3 * i);
}

static int apart(uint16_t a, uint16_t b, int shift, int mask)
{
    return abs((a >> shift & mask) - (b >> shift & mask));
}

/* Draws a pixel of the picture of differences. */
static void compare_pixel(uint16_t a, uint16_t b, uint8_t rgb[3])
{
    bool far = apart(a, b, 11, 31) > 1 || apart(a, b, 5, 63) > 1 || apart(a, b, 0, 31) > 1;

    expand(a, rgb);
    uint8_t grey = (uint8_t)((rgb[0] + 2 * rgb[1] + rgb[2]) / 16);
    rgb[0] = a == b ? grey : 255;
    rgb[1] = a == b ? grey : far ? 0 : 255;
    rgb[2] = a == b ? grey : 0;
}

uint32_t kit_compare(const uint16_t *a, const uint16_t *b, uint32_t count, uint8_t *rgb)
{
    uint32_t differing = 0;

    for (size_t i = 0; i < count; i++) {
        compare_pixel(a[i], b[i], rgb + 3 * i);
        differing += a[i] != b[i];
    }
    return differing;
}
