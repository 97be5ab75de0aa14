/* device.h - a display or an input of this program: its functions (tia/port.h), and its data for the command line.
 *
 * The reason for a failure is one line without a full stop, in the form "WHAT: WHY" or "WHAT: WHY (FIX)", written to
 * the `why` that was passed to create.
 */
#ifndef PORT_DEVICE_H
#define PORT_DEVICE_H

#include <tia/port.h>

#define PORT_WHY 256

/* The user's wishes; zero means the device's own choice. */
struct port_wish {
    const char *device; /* a node, or NULL: the first that works */
    uint16_t width, height;
    const char *connector; /* DRM: a connector's name, or NULL */
    const char *mode;      /* DRM: "preferred", "WxH" or "WxH@R", or NULL */
    bool pointer;          /* the input is to report its pointer's position */
    char *why;             /* [PORT_WHY] */
};

/* One line of text about a device, for --list-displays. */
typedef void port_line(void *arg, const char *text);

struct port_display {
    const char *name, *summary;
    bool takes_screen; /* covers the console: must not be opened without an input */
    const struct tia_display *ops;
    void *(*create)(const struct port_wish *wish); /* returns NULL on failure, with the reason in wish->why */
    void (*destroy)(void *ctx);                    /* to be called after close */
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
