/* utf8.h - the terminal's character encoding. */
#ifndef PORT_TERMINAL_UTF8_H
#define PORT_TERMINAL_UTF8_H

#include <stdbool.h>

/* True if the locale is UTF-8; if it is not installed here, its name decides: ssh passes on that of the terminal's
 * machine. */
bool locale_is_utf8(void);

#endif
