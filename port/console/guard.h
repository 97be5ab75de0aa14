/* guard.h - the guardian's process, which keeper.c forks.
 *
 * The guardian traces two threads of the guarded process, which do nothing but wait. A parent is notified of a child's
 * death when the child's last thread is gone, and a traced thread is gone only when its tracer has reaped it. A parent
 * is notified of a child's stop when the child's last thread has stopped, and one of the two threads stops only when
 * its tracer lets it: see traced.h. So the shell is notified of a death or a stop only after the terminal was restored,
 * and cannot mistake the program's modes for its own. The other threads are not traced: strace can attach to them, and
 * gdb can start the program, but not attach to it. Where tracing is forbidden, the shell may be notified first, and no
 * terminal is restored at a stop.
 */
#ifndef PORT_CONSOLE_GUARD_H
#define PORT_CONSOLE_GUARD_H

#include <sys/types.h>

/* The byte that answers each THREADS message. */
#define GUARD_READY 'r'

/* Runs the guardian in a new process with all signals blocked: handles the messages on the socket `line` from the
 * process `parent`, of the process group `group`, until that process dies; then restores the states in the table, and
 * exits. The new guardian replaces the one with the number `before`; it exits at once if that one's spare has taken
 * over. */
_Noreturn void guard(int line, pid_t parent, pid_t group, unsigned before);

#endif
