/* window_title.h - the title of a terminal's window, in the control sequences of xterm. */
#ifndef PORT_TERMINAL_WINDOW_TITLE_H
#define PORT_TERMINAL_WINDOW_TITLE_H

#include <stdbool.h>
#include <stddef.h>

/* Put the title onto the terminal's stack of titles, and take it from there. */
#define TITLE_SAVE "\033[22;2t"
#define TITLE_RESTORE "\033[23;2t"

enum { TITLE_SIZE = 128 };

/* True if a terminal with this TERM (NULL: not set) has a window with a title: not the console nor
 * DEC's terminals, which would show the text. */
bool title_is_shown(const char *term);

/* Writes the sequence that sets the title; a title too long is cut. It must be without control characters. */
void title_sequence(char sequence[TITLE_SIZE], const char *title);

#endif
