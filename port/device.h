/* device.h - the table rows of a display and of an input: functions (tia/port.h), and name and summary for the command
 * line.
 *
 * The reason for a failure is one line without a full stop, in the form "WHAT: WHY" or "WHAT: WHY (FIX)", written to
 * the `why` that was passed to create.
 */
#ifndef PORT_DEVICE_H
#define PORT_DEVICE_H

#include <tia/port.h>

#define PORT_WHY 256

/* The user's settings for a device. A member that is zero leaves the choice to the device. */
struct port_wish {
    const char *device; /* path of a node, or a port's own name; NULL: the first that works */
    uint16_t width, height;
    const char *connector; /* DRM: a connector's name, or NULL */
    const char *mode;      /* DRM: "preferred", "WxH" or "WxH@R", or NULL */
    bool pointer;          /* the input must also report a pointer */
    bool in_line;          /* a terminal: print frames one below the other into the scrollback, and leave them there */
    bool row;              /* the display leaves a row of characters below the picture free, if it has text */
    char *why;             /* [PORT_WHY] */
};

/* Text that a display shows as characters, in its window's last row and over its picture. NULL or empty: none. Strings
 * stay valid until the next text or until close. */
struct port_text {
    const char *status;        /* parts of the last row, separated by tabs, the most important first */
    const char *notes;         /* lines in the upper left corner, wrapped; not shown while there is a panel */
    const char *window_title;  /* the window's title, if there is a window; without control characters */
    const char *title, *panel; /* the panel: its lines are "WHAT\tTEXT", in ASCII */
    const char *scroll;        /* how to scroll the panel: shown beside the title if it has more lines than fit */
    unsigned first; /* the panel's first line to show, from 0; the display lowers it to the last that fills the panel */
    bool more;      /* set by the display: the panel has more lines than fit */
};

/* Receives one line of text about a device, for --list-displays. */
typedef void port_line(void *arg, const char *text);

struct port_display {
    const char *name, *summary;
    bool takes_screen; /* takes over the console, so an input or a limit on the frames must end it */
    const struct tia_display *ops;
    void *(*create)(const struct port_wish *wish); /* returns NULL on failure, with the reason in wish->why */
    void (*destroy)(void *ctx);                    /* call it after close */
    /* Prints each device found, its modes and formats, or the reason why it cannot be opened. */
    void (*list)(port_line *line, void *arg);
    /* NULL if the display has pixels alone. Sets the text that the next `present` shows, and sets text->first and
     * text->more; the text itself must stay valid, too. */
    void (*text)(void *ctx, struct port_text *text);
};

struct port_input {
    const char *name, *summary;
    const struct tia_input *ops;
    void *(*create)(const struct port_wish *wish);
    void (*destroy)(void *ctx);
};

#endif
