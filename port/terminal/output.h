/* output.h - the text to be sent to a terminal, and the state of its window: taken by this process or not. */
#ifndef PORT_TERMINAL_OUTPUT_H
#define PORT_TERMINAL_OUTPUT_H

#include "encode.h"
#include "window_signals.h"

struct output {
    int fd;           /* -1: closed */
    bool kitty;       /* pictures are sent by kitty's protocol, and may be cut off */
    bool entered;     /* the alternate screen is entered */
    struct text text; /* text to be sent: [sent, text.count) */
    size_t sent;

    struct terminal_stops since; /* counts of stops when the window was last taken */
};

/* Takes the window if it is in front; the guardian gives it back if this process dies or is stopped. */
void output_enter(struct output *output);

/* Gives the window back, if this process has it. If the terminal does not accept the text within 150 ms, the guardian
 * sends it later. Drops text that is still to be sent. */
void output_leave(struct output *output);

/* True if the shell has or had the window, because of a stop. */
bool output_is_lost(const struct output *output);

/* Takes the window again, and drops text that is still to be sent. The window still shows the shell's output. False in
 * the background. */
bool output_take(struct output *output);

/* True if text is still to be sent. */
bool output_is_left(const struct output *output);

/* Sends as much text as the terminal accepts within timeout_ms in total (-1: no limit). A signal ends the wait. Drops
 * the text once the window is lost. Returns TIA_OK, or TIA_ERR_DEVICE with errno. */
int output_send(struct output *output, int timeout_ms);

/* Drops text that is still to be sent, after a signal, and ends the line; for a window that was not taken. */
void output_cut(struct output *output);

void output_free(struct output *output);

#endif
