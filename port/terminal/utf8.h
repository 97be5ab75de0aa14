/* utf8.h - what characters the terminal takes. */
#ifndef PORT_TERMINAL_UTF8_H
#define PORT_TERMINAL_UTF8_H

#include <stdbool.h>

/* Asks the locale or, if it is not installed here, goes by its name: ssh passes on that of the terminal's machine. */
bool locale_is_utf8(void);

#endif
