/* refuse.h - error messages: one line, "tia-radio: WHAT: WHY". */
#ifndef TOOLS_RADIO_REFUSE_H
#define TOOLS_RADIO_REFUSE_H

/* The exit statuses. */
enum { FINE, FAILED, REFUSED };

/* Prints a message; control characters become '?'. Returns `status`. */
__attribute__((format(printf, 2, 3))) int refuse(int status, const char *format, ...);

#endif
