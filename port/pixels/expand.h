/* expand.h - converts RGB565 to the pixel format of a screen.
 *
 * A channel wider than RGB565's is filled by bit replication, so that black stays black and full intensity stays full.
 * A narrower channel gets the upper bits.
 */
#ifndef PORT_COMMON_EXPAND_H
#define PORT_COMMON_EXPAND_H

#include <tia/fixed.h>

struct pixel_channel {
    uint8_t offset, length; /* bits; offset 0 is the pixel's lowest */
};

/* A pixel is an integer of `bits` / 8 bytes, rounded up. All zero: no format. */
struct pixel_format {
    uint8_t bits; /* 15, 16, 24 or 32 */
    bool swapped; /* the byte order is not the processor's */
    struct pixel_channel red, green, blue;
    struct pixel_channel alpha; /* alpha is filled with ones; length 0: none */
};

extern const struct pixel_format pixel_rgb565, pixel_bgr565, pixel_xrgb8888, pixel_xbgr8888;

/* Returns the bytes of a pixel: 2, 3 or 4. */
unsigned pixel_bytes(const struct pixel_format *format);
/* True if the format is tia_rgb565, bit for bit. */
bool pixel_is_rgb565(const struct pixel_format *format);
/* Returns NULL when tia supports the format, otherwise the reason: "channels overlap". */
const char *pixel_fault(const struct pixel_format *format);
#define PIXEL_NAME 48
/* Returns the format's name, in `text`: "RGB565", "XBGR8888", or its channels, "32 bit r10@0 g10@10 b10@20". */
const char *pixel_name(const struct pixel_format *format, char text[PIXEL_NAME]);

/* Tables for a format, which expand each value of each channel. */
struct expander {
    struct pixel_format format;
    bool copy; /* the format is RGB565: pixels are copied */
    uint32_t red[32], green[64], blue[32];
};

/* Prepares the tables; pixel_fault must have accepted `format`. */
void expander_init(struct expander *expander, const struct pixel_format *format);
/* Expands `count` pixels; writes each once, at rising addresses. */
void expand_row(const struct expander *expander, void *to, const tia_rgb565 *from, size_t count);

#endif
