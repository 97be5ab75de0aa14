/* guard.h - the guardian's process. guardian.c forks it.
 *
 * It traces one thread of the guarded process, the watcher, which does nothing but wait. A parent sees a child die when
 * its last thread is gone, and a traced thread is gone only when its tracer has reaped it. So the shell sees the death
 * after the terminal was put back, and cannot mistake the dead program's modes for its own. The other threads are not
 * traced, so a debugger can attach to them. Where tracing is forbidden, the shell may come first.
 */
#ifndef PORT_CONSOLE_GUARD_H
#define PORT_CONSOLE_GUARD_H

#include <sys/types.h>

/* Sent to the guarded process for each WATCHER message. */
#define GUARD_READY 'r'

/* For a new process with all signals blocked: handles the messages on the socket `line` from the process `parent`, of
 * the process group `group`, until that dies; then puts back what is in the table, and exits. */
void guard(int line, pid_t parent, pid_t group);

#endif
