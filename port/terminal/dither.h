/* dither.h - ordered dithering for terminals with 256 or 16 colours.
 *
 * A colour is shown as a mixture of two colours of the palette, in a pattern of 8 x 8 pixels. Mixtures are judged in
 * CIE Lab: by the mixture's own error, and by how much its two colours differ. So a grey becomes greys, not a green and
 * a red one. Integers only.
 */
#ifndef PORT_TERMINAL_DITHER_H
#define PORT_TERMINAL_DITHER_H

#include "terminal_colour.h"

struct dither;

/* Returns a dither for a palette, 264 KiB, to be freed by free(); NULL: memory is short. */
struct dither *dither_new(enum colours colours);

/* Returns the index of the palette's colour for a pixel at (x, y). The first time that a colour comes takes some 5 us.
 */
uint8_t dither_pixel(struct dither *dither, tia_rgb565 pixel, unsigned x, unsigned y);

#endif
