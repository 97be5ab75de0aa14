/* console.h - takes the virtual console (VT) for a display that uses the whole screen, answers the signals by which the
 * kernel switches consoles, and provides the only wait during which signals are unblocked.
 *
 * A display takes the console; inputs only listen and wait:
 *
 *     open:   console_listen(&listener);  if (console_state() == CONSOLE_OURS) grab();
 *     wait:   console_wait(fds, count, timeout_ms);   // leave() and enter() are called from here
 *     poll:   on Ctrl-Alt-Fn, console_switch(n);
 *     close:  console_ignore(&listener);
 *
 * A process has one console, as it has one screen. Call all functions from the same thread; other threads must block
 * every signal, or they would receive the console's.
 */
#ifndef PORT_COMMON_CONSOLE_H
#define PORT_COMMON_CONSOLE_H

#include <poll.h>

#include "device.h"

enum console_state {
    CONSOLE_FREE, /* no display of this program has taken the screen: grab no keyboard */
    CONSOLE_OURS, /* this program has the screen: draw, grab the keyboards */
    CONSOLE_AWAY  /* the same, but another console is in front: neither draw nor grab keyboards */
};

enum console_state console_state(void);

/* Callbacks for gaining and losing the screen. A port has this struct in its context. */
struct console_listener {
    void (*enter)(void *arg); /* the state has become CONSOLE_OURS */
    void (*leave)(void *arg); /* stop using the screen and the keyboards: on return the console is released */
    void *arg;
    struct console_listener *next; /* private to console.c */
};

/* Adds a listener. Does not call it, so the caller must check console_state(). `enter` is called in the order in which
 * listeners were added, `leave` in reverse order. */
void console_listen(struct console_listener *listener);
/* Removes a listener, without calling it. Does nothing if the listener was not added. */
void console_ignore(struct console_listener *listener);

/* Calls poll(2) with every signal unblocked, then handles the kernel's signals for switching. Every tia_input.wait uses
 * this function, with or without a console. Returns the number of descriptors that are ready, 0 when none is (time is
 * up, or a signal came), or TIA_ERR_DEVICE. */
int console_wait(struct pollfd *fds, nfds_t count, int timeout_ms);

/* Requests a switch to console number `vt` (1..63), as Ctrl-Alt-Fn does; a later console_wait completes the switch.
 * Does nothing when there is no VT or no such console. */
void console_switch(unsigned vt);

/* ---- for displays ---- */

/* Takes the console: the controlling terminal if it is a VT, else the VT in front. If the kernel has no VT, or this
 * process may not open it, takes none; then the screen is never switched away. Switches to the console, and from then
 * on answers the kernel when consoles are switched. `graphics` hides the console's text, which some displays would show
 * over the picture. The guardian (guardian.h) restores the console if this process dies, and answers the kernel while
 * this process is stopped. Returns TIA_OK, or TIA_ERR_DEVICE with a line in `why` when another program has the
 * console. */
int console_open(bool graphics, char why[PORT_WHY]);

/* Restores what console_open changed. Safe when the console is not open. */
void console_close(void);

/* Returns a description of the console that is taken, or that console_open would take: "tty1, the controlling
 * terminal", "tty1, the console in front" or "none: WHY". */
const char *console_name(char text[PORT_WHY]);
/* Prints console_name() as a line of a display's list. */
void console_list(port_line *line, void *arg);

#endif
