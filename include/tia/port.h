/* port.h - the interfaces that a platform implements: a display, an input, a clock.
 *
 * Every function pointer must be set, unless its comment allows NULL: tia_viewer_run returns TIA_ERR_ARGUMENT when one
 * that it needs is NULL. A port never exits, prints, or starts threads. On failure it returns a negative enum
 * tia_status and stores the reason in its context, for the program to print.
 */
#ifndef TIA_PORT_H
#define TIA_PORT_H

#include <tia/job.h>
#include <tia/render.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Keys by their position on a US keyboard. Letters and digits have their lower-case ASCII codes. */
enum tia_key {
    TIA_KEY_INTERRUPT = 3, /* Ctrl-C */
    TIA_KEY_TAB = 9,
    TIA_KEY_ESCAPE = 27,
    TIA_KEY_SPACE = ' ',
    TIA_KEY_PLUS = '+',  /* also = */
    TIA_KEY_MINUS = '-', /* also _ */
    TIA_KEY_HELP = '?',  /* also / */
    TIA_KEY_LEFT = 0x100,
    TIA_KEY_RIGHT,
    TIA_KEY_UP,
    TIA_KEY_DOWN,
    TIA_KEY_PAGE_UP,
    TIA_KEY_PAGE_DOWN,
    TIA_KEY_HOME,
    TIA_KEY_OTHER /* any other key, except modifiers and locks, which cause no events */
};

enum tia_event_kind {
    TIA_EVENT_PRESS, /* a key went down; a release event follows */
    TIA_EVENT_RELEASE,
    TIA_EVENT_TAP,   /* a key was typed on a device that does not report releases, such as a terminal */
    TIA_EVENT_POINT, /* a pointer is at x, y */
    TIA_EVENT_MOVE   /* a mouse has moved by x, y */
};

struct tia_event {
    enum tia_event_kind kind;
    uint16_t key;     /* enum tia_key or ASCII */
    bool shift;       /* for a key that moves a light or the camera: typed with Shift */
    bool drag;        /* for a pointer: its left button is down, or a finger touches */
    uint64_t time_us; /* time by struct tia_clock; 0 when the device does not report times */
    /* A pointer's position or movement, to the right and down. A position is 0..65535, in units of 2^-16 of the
     * display's width and height; a movement is -32767..32767, in units of roughly a pixel. */
    int32_t x, y;
};

/* A display's size and limits. */
struct tia_mode {
    uint16_t width, height;           /* pixels */
    uint16_t tile_width, tile_height; /* the largest tile that acquire accepts; 0: no limit */
    bool concurrent;                  /* acquire and submit may run on several threads at once */
    const char *format;               /* the device's pixel format, for messages: "RGB565", "XRGB8888", ... */
};

/* A display. For each frame the caller acquires, fills and submits tiles until they cover the screen, then presents.
 * Each function but close returns an enum tia_status. All but go_on must be set. */
struct tia_display {
    /* Acquires the device and fills in its mode. After a failure nothing stays acquired; close is still safe. */
    int (*open)(void *ctx, struct tia_mode *mode);
    /* Gives the current mode, 1..TIA_SIZE_MAX pixels in both directions; it may change while the display is open (a
     * resized terminal window, another screen plugged in). Returns TIA_HIDDEN while another program has the screen: do
     * not draw then. TIA_BUSY, with the mode, if the last frame must be shown again: see go_on. */
    int (*mode)(void *ctx, struct tia_mode *mode);
    /* Gives memory for the pixels of `tile`, valid until submit. The memory may be write-combining, so that reads are
     * slow: only write to it, in order of rising addresses. Its contents are undefined at first. If surfaces have
     * `swap`, the caller sets it to false before; a display whose pixels have the other byte order sets it to true,
     * which the caller heeds. */
    int (*acquire)(void *ctx, struct tia_tile tile, struct tia_surface *surface);
    /* Takes the tile's pixels, which are complete. */
    int (*submit)(void *ctx, struct tia_tile tile);
    /* Shows the frame, which is complete. May wait until it is on screen, but no longer; a device that needs more than
     * about 20 ms for that, such as one on a slow serial line, returns TIA_BUSY and continues in go_on. */
    int (*present)(void *ctx);
    /* Restores what open changed. Safe after a failed open, and when called twice. */
    void (*close)(void *ctx);
    /* Continues, for about 20 ms, to show the frame that present began or for which `mode` returned TIA_BUSY; returns
     * TIA_BUSY if the frame is not complete then. NULL if the display never returns TIA_BUSY. Between two calls the
     * caller may poll its input, close the display, or draw the next frame, which is shown after this one. */
    int (*go_on)(void *ctx);
};

struct tia_input {
    int (*open)(void *ctx);
    /* Gives the next event and returns 1; returns 0 when there is none, and a negative status on failure. Never
     * blocks. */
    int (*poll)(void *ctx, struct tia_event *event);
    /* Waits for an event or a signal, at most timeout_ms (-1: no limit; 0: only delivers pending signals). It may
     * return early without a reason. */
    int (*wait)(void *ctx, int timeout_ms);
    void (*close)(void *ctx);
};

struct tia_clock {
    uint64_t (*now_us)(void *ctx); /* returns microseconds since any fixed moment; never goes backwards */
};

#ifdef __cplusplus
}
#endif

#endif
