/* progress.h - the progress of a long drawing, on standard error if that is a terminal or --progress is given. */
#ifndef TOOLS_TIA_PROGRESS_H
#define TOOLS_TIA_PROGRESS_H

#include <pthread.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>

#include "common/signals.h"

#define PROGRESS_TEXT 80

struct progress {
    bool terminal, asked; /* asked: show the time left, and lines without a terminal */
    uint64_t begun_us;
    uint64_t frame_pixels;
    uint32_t frames;
    pthread_mutex_t lock; /* protects the following members */
    uint64_t done;        /* number of pixels drawn */
    uint64_t next_us;
    char text[PROGRESS_TEXT];       /* text shown instead of a percentage; empty: none */
    atomic_bool shown;              /* the line is on the terminal */
    struct signals_cleanup cleanup; /* erases the line */
};

/* Begins to show progress. Call it and progress_end on the main thread: see common/signals.h. */
void progress_begin(struct progress *progress, uint64_t frame_pixels, uint32_t frames, bool asked);

/* Adds completed pixels; may be called on any thread. */
void progress_add(struct progress *progress, uint64_t pixels);

/* Shows `text` in place of the percentage from now on. */
void progress_say(struct progress *progress, const char *text);

/* Erases the line, which may be shown again. */
void progress_erase(struct progress *progress);
/* Erases the line for good. */
void progress_end(struct progress *progress);

#endif
