/* expand.h - pixels as libchafa takes them. */
#ifndef PORT_TERMINAL_CHAFA_EXPAND_H
#define PORT_TERMINAL_CHAFA_EXPAND_H

#include <stddef.h>

#include <tia/port.h>

/* Each pixel so many times as red, green, blue and 255: libchafa 1.12 wants rows of a multiple of four bytes. The
 * caller frees it; NULL without memory. */
uint8_t *expand(const tia_rgb565 *pixels, size_t count, unsigned times);

#endif
