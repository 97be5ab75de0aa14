/* traced.h - the two threads of the guarded process that the guardian traces. Private to guard.c.
 *
 * One thread reports each stop of the process. The other, the held thread, is kept in a stop of its own. The parent is
 * notified of a stop when all threads take part in it, and the held thread does so only after `stops` has returned.
 */
#ifndef PORT_CONSOLE_TRACED_H
#define PORT_CONSOLE_TRACED_H

#include <stdbool.h>
#include <sys/types.h>

/* Begins to trace `reports`, the thread that reports, and `holds`, the held thread. Where tracing is forbidden, or
 * another process traces them, nothing is reported. */
void traced_begin(pid_t reports, pid_t holds);

/* Handles the threads' reports; call it on SIGCHLD. Calls stops(held) when the process stops (`held`: its parent is not
 * yet notified), and goes_on when it continues. Deaths of threads are left to traced_end. */
void traced_follow(void (*stops)(bool held), void (*goes_on)(void));

/* Waits until the held thread is in a stop of its own again; call it after the process has continued. */
void traced_settle(void);

/* Reaps the two threads after the death of the process; only then is its parent notified of the death. */
void traced_end(void);

#endif
