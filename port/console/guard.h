/* guard.h - the guardian's process. keeper.c forks it.
 *
 * It traces two threads of the guarded process, which do nothing but wait. A parent is notified of a child's death when
 * its last thread is gone, and a traced thread is gone only when its tracer has reaped it; it is notified of a child's
 * stop when the last thread has stopped, and one of the two does so only when its tracer lets it: see traced.h. So the
 * shell is notified of both after the terminal was put back, and cannot mistake the program's modes for its own. The
 * other threads are not traced: strace can attach to them, and gdb can start the program, but not attach to it. Where
 * tracing is forbidden, the shell may come first, and a stop changes nothing.
 * */
#ifndef PORT_CONSOLE_GUARD_H
#define PORT_CONSOLE_GUARD_H

#include <sys/types.h>

/* Sent to the guarded process for each THREADS message. */
#define GUARD_READY 'r'

/* Runs the guardian in a new process with all signals blocked: handles the messages on the socket `line` from the
 * process `parent`, of the process group `group`, until that dies; then puts back what is in the table, and exits. It
 * is the guardian after number `before`, or, if that one's spare has taken over meanwhile, does nothing. */
_Noreturn void guard(int line, pid_t parent, pid_t group, unsigned before);

#endif
