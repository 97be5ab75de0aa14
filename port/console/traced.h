/* traced.h - the two threads of the guarded process that the guardian traces. Private to guard.c.
 *
 * One reports each stop of the process. The other is held in a stop of its own: a process counts as stopped for its
 * parent when all of its threads have stopped, and the held one stops only after `stops` has returned. */
#ifndef PORT_CONSOLE_TRACED_H
#define PORT_CONSOLE_TRACED_H

#include <stdbool.h>
#include <sys/types.h>

/* Begins to trace two threads. Where tracing is forbidden, or another process traces them, no stop is reported. */
void traced_begin(pid_t reports, pid_t holds);

/* Called on SIGCHLD. `stops(held)`: the process stops; its parent is not notified yet if `held`. `goes_on`: it
 * continues. The death of a thread is ignored: see traced_end. */
void traced_follow(void (*stops)(bool held), void (*goes_on)(void));

/* Called when the process runs again after a stop: waits until the held thread is held again. */
void traced_settle(void);

/* Called when the process has died: waits for the two threads, and with that lets its parent be notified. */
void traced_end(void);

#endif
