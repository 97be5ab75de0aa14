/* expand.h - RGB565 into whatever pixels a screen has.
 *
 * A channel that is wider than ours gets our bits again and again from the top (bit replication:
 * black stays black, full stays full), one that is narrower gets our upper bits.
 */
#ifndef PORT_COMMON_EXPAND_H
#define PORT_COMMON_EXPAND_H

#include <tia/fixed.h>

struct pixel_channel {
    uint8_t offset, length; /* bits; offset 0 is the pixel's lowest */
};

/* A pixel of a screen: a number of bits / 8 bytes, rounded up. All zero is no format. */
struct pixel_format {
    uint8_t bits; /* 15, 16, 24 or 32 */
    bool swapped; /* its bytes lie in the order that is not the processor's */
    struct pixel_channel red, green, blue;
    struct pixel_channel alpha; /* filled with ones; length 0: none */
};

extern const struct pixel_format pixel_rgb565, pixel_bgr565, pixel_xrgb8888, pixel_xbgr8888;

/* Bytes of a pixel: 2, 3 or 4. */
unsigned pixel_bytes(const struct pixel_format *format);
/* Is it tia_rgb565, bit for bit? */
bool pixel_is_rgb565(const struct pixel_format *format);
/* NULL when tia can draw it, else what is wrong: "green is 0 bits wide". */
const char *pixel_fault(const struct pixel_format *format);
/* "RGB565", "XBGR8888", or what the channels are: "32 bit r10@0 g10@10 b10@20". */
#define PIXEL_NAME 48
const char *pixel_name(const struct pixel_format *format, char text[PIXEL_NAME]);

/* A format made ready: what each value of each channel becomes. */
struct expander {
    struct pixel_format format;
    bool copy; /* nothing to expand */
    uint32_t red[32], green[64], blue[32];
};

/* `format` must be without fault. */
void expander_init(struct expander *expander, const struct pixel_format *format);
/* A row: `count` pixels, written once each in rising addresses. */
void expand_row(const struct expander *expander, void *to, const tia_rgb565 *from, size_t count);

#endif
