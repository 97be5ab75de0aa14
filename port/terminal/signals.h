/* signals.h - the signals that concern a terminal: a new size (SIGWINCH), and continuing after a stop (SIGCONT). */
#ifndef PORT_TERMINAL_SIGNALS_H
#define PORT_TERMINAL_SIGNALS_H

#include <sys/types.h>

/* From now on SIGWINCH and SIGCONT end a console_wait, and stay pending until then. Calls nest: the
 * last terminal_signals_end undoes the first terminal_signals_begin. */
void terminal_signals_begin(void);
void terminal_signals_end(void);

/* How often the process has continued after a stop. Others may have written on the screen and changed the terminal's
 * modes meanwhile. */
int terminal_resumes(void);

/* The same, with one that is pending. */
int terminal_resumes_now(void);

/* Leaves one pending: the next console_wait ends at once. */
void terminal_resume_again(void);

/* write(2) to a terminal, between begin and end. A process that is stopped just before it writes, and continues, fails
 * with EINTR instead: the terminal may be the shell's by then. */
ssize_t terminal_write(int fd, const void *bytes, size_t count);

#endif
