/* guard.h - the guardian's process. guardian.c forks it.
 *
 * It traces one thread of the process that it guards, the watcher, which does nothing but wait. A
 * process ends for its parent when its last thread has ended, and a traced thread has ended when
 * its tracer says so: the shell learns of the death after the terminal was put back, and cannot
 * take the modes of a dead program for its own. The other threads are not traced, and a debugger
 * may have them. Where tracing is forbidden the shell may be the first.
 */
#ifndef PORT_CONSOLE_GUARD_H
#define PORT_CONSOLE_GUARD_H

#include <sys/types.h>

/* Sent to the guarded process for each WATCHER message. */
#define GUARD_READY 'r'

/* In a new process with all signals blocked: follows the messages that come on `line` from the
 * process `parent` of the process group `group` until it dies, puts back what is kept, and ends. */
void guard(int line, pid_t parent, pid_t group);

#endif
