/* message.h - error messages of the commands: each is one line on standard error, "TOOL: WHAT: WHY". */
#ifndef TOOLS_COMMON_MESSAGE_H
#define TOOLS_COMMON_MESSAGE_H

#include <stdarg.h>

/* Makes a single line of the text: control characters, as in odd file names, become '?'. */
void message_clean(char *text);

/* Prints "TOOL: " and the text, cleaned. Returns `status`. */
__attribute__((format(printf, 3, 4))) int message(const char *tool, int status, const char *format, ...);

/* Prints a message as message() does, from a list of arguments. */
int message_list(const char *tool, int status, const char *format, va_list values);

/* Prints "TOOL: WHAT: WHY", or "TOOL: WHAT" if `why` is "". Returns `status`. */
int message_why(const char *tool, int status, const char *what, const char *why);

/* Prints a text to standard output, as for --help, or "" at the end of a run: all that was printed must arrive. Returns
 * 0; 1 after an error message if that fails. */
int message_output(const char *tool, const char *text);

#endif
