/* utf8.h - the character set of the terminal. */
#ifndef PORT_TERMINAL_UTF8_H
#define PORT_TERMINAL_UTF8_H

#include <stdbool.h>

/* True if the locale's character set is UTF-8 or, where the locale is not installed, its name contains UTF-8: ssh
 * passes on the locale of the terminal's machine. */
bool locale_is_utf8(void);

#endif
