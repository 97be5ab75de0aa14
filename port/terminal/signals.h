/* signals.h - what a terminal tells by signals: a new size, and that the process goes on after a stop. */
#ifndef PORT_TERMINAL_SIGNALS_H
#define PORT_TERMINAL_SIGNALS_H

/* From now on SIGWINCH and SIGCONT end a console_wait, and are kept until then. The calls nest;
 * the last terminal_signals_end puts back what the first terminal_signals_begin found. */
void terminal_signals_begin(void);
void terminal_signals_end(void);

/* Counts the times that the process went on after a stop: whatever ran meanwhile has written on
 * the screen and set the terminal's modes. */
int terminal_resumes(void);

#endif
