/* window_signals.h - the signals that concern a terminal: a new size (SIGWINCH), continuing after a stop (SIGCONT). */
#ifndef PORT_TERMINAL_WINDOW_SIGNALS_H
#define PORT_TERMINAL_WINDOW_SIGNALS_H

#include <stdbool.h>
#include <sys/types.h>

/* Begins a period in which SIGWINCH and SIGCONT end a console_wait, and stay pending until then. Calls nest: the last
 * terminal_signals_end undoes the first terminal_signals_begin. */
void terminal_signals_begin(void);
/* Ends that period. */
void terminal_signals_end(void);

/* Counts of stops, stored when a terminal was taken, to detect later stops. */
struct terminal_stops {
    int resumes;       /* number of SIGCONT signals */
    unsigned put_back; /* result of guardian_put_back */
};

/* Returns the present counts; they include a pending SIGCONT, which then no longer ends a console_wait. */
struct terminal_stops terminal_stops_now(void);

/* True if the guardian has restored the terminal since these counts: the shell has or had it. */
bool terminal_is_put_back(const struct terminal_stops *since);

/* True if, since these counts, the guardian has restored the terminal or the process has continued after a stop. Other
 * programs may then have written on the screen and changed the terminal's modes. */
bool terminal_is_lost(const struct terminal_stops *since);

/* Leaves a SIGCONT pending: the next console_wait ends at once. */
void terminal_resume_again(void);

/* True if a signal other than SIGWINCH and SIGCONT is pending. */
bool terminal_has_other_signal(void);

/* Calls write(2) on a terminal, between terminal_signals_begin and terminal_signals_end. Fails with EINTR when the
 * process is stopped just before the write, and continues: the shell may have the terminal by then. */
ssize_t terminal_write(int fd, const void *bytes, size_t count);

#endif
