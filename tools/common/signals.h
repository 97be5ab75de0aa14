/* signals.h - how the commands end on SIGINT, SIGTERM, SIGHUP and SIGQUIT, unless the parent process ignores them.
 *
 * A command that writes files ends at once, whatever it is doing: reading a scene, building a hierarchy, drawing,
 * compressing. The handler runs the cleanups that are registered here, such as removing unfinished files, and lets the
 * signal kill the process. So nothing else has to ask whether a signal came, and no scene can delay it.
 *
 * A display must be put back by code that a handler may not run. There the signals are only noted, and the viewer asks
 * signals_asked between frames and while it draws one: see tia_viewer.stop.
 *
 * All this is of the main thread; the others block all signals (thread_pool.c).
 */
#ifndef TOOLS_SIGNALS_H
#define TOOLS_SIGNALS_H

#include <stdbool.h>

/* What a signal must undo. `undo` runs in the handler: it may only call what is safe there. */
struct signals_cleanup {
    void (*undo)(void *arg);
    void *arg;
    struct signals_cleanup *next;
};

/* Call at the start of the program. From then on the signals end it as above, and writing to a closed pipe or beyond
 * the limit of a file's size fails instead of ending the program. */
void signals_prepare(void);

/* Between the two no signal comes: for creating what must be undone, and registering it. They nest. */
void signals_hold(void);
void signals_allow(void);

/* Registered until it is removed, which does nothing to one that is not registered. */
void signals_add(struct signals_cleanup *cleanup);
void signals_remove(struct signals_cleanup *cleanup);

/* From now on the signals are blocked except while an input waits, and only noted. */
void signals_catch_waiting(void);

/* Whether one was noted or is blocked. On any thread; the argument is not used, as tia_viewer.stop asks for one. */
bool signals_asked(void *unused);

/* Undoes signals_catch_waiting. */
void signals_release(void);

/* Calls signals_release. If a signal was noted, ends the program by it, otherwise returns `status`. */
int signals_end(int status);

#endif
