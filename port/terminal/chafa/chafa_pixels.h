/* chafa_pixels.h - pixels in libchafa's format. */
#ifndef PORT_TERMINAL_CHAFA_CHAFA_PIXELS_H
#define PORT_TERMINAL_CHAFA_CHAFA_PIXELS_H

#include <stddef.h>

#include <tia/port.h>

/* Expands each pixel to `times` equal RGBA pixels with an alpha of 255: libchafa 1.12 needs rows of a multiple of four
 * bytes. The caller frees the memory; NULL: memory is short. */
uint8_t *expand(const tia_rgb565 *pixels, size_t count, unsigned times);

#endif
