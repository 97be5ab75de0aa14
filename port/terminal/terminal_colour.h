/* terminal_colour.h - the colours of a terminal. */
#ifndef PORT_TERMINAL_TERMINAL_COLOUR_H
#define PORT_TERMINAL_TERMINAL_COLOUR_H

#include <tia/port.h>

struct rgb8 {
    uint8_t r, g, b;
};

/* The colours of a terminal: 24 bits; xterm's 256; 16, of xterm or of a PC's console, which users can redefine; or
 * none. */
enum colours { COLOURS_DIRECT, COLOURS_256, COLOURS_16, COLOURS_CONSOLE, COLOURS_NONE };

/* True for a terminal that only prints characters, or of which nothing is known. */
bool terminal_is_dumb(const char *term);

/* True for DEC's terminals up to the VT420, which have no colours. */
bool terminal_is_dec(const char *term);

/* True for the two kinds of 16 colours. */
static inline bool colours_are_few(enum colours colours)
{
    return colours == COLOURS_16 || colours == COLOURS_CONSOLE;
}

/* Returns the colours of a terminal with these environment variables (NULL: not set). */
enum colours colours_of(const char *term, const char *colorterm);

/* Returns the character that shows the mean of two pixels in a terminal without colours, bright on dark: one of ten,
 * from a space to '@', by Rec. 709's luma, 0.2126 R + 0.7152 G + 0.0722 B. */
char colour_letter(tia_rgb565 upper, tia_rgb565 lower);

/* Returns a colour of one of the palettes: of COLOURS_256 16..255, of the others 0..15. */
struct rgb8 colour_indexed(enum colours colours, unsigned index);

/* Returns the code of one of the 16 colours, 0..15, in a control sequence, as a background or else as text. */
unsigned colour_code(unsigned index, bool background);

/* Expands RGB565 to 8 bits a channel by bit replication: black stays black, full intensity stays full. */
struct rgb8 colour_expand(tia_rgb565 pixel);

/* Returns the nearest of the 256 colours of xterm, by the sum of squared differences; a tie goes to the lower index.
 * The first 16, which users can redefine, are never returned. */
uint8_t colour_nearest(struct rgb8 colour);

/* True if a terminal with these environment variables (NULL: not set) has 24-bit colours. */
bool colour_is_direct(const char *term, const char *colorterm);

#endif
