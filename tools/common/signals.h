/* signals.h - clean exit on signals: the command cleans up, then ends by the same signal. */
#ifndef TOOLS_TIA_SIGNALS_H
#define TOOLS_TIA_SIGNALS_H

/* 0, or the signal that was caught; for tia_viewer's `stop`. */
extern volatile int signals_caught;

/* Call at the start of the program. A closed pipe or a file beyond the size limit then makes write fail instead of
 * ending the program. */
void signals_prepare(void);

/* From now on SIGINT, SIGTERM, SIGHUP and SIGQUIT only set signals_caught; those that the parent process ignores stay
 * ignored. */
void signals_catch(void);

/* The same, and delivers them only while an input waits. */
void signals_catch_waiting(void);

/* Undoes signals_catch. */
void signals_release(void);

/* Calls signals_release. If a signal was caught, ends the program by it, otherwise returns `status`. */
int signals_end(int status);

#endif
