/* stand_in.h - answers the kernel for a process that is stopped, so that it keeps nobody from another
 * console. guard.c's own.
 *
 * Its keyboards stay grabbed as long as it has the console, and what is typed waits for it.
 */
#ifndef PORT_CONSOLE_STAND_IN_H
#define PORT_CONSOLE_STAND_IN_H

/* The guarded process stops, and goes on. */
void stand_in_begin(void);
void stand_in_end(void);

/* The kernel's signals: may another console come in front? The VT is in front again. */
void stand_in_leave(void);
void stand_in_enter(void);

/* Readable when a key has moved meanwhile; -1 while nothing is stopped. */
int stand_in_keys(void);
/* Is Ctrl-Alt-Fn down? */
void stand_in_look(void);

#endif
