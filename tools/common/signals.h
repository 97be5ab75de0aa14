/* signals.h - ends the commands on SIGINT, SIGTERM, SIGHUP and SIGQUIT, except those of these signals that the parent
 * process ignores.
 *
 * A command that writes files ends at once, at any point: reading a scene, building a hierarchy, drawing, compressing.
 * The handler runs the cleanups that are registered here, such as removing unfinished files, and then lets the signal
 * kill the process. So no other code has to check for signals, and no scene can delay them.
 *
 * A display is restored by code that must not run in a handler. While a display is open, the signals are only noted,
 * and the viewer calls signals_asked between frames and during a frame: see tia_viewer.stop.
 *
 * Signals are handled on the main thread; the others block them all (thread_pool.c).
 */
#ifndef TOOLS_SIGNALS_H
#define TOOLS_SIGNALS_H

#include <stdbool.h>

/* A cleanup before a signal ends the program. `undo` runs in the handler, so it may only call async-signal-safe
 * functions. */
struct signals_cleanup {
    void (*undo)(void *arg);
    void *arg;
    struct signals_cleanup *next;
};

/* Installs the handlers, at the start of the program. Writing to a closed pipe, or beyond the limit of a file's size,
 * then fails instead of ending the program. */
void signals_prepare(void);

/* Holds all signals, to create a file and register its cleanup. Calls nest. */
void signals_hold(void);
/* Allows the signals again. */
void signals_allow(void);

/* Registers a cleanup. */
void signals_add(struct signals_cleanup *cleanup);
/* Removes a cleanup; does nothing if it is not registered. */
void signals_remove(struct signals_cleanup *cleanup);

/* Changes the handling: signals are only noted, and blocked except during a wait for input. */
void signals_catch_waiting(void);

/* True if a signal was noted or is pending. Any thread may call it. tia_viewer.stop requires the argument. */
bool signals_asked(void *unused);

/* Undoes signals_catch_waiting. */
void signals_release(void);

/* Calls signals_release. If a signal was noted, ends the program with that signal; otherwise returns `status`. */
int signals_end(int status);

#endif
