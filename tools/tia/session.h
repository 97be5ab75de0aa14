/* session.h - one display, one input and the interactive loop on them. */
#ifndef TOOLS_TIA_SESSION_H
#define TOOLS_TIA_SESSION_H

#include <stdio.h>

#include "common/light_copy.h"
#include "common/thread_pool.h"
#include "letterbox.h"
#include "move.h"
#include "options.h"
#include "overlay.h"
#include "pointed.h"
#include "ports.h"
#include "progress.h"
#include "stats.h"

struct session {
    struct options *options;
    char why[PORT_WHY];                 /* reason for the last failure */
    char last[PORT_WHY];                /* message to print after the display is closed; empty: none */
    const struct port_display *display; /* NULL: not open */
    const struct port_input *input;
    void *display_ctx, *input_ctx;
    struct letterbox letterbox;
    struct progress progress; /* of pictures that are printed, if letterbox.drawn is set */
    struct tia_mode mode;
    struct threads *pool;
    struct lights lights;
    struct tia_scene variant; /* copy of the scene with the shadow technique that a key has chosen */
    struct overlay overlay;
    struct tia_viewer_state viewer; /* the changes that keys have made */
    struct pointed pointed;
    struct moves moves;
    bool is_moved;       /* keys and the mouse move the eye: in all scenes but the built-in one */
    const char *save_to; /* NULL, or the file to which the first complete picture is written, in options->format */
    void *memory;        /* the viewer's memory */
    size_t memory_bytes;
    FILE *lines; /* output of checksums: standard output, or memory until the display is closed */
    char *text;
    size_t text_bytes;
    struct stats stats;
    char format[32]; /* copy of the display's format, since it is printed after closing */
};

/* Creates a session. Until session_end, signals are only noted, see common/signals.h. NULL: no memory. */
struct session *session_create(struct options *options);

/* Opens the input. Returns the exit status; if it is not 0, session->why has the reason. */
int session_open_input(struct session *session, const struct port_input *port);
/* Opens the display. Returns as session_open_input does. */
int session_open_display(struct session *session, const struct port_display *port);
/* Runs the viewer. Returns as session_open_input does. */
int session_run(struct session *session);

/* Closes the display, then the input. */
void session_close(struct session *session);

/* Frees the session and returns `status`; if a signal has come, ends the program with that signal. */
int session_end(struct session *session, int status);

#endif
