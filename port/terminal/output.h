/* output.h - the text on its way to a terminal, and the state of the terminal's window: taken or not. */
#ifndef PORT_TERMINAL_OUTPUT_H
#define PORT_TERMINAL_OUTPUT_H

#include "encode.h"
#include "window_signals.h"

struct output {
    int fd;           /* -1: closed */
    bool kitty;       /* pictures of kitty's protocol may be cut short */
    bool entered;     /* the alternate screen is entered */
    struct text text; /* text to be sent: [sent, text.count) */
    size_t sent;

    struct terminal_stops since; /* counts of stops when the window was last taken */
};

/* Takes the window if it is in front; the guardian gives it back if this process dies or is stopped. */
void output_enter(struct output *output);

/* Gives the window back, if this process has it: within 150 ms, or later by the guardian if the terminal accepts
 * nothing. Text that is still to be sent is dropped. */
void output_leave(struct output *output);

/* True if the shell has or had the window, because of a stop. */
bool output_is_lost(const struct output *output);

/* Takes the window again: drops text that was to be sent before. The window still shows what the shell wrote. False in
 * the background. */
bool output_take(struct output *output);

/* True if text is still to be sent. */
bool output_is_left(const struct output *output);

/* Sends as much as the terminal accepts within timeout_ms in all (-1: no limit) and before a signal, and drops the text
 * once the window is lost. Returns TIA_OK, or TIA_ERR_DEVICE with errno. */
int output_send(struct output *output, int timeout_ms);

void output_free(struct output *output);

#endif
