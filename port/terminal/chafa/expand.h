/* expand.h - pixels in libchafa's format. */
#ifndef PORT_TERMINAL_CHAFA_EXPAND_H
#define PORT_TERMINAL_CHAFA_EXPAND_H

#include <stddef.h>

#include <tia/port.h>

/* Writes each pixel `times` times as red, green, blue and 255: libchafa 1.12 requires rows of a multiple of four bytes.
 * The caller frees it; NULL without memory. */
uint8_t *expand(const tia_rgb565 *pixels, size_t count, unsigned times);

#endif
