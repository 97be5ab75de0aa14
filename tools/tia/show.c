/* show.c - chooses a display and an input, and runs the viewer on them. */
#include "show.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "common/signals.h"
#include "draw.h"
#include "fail.h"
#include "ports.h"
#include "session.h"
#include "unused.h"

static const struct port_display *find_display(const char *name)
{
    const struct port_display *port = port_displays;
    while (port->name && strcmp(port->name, name) != 0)
        port++;
    return port->name ? port : NULL;
}

static const struct port_input *find_input(const char *name)
{
    const struct port_input *port = port_inputs;
    while (port->name && strcmp(port->name, name) != 0)
        port++;
    return port->name ? port : NULL;
}

/* ---- the input for a display ---- */

static int refuse_input(struct session *session, const char *name)
{
    (void)snprintf(session->why, PORT_WHY, "%.40s: this build has no such input", name);
    return EXIT_INPUT;
}

static int open_input(struct session *session, const char *name)
{
    const struct port_input *port = find_input(name);
    return port ? session_open_input(session, port) : refuse_input(session, name);
}

/* Chooses the input. A display that takes over the console needs a way to end: an input, or a limit on the frames. */
static int choose_input(struct session *session, const struct port_display *port)
{
    const struct options *options = session->options;
    bool limited = options->frames != 0;
    if (strcmp(options->input.name, "none") == 0) {
        if (port->takes_screen && !limited) {
            (void)snprintf(session->why, PORT_WHY, "%s: no input to leave the screen by (use --frames N)", port->name);
            return EXIT_INPUT;
        }
        return open_input(session, "none");
    }
    if (strcmp(options->input.name, "auto") != 0)
        return open_input(session, options->input.name);
    if (port->takes_screen)
        return open_input(session, "evdev");
    bool terminal = strcmp(port->name, "terminal") == 0 && !options->in_line && options->frames != 1;
    if (!terminal && (limited || isatty(STDIN_FILENO) == 0))
        return open_input(session, "none");
    int status = open_input(session, "tty");
    return status != EXIT_FINE && limited ? open_input(session, "none") : status;
}

/* ---- the display ---- */

static int try_display(struct session *session, const struct port_display *port)
{
    int status = choose_input(session, port);
    if (status == EXIT_FINE)
        status = session_open_display(session, port);
    if (status == EXIT_FINE)
        status = session_run(session);
    session_close(session);
    return status;
}

/* True if `auto` tries the display; others must be named. */
static bool is_automatic(const struct port_display *port)
{
    if (strcmp(port->name, "terminal") == 0)
        return isatty(STDOUT_FILENO) != 0;
    return strcmp(port->name, "drm") == 0 || strcmp(port->name, "fbdev") == 0;
}

static int draw_instead(struct options *options)
{
    struct options file = *options;
    struct unused unused;
    file.frames = 0; /* a file has one picture, whatever the value of --frames */
    file.format = image_format_built(IMAGE_PNG) ? IMAGE_PNG : IMAGE_PPM;
    file.output = unused.path;
    if (!unused_create(&unused, image_format_name(file.format)))
        return fail(EXIT_RUNNING, "%s: %s", unused.path, strerror(errno));
    int status = draw(&file);
    unused_end(&unused);
    if (status == EXIT_FINE)
        note("no display and no terminal: wrote %s (tia --list-displays says why)", unused.path);
    return status;
}

static int show_any(struct session *session)
{
    for (const struct port_display *port = port_displays; port->name; port++) {
        if (!is_automatic(port))
            continue;
        int status = try_display(session, port);
        bool named =
            strcmp(session->options->input.name, "auto") != 0 && strcmp(session->options->input.name, "none") != 0;
        bool refused = status == EXIT_DISPLAY || (status == EXIT_INPUT && !named);
        if (!refused || session->letterbox.opened)
            return status;
    }
    session->why[0] = '\0';
    signals_release();
    return draw_instead(session->options);
}

static int show_named(struct session *session, const char *name)
{
    const struct port_display *port = find_display(name);
    if (!port) {
        (void)snprintf(session->why, PORT_WHY, "%.40s: this build has no such display (tia --list-displays)", name);
        return EXIT_DISPLAY;
    }
    return try_display(session, port);
}

int show(struct options *options)
{
    struct session *session = session_create(options);
    if (!session)
        return fail(EXIT_RUNNING, "memory: exhausted");
    bool any = strcmp(options->display.name, "auto") == 0;
    int status = any ? show_any(session) : show_named(session, options->display.name);
    if (status != EXIT_FINE && session->why[0] != '\0')
        (void)fail(status, "%s", session->why);
    return session_end(session, status);
}

/* Draws a picture with a gaze into a file, by the display "none", since a gaze needs the whole picture in memory. */
int show_into_file(struct options *options)
{
    struct session *session;

    options->display.name = options->input.name = "none";
    options->frames = 1;
    options->width = options->width ? options->width : 640;
    options->height = options->height ? options->height : 480;
    session = session_create(options);
    if (!session)
        return fail(EXIT_RUNNING, "memory: exhausted");
    session->save_to = options->output;
    int status = show_named(session, options->display.name);
    if (status != EXIT_FINE && session->why[0] != '\0')
        (void)fail(status, "%s", session->why);
    return session_end(session, status);
}

/* ---- lists ---- */

static void print_line(void *arg, const char *text)
{
    (void)arg;
    (void)printf("  %s\n", text);
}

/* Prints whether an input can be opened; a display that takes over the console needs it. */
static void print_input(const char *name)
{
    const struct port_input *port = find_input(name);
    char why[PORT_WHY] = "this build has none";
    struct port_wish wish = {.why = why};
    void *ctx = port ? port->create(&wish) : NULL;
    if (ctx) {
        if (!port->ops->open(ctx))
            (void)snprintf(why, sizeof why, "works");
        port->ops->close(ctx);
        port->destroy(ctx);
    }
    (void)printf("  input %s: %s\n", name, why);
}

int show_list(const char *only)
{
    bool found = false;
    for (const struct port_display *port = port_displays; port->name; port++) {
        if (!only || strcmp(port->name, only) == 0) {
            (void)printf("%s: %s\n", port->name, port->summary);
            port->list(print_line, NULL);
            if (port->takes_screen)
                print_input("evdev");
            found = true;
        }
    }
    if (only && !found)
        return fail(EXIT_DISPLAY, "%s: this build has no such display (tia --list-displays)", only);
    return fflush(stdout) == 0 ? EXIT_FINE : fail_output();
}
