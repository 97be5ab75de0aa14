/* traced.h - the two threads of the guarded process that the guardian traces. Private to guard.c.
 *
 * One reports each stop of the process. The other is kept in a stop of its own: a process has stopped, for its parent,
 * when all of its threads have, and that one does only after `stops` has returned. */
#ifndef PORT_CONSOLE_TRACED_H
#define PORT_CONSOLE_TRACED_H

#include <stdbool.h>
#include <sys/types.h>

/* Where tracing is forbidden, or another process traces them, nothing is reported. */
void traced_begin(pid_t reports, pid_t holds);

/* On SIGCHLD. `stops(held)`: the process stops, and its parent does not know yet if `held`; goes_on: it continues. A
 * thread's death is not taken notice of: see traced_end. */
void traced_follow(void (*stops)(bool held), void (*goes_on)(void));

/* The process runs again after a stop: waits until the thread that is held is so. */
void traced_settle(void);

/* When the process has died: waits for the two threads, and with that allows its parent to see the death. */
void traced_end(void);

#endif
