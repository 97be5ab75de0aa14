/* spare.h - a second guardian, the first one's child, that restores all states when both the first guardian and the
 * guarded process are killed at nearly the same moment. Private to guard.c.
 *
 * It traces nothing, so the shell may then be notified first: modes that the shell has set stay.
 */
#ifndef PORT_CONSOLE_SPARE_H
#define PORT_CONSOLE_SPARE_H

/* Forks the second guardian. `process` is the guarded process's pidfd; `put_back` restores the table's states. */
void spare_start(int process, void (*put_back)(void));

/* Copies the table after it has changed. */
void spare_follow(void);

#endif
