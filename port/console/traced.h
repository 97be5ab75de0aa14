/* traced.h - the two threads of the guarded process that the guardian traces. Private to guard.c.
 *
 * One thread reports each stop of the process. The other is held in a stop of its own: the parent is notified of a stop
 * when all threads have stopped, and the held thread does so only after `stops` has returned.
 */
#ifndef PORT_CONSOLE_TRACED_H
#define PORT_CONSOLE_TRACED_H

#include <stdbool.h>
#include <sys/types.h>

/* Begins to trace the threads `reports` and `holds`. Where tracing is forbidden, or another process traces them,
 * nothing is reported. */
void traced_begin(pid_t reports, pid_t holds);

/* Handles the threads' reports, on SIGCHLD. Calls stops(held) when the process stops (`held`: its parent is not yet
 * notified), and goes_on when it continues. Deaths of threads are left to traced_end. */
void traced_follow(void (*stops)(bool held), void (*goes_on)(void));

/* Waits, after the process was continued, until the held thread is in a stop of its own again. */
void traced_settle(void);

/* Waits for the two threads once the process has died, and thereby lets its parent be notified of the death. */
void traced_end(void);

#endif
