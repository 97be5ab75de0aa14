#include "expand.h"

#include <stdio.h>
#include <string.h>

const struct pixel_format pixel_rgb565 = {16, false, {11, 5}, {5, 6}, {0, 5}, {0, 0}};
const struct pixel_format pixel_bgr565 = {16, false, {0, 5}, {5, 6}, {11, 5}, {0, 0}};
const struct pixel_format pixel_xrgb8888 = {32, false, {16, 8}, {8, 8}, {0, 8}, {0, 0}};
const struct pixel_format pixel_xbgr8888 = {32, false, {0, 8}, {8, 8}, {16, 8}, {0, 0}};

static const struct {
    const char *name;
    struct pixel_format format; /* without alpha, in the processor's byte order */
} named[] = {
    {"RGB565", {16, false, {11, 5}, {5, 6}, {0, 5}, {0, 0}}},
    {"BGR565", {16, false, {0, 5}, {5, 6}, {11, 5}, {0, 0}}},
    {"RGB555", {16, false, {10, 5}, {5, 5}, {0, 5}, {0, 0}}},
    {"BGR555", {16, false, {0, 5}, {5, 5}, {10, 5}, {0, 0}}},
    {"RGB888", {24, false, {16, 8}, {8, 8}, {0, 8}, {0, 0}}},
    {"BGR888", {24, false, {0, 8}, {8, 8}, {16, 8}, {0, 0}}},
    {"XRGB8888", {32, false, {16, 8}, {8, 8}, {0, 8}, {0, 0}}},
    {"XBGR8888", {32, false, {0, 8}, {8, 8}, {16, 8}, {0, 0}}},
    {"RGBX8888", {32, false, {24, 8}, {16, 8}, {8, 8}, {0, 0}}},
    {"BGRX8888", {32, false, {8, 8}, {16, 8}, {24, 8}, {0, 0}}},
};

unsigned pixel_bytes(const struct pixel_format *format)
{
    return (format->bits + 7u) / 8;
}

static bool same(struct pixel_channel a, struct pixel_channel b)
{
    return a.offset == b.offset && a.length == b.length;
}

static bool same_colours(const struct pixel_format *a, const struct pixel_format *b)
{
    return pixel_bytes(a) == pixel_bytes(b) && same(a->red, b->red) && same(a->green, b->green) &&
           same(a->blue, b->blue);
}

bool pixel_is_rgb565(const struct pixel_format *format)
{
    return !format->swapped && same_colours(format, &pixel_rgb565);
}

static uint32_t mask(struct pixel_channel c)
{
    return (uint32_t)(((UINT64_C(1) << c.length) - 1) << c.offset);
}

const char *pixel_fault(const struct pixel_format *format)
{
    const struct pixel_channel c[] = {format->red, format->green, format->blue, format->alpha};
    uint32_t used = 0;

    if (format->bits != 15 && format->bits != 16 && format->bits != 24 && format->bits != 32)
        return "not 15, 16, 24 or 32 bits a pixel";
    for (int i = 0; i < 4; i++) {
        if (c[i].length == 0 && i < 3)
            return "a colour channel has no bits";
        if (c[i].offset + c[i].length > 8 * pixel_bytes(format))
            return "a channel lies outside the pixel";
        if (used & mask(c[i]))
            return "channels overlap";
        used |= mask(c[i]);
    }
    return NULL;
}

const char *pixel_name(const struct pixel_format *format, char text[PIXEL_NAME])
{
    const char *order = format->swapped ? " swapped" : "";

    for (size_t i = 0; i < sizeof named / sizeof *named; i++)
        if (same_colours(format, &named[i].format)) {
            (void)snprintf(text, PIXEL_NAME, "%s%s", named[i].name, order);
            return text;
        }
    (void)snprintf(text, PIXEL_NAME, "%u bit r%u@%u g%u@%u b%u@%u%s", format->bits, format->red.length,
                   format->red.offset, format->green.length, format->green.offset, format->blue.length,
                   format->blue.offset, order);
    return text;
}

/* Repeats `value`, of `width` bits, to fill the channel from its top bit down. */
static uint32_t spread(uint32_t value, unsigned width, struct pixel_channel c)
{
    uint64_t bits = 0;
    unsigned have = 0;

    for (; have < c.length; have += width)
        bits = bits << width | value;
    return (uint32_t)(bits >> (have - c.length) << c.offset);
}

static uint32_t swap(uint32_t pixel, unsigned bytes)
{
    uint32_t out = 0;

    for (unsigned i = 0; i < bytes; i++)
        out |= (pixel >> 8 * i & 255) << 8 * (bytes - 1 - i);
    return out;
}

static void fill(uint32_t *table, unsigned width, struct pixel_channel c, const struct pixel_format *format,
                 uint32_t always)
{
    for (uint32_t v = 0; v < 1u << width; v++) {
        table[v] = spread(v, width, c) | always;
        if (format->swapped)
            table[v] = swap(table[v], pixel_bytes(format));
    }
}

void expander_init(struct expander *expander, const struct pixel_format *format)
{
    expander->format = *format;
    expander->copy = pixel_is_rgb565(format) && format->alpha.length == 0;
    fill(expander->red, 5, format->red, format, mask(format->alpha));
    fill(expander->green, 6, format->green, format, 0);
    fill(expander->blue, 5, format->blue, format, 0);
}

static uint32_t expand(const struct expander *e, tia_rgb565 p)
{
    return e->red[p >> 11] | e->green[p >> 5 & 63] | e->blue[p & 31];
}

static void expand_row16(const struct expander *e, uint16_t *to, const tia_rgb565 *from, size_t count)
{
    for (size_t i = 0; i < count; i++)
        to[i] = (uint16_t)expand(e, from[i]);
}

static void expand_row32(const struct expander *e, uint32_t *to, const tia_rgb565 *from, size_t count)
{
    for (size_t i = 0; i < count; i++)
        to[i] = expand(e, from[i]);
}

/* Expands a row to pixels of three bytes, in the processor's byte order. */
static void expand_row24(const struct expander *e, uint8_t *to, const tia_rgb565 *from, size_t count)
{
    const uint16_t one = 1;
    uint8_t little;

    memcpy(&little, &one, 1);
    for (size_t i = 0; i < count; i++, to += 3) {
        uint32_t p = expand(e, from[i]);
        to[0] = (uint8_t)(little ? p : p >> 16);
        to[1] = (uint8_t)(p >> 8);
        to[2] = (uint8_t)(little ? p >> 16 : p);
    }
}

void expand_row(const struct expander *expander, void *to, const tia_rgb565 *from, size_t count)
{
    if (expander->copy)
        memcpy(to, from, count * sizeof *from);
    else if (pixel_bytes(&expander->format) == 2)
        expand_row16(expander, to, from, count);
    else if (pixel_bytes(&expander->format) == 3)
        expand_row24(expander, to, from, count);
    else
        expand_row32(expander, to, from, count);
}
