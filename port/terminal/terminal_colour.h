/* terminal_colour.h - the colours of a terminal. */
#ifndef PORT_TERMINAL_TERMINAL_COLOUR_H
#define PORT_TERMINAL_TERMINAL_COLOUR_H

#include <tia/port.h>

struct rgb8 {
    uint8_t r, g, b;
};

/* Expands RGB565 to 8 bits a channel by bit replication: black stays black, full intensity stays full. */
struct rgb8 colour_expand(tia_rgb565 pixel);

/* Returns the nearest of the 256 colours of xterm, by the sum of squared differences; a tie goes to the lower index.
 * The first 16, which users can redefine, are never returned. */
uint8_t colour_nearest(struct rgb8 colour);

/* True if a terminal with these environment variables (NULL: not set) has 24-bit colours. */
bool colour_is_direct(const char *term, const char *colorterm);

#endif
