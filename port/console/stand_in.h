/* stand_in.h - answers the kernel for a stopped process, so that consoles can still be switched. Private to guard.c.
 *
 * While the process has the console its keyboards stay grabbed, and what is typed waits for it.
 */
#ifndef PORT_CONSOLE_STAND_IN_H
#define PORT_CONSOLE_STAND_IN_H

/* Begin when the guarded process has stopped, and end when it continues. */
void stand_in_begin(void);
void stand_in_end(void);

/* Answer the kernel's signals: it requests the console, or the VT is in front again. */
void stand_in_leave(void);
void stand_in_enter(void);

/* Returns a descriptor that is readable when a key was pressed or released; -1 unless the process is stopped. */
int stand_in_keys(void);
/* Switches consoles if Ctrl-Alt-Fn is down. */
void stand_in_look(void);

#endif
