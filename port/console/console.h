/* console.h - the virtual console (VT) under a display that takes the whole screen, the signals by which the kernel
 * switches it, and the one place where signals are let in.
 *
 * A display takes the console; inputs only listen and wait:
 *
 *     open:   console_listen(&listener);  if (console_state() == CONSOLE_OURS) grab();
 *     wait:   console_wait(fds, count, timeout_ms);   // leave() and enter() are called from here
 *     poll:   on Ctrl-Alt-Fn, console_switch(n);
 *     close:  console_ignore(&listener);
 *
 * A process has one console, as it has one screen. Call all functions from the same thread; other threads must block
 * every signal, or they swallow the console's.
 */
#ifndef PORT_COMMON_CONSOLE_H
#define PORT_COMMON_CONSOLE_H

#include <poll.h>

#include "device.h"

enum console_state {
    CONSOLE_FREE, /* no display of this program has taken the screen: grab no keyboard */
    CONSOLE_OURS, /* the screen is ours: draw, grab the keyboards */
    CONSOLE_AWAY  /* ours, but another console is in front: neither draw nor grab keyboards */
};

enum console_state console_state(void);

/* Called when the screen comes and goes; part of a port's context. */
struct console_listener {
    void (*enter)(void *arg); /* it has become CONSOLE_OURS */
    void (*leave)(void *arg); /* it stops being ours when this returns: let go of everything */
    void *arg;
    struct console_listener *next; /* private to console.c */
};

/* Add and remove a listener without calling it: check console_state(). enter is called in the order in which listeners
 * were added, leave in reverse. console_ignore is safe when it was not added. */
void console_listen(struct console_listener *listener);
void console_ignore(struct console_listener *listener);

/* poll(2) with every signal unblocked while it waits; then handles the kernel's signals for switching. Every
 * tia_input.wait uses it, with or without a console. Returns the number of descriptors that are ready, 0 when none is
 * (time is up or a signal came), or TIA_ERR_DEVICE. */
int console_wait(struct pollfd *fds, nfds_t count, int timeout_ms);

/* Asks for console number `vt` (1..63) to come in front, as Ctrl-Alt-Fn does; it happens in a later
 * console_wait. Does nothing when there is no VT or no such console. */
void console_switch(unsigned vt);

/* ---- for displays ---- */

/* Takes the console: the controlling terminal when it is a VT, else the VT in front, else none (no VT in this kernel,
 * or no right to open it: then the screen is ours and is never switched). Switches to it, and from then on answers the
 * kernel when consoles are switched; `graphics` stops its text, which some displays would show over the picture. The
 * guardian (guardian.h) puts it back if this process dies, and lets it be switched while this process is stopped.
 * TIA_ERR_DEVICE and a line in `why` when another program has it. */
int console_open(bool graphics, char why[PORT_WHY]);

/* Puts back what console_open changed. Safe when it is not open. */
void console_close(void);

/* Returns "tty1, the controlling terminal", "tty1, the console in front" or "none: WHY": the console taken, or the one
 * that would be taken now. */
const char *console_name(char text[PORT_WHY]);
/* Prints that name as a line of a display's list. */
void console_list(port_line *line, void *arg);

#endif
