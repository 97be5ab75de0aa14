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
    char *why;             /* [PORT_WHY] */
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
};

struct port_input {
    const char *name, *summary;
    const struct tia_input *ops;
    void *(*create)(const struct port_wish *wish);
    void (*destroy)(void *ctx);
};

#endif
