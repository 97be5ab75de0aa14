/* port.h - what tia needs from the world outside: a display, an input, a clock.
 *
 * Every slot is mandatory. A port never exits, prints, or starts threads; on failure it returns
 * a negative tia_status and keeps the reason for whoever made its context.
 */
#ifndef TIA_PORT_H
#define TIA_PORT_H

#include <tia/render.h>

/* Keys by position on a US keyboard: letters and digits are their lower-case ASCII codes. */
enum tia_key {
    TIA_KEY_INTERRUPT = 3, /* Ctrl-C */
    TIA_KEY_ESCAPE = 27,
    TIA_KEY_LEFT = 0x100,
    TIA_KEY_RIGHT,
    TIA_KEY_UP,
    TIA_KEY_DOWN,
    TIA_KEY_PAGE_UP,
    TIA_KEY_PAGE_DOWN,
    TIA_KEY_OTHER /* any other typing key; modifiers and locks are no events */
};

enum tia_event_kind {
    TIA_EVENT_PRESS, /* a key went down; its release will be told */
    TIA_EVENT_RELEASE,
    TIA_EVENT_TAP /* a key was typed on a device that tells no releases */
};

struct tia_event {
    enum tia_event_kind kind;
    uint16_t key;     /* enum tia_key or ASCII */
    uint64_t time_us; /* when, on the clock below; 0 when the device does not say */
};

/* A display's size and needs. */
struct tia_mode {
    uint16_t width, height;
    uint16_t tile_width, tile_height; /* the largest tile it takes; 0: no limit */
    bool concurrent;                  /* acquire and submit may run on several threads at once */
    const char *format;               /* for people: "RGB565", "XRGB8888", ... */
};

struct tia_display {
    /* Takes the device. On failure nothing stays taken; close is safe all the same. */
    int (*open)(void *ctx, struct tia_mode *mode);
    /* The mode now: it may change while open (a terminal window, a replugged screen). TIA_HIDDEN
     * while the screen belongs to somebody else: nothing may be drawn then. */
    int (*mode)(void *ctx, struct tia_mode *mode);
    /* Memory for the pixels of `tile`, until submit. It may be write-combined: write only, in
     * rising addresses. What it holds before is not defined. */
    int (*acquire)(void *ctx, struct tia_tile tile, struct tia_surface *surface);
    /* These pixels are done. */
    int (*submit)(void *ctx, struct tia_tile tile);
    /* All tiles are done: shows the frame, at most waiting for the last one to be on screen. */
    int (*present)(void *ctx);
    /* Puts back what open changed. Safe after a failed open, and twice. */
    void (*close)(void *ctx);
};

struct tia_input {
    int (*open)(void *ctx);
    /* 1 and the next event, 0 when there is none, negative on failure. Never blocks. */
    int (*poll)(void *ctx, struct tia_event *event);
    /* Returns when an event or a signal is there, or after timeout_ms (-1: no limit; 0: only
     * lets pending signals in). Spurious returns are allowed. */
    int (*wait)(void *ctx, int timeout_ms);
    void (*close)(void *ctx);
};

struct tia_clock {
    uint64_t (*now_us)(void *ctx); /* microseconds, never backwards */
};

/* Runs job(arg, 0) .. job(arg, count - 1), in any order, on any threads, and returns when all
 * are done. Where a program has none, tia runs them in turn. */
struct tia_workers {
    void (*run)(void *ctx, void (*job)(void *arg, unsigned index), void *arg, unsigned count);
};

#endif
