/* signals.h - the signals that end the command: it stops cleanly, then dies of them. */
#ifndef TOOLS_TIA_SIGNALS_H
#define TOOLS_TIA_SIGNALS_H

/* 0, or the signal that asked to stop: what tia_viewer's `stop` looks at. */
extern volatile int signals_caught;

/* From the start of the program: a closed pipe or a file that grows too large is an error of
 * write, not the end. */
void signals_prepare(void);

/* SIGINT, SIGTERM, SIGHUP and SIGQUIT are from now on only noted in signals_caught, unless whoever started
 * the program has them ignored. */
void signals_catch(void);

/* The same, and they come only while an input waits. */
void signals_catch_waiting(void);

/* Back to what was before. */
void signals_release(void);

/* signals_release; then, after a signal, the program ends by it. Else returns `status`. */
int signals_end(int status);

#endif
