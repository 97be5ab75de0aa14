/* signals.h - how the commands end on SIGINT, SIGTERM, SIGHUP and SIGQUIT, unless the parent process ignores them.
 *
 * A command that writes files ends at once, whatever it is doing: reading a scene, building a hierarchy, drawing,
 * compressing. The handler runs the cleanups that are registered here, such as removing unfinished files, and lets the
 * signal kill the process. So no other code has to check for signals, and no scene can delay them.
 *
 * A display is put back by code that must not run in a handler. With one, the signals are only noted, and the viewer
 * calls signals_asked between frames and while it draws one: see tia_viewer.stop.
 *
 * Signals are handled on the main thread; the others block them all (thread_pool.c).
 */
#ifndef TOOLS_SIGNALS_H
#define TOOLS_SIGNALS_H

#include <stdbool.h>

/* What to undo before a signal ends the program. `undo` runs in the handler: it may only call async-signal-safe
 * functions. */
struct signals_cleanup {
    void (*undo)(void *arg);
    void *arg;
    struct signals_cleanup *next;
};

/* Call at the start of the program. From then on the signals end it as above, and writing to a closed pipe or beyond
 * the limit of a file's size fails instead of ending the program. */
void signals_prepare(void);

/* No signal is handled between these two: for creating something and registering its cleanup. They nest. */
void signals_hold(void);
void signals_allow(void);

/* Removing one that is not registered does nothing. */
void signals_add(struct signals_cleanup *cleanup);
void signals_remove(struct signals_cleanup *cleanup);

/* From now on the signals are only noted, and blocked except while an input waits. */
void signals_catch_waiting(void);

/* Whether one was noted or is pending. Any thread may call it. The argument is there for tia_viewer.stop. */
bool signals_asked(void *unused);

/* Undoes signals_catch_waiting. */
void signals_release(void);

/* Calls signals_release. If a signal was noted, ends the program with it; otherwise returns `status`. */
int signals_end(int status);

#endif
