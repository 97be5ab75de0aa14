/* spare.h - a second guardian, the first one's child, that restores all states when both the first guardian and the
 * guarded process are killed at nearly the same moment. Private to guard.c.
 *
 * The spare traces nothing, so the shell may be notified of the death first: modes that the shell sets then stay.
 */
#ifndef PORT_CONSOLE_SPARE_H
#define PORT_CONSOLE_SPARE_H

/* Forks the second guardian. `process` is the guarded process's pidfd; `put_back` restores the table's states. */
void spare_start(int process, void (*put_back)(void));

/* Updates the copy of the table that the second guardian reads. */
void spare_follow(void);

#endif
