/* progress.h - the progress of a long drawing, on standard error if that is a terminal or --progress is given: one
 * line, and the title of the terminal's window. */
#ifndef TOOLS_TIA_PROGRESS_H
#define TOOLS_TIA_PROGRESS_H

#include <pthread.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>

#include "common/signals.h"
#include "options.h"

#define PROGRESS_TEXT 64
#define PROGRESS_NAME 48

struct progress {
    bool terminal, titles;       /* titles: the window has a title that can be put back */
    bool asked;                  /* asked: show the times, and lines without a terminal */
    char name[PROGRESS_NAME];    /* the scene; empty: the built-in one */
    uint64_t begun_us, start_us; /* begin of the command's work, and of the drawing */
    uint32_t frames;
    pthread_mutex_t lock; /* protects the following members */
    uint64_t frame_work;  /* work of a frame: pixels, or in another unit after progress_weigh */
    uint64_t done;        /* work that is done */
    uint64_t skipped;     /* part of `done` that took no time */
    uint64_t next_us;
    char text[PROGRESS_TEXT];       /* more about the drawing; empty: none */
    double share, left;             /* the share done and seconds left of progress_say; negative: `done` tells them */
    atomic_bool titled;             /* the window has the title of the drawing */
    atomic_bool shown;              /* the line is on the terminal */
    struct signals_cleanup cleanup; /* erases the line */
};

/* Begins to show progress. Call it and progress_end on the main thread: see common/signals.h. */
void progress_begin(struct progress *progress, const struct options *options, uint64_t frame_pixels, uint32_t frames);

/* Returns true if progress is shown at all. */
bool progress_shows(const struct progress *progress);

/* Tells that all is prepared, and that a frame is begun. The time of the drawing begins with the first one. */
void progress_start(struct progress *progress);

/* Changes the unit of work, which is a pixel before: `done` of `all` is done in the picture. */
void progress_weigh(struct progress *progress, uint64_t done, uint64_t all);

/* Adds completed work; may be called on any thread. */
void progress_add(struct progress *progress, uint64_t work);
/* Adds work that was known. */
void progress_skip(struct progress *progress, uint64_t work);

/* Shows `text` from now on, and this share, 0 to 1, and seconds left. Negative ones are estimated from the work done.
 */
void progress_say(struct progress *progress, const char *text, double share, double left);

#define PROGRESS_TIME 32
/* Prints a time: "4.2 s", "58 s", "3 min 05 s", "2 h 10 min". */
void progress_time(char text[PROGRESS_TIME], double seconds);

/* Erases the line, which may be shown again. */
void progress_erase(struct progress *progress);
/* A letterbox's `drawn`: adds the pixels of a tile; with 0 erases the line, since a picture is shown. */
void progress_drawn(void *progress, uint64_t pixels);
/* Erases the line for good. */
void progress_end(struct progress *progress);

#endif
