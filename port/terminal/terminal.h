/* terminal.h - a terminal as a display and as a keyboard. */
#ifndef PORT_TERMINAL_H
#define PORT_TERMINAL_H

#include "device.h"

/* The terminal of standard output. wish.device may name another one, or a way to show pictures: see ways.h. */
extern const struct tia_display port_terminal_display;
void *port_terminal_create(const struct port_wish *wish);
void port_terminal_destroy(void *ctx);
void port_terminal_list(port_line *line, void *arg);
void port_terminal_text(void *ctx, struct port_text *text);

/* The terminal of standard input or, if that is not a terminal, the controlling one; wish.device may name another. Keys
 * are reported as TIA_EVENT_TAP, with the time when they were read. With wish.pointer, the mouse is reported as
 * TIA_EVENT_POINT, if the terminal supports one. */
extern const struct tia_input port_tty_input;
void *port_tty_create(const struct port_wish *wish);
void port_tty_destroy(void *ctx);

#endif
