/* stand_in.h - answers the kernel for a stopped process, so that consoles can still be switched. Private to guard.c.
 *
 * While the process has the console, its keyboards stay grabbed, and their events wait for the process.
 */
#ifndef PORT_CONSOLE_STAND_IN_H
#define PORT_CONSOLE_STAND_IN_H

/* Begins to answer, when the guarded process has stopped. */
void stand_in_begin(void);
/* Stops answering, when the process continues. */
void stand_in_end(void);

/* Answers the signal by which the kernel requests the console. */
void stand_in_leave(void);
/* Answers the signal that the VT is in front again. */
void stand_in_enter(void);

/* Returns a descriptor that is readable when a key was pressed or released; -1 unless the process is stopped. */
int stand_in_keys(void);
/* Switches consoles if Ctrl-Alt-Fn is down. */
void stand_in_look(void);

#endif
