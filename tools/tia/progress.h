/* progress.h - the progress of a long drawing, on standard error if that is a terminal. */
#ifndef TOOLS_TIA_PROGRESS_H
#define TOOLS_TIA_PROGRESS_H

#include <pthread.h>
#include <stdbool.h>
#include <stdint.h>

struct progress {
    bool terminal;
    uint64_t frame_pixels;
    uint32_t frames;
    pthread_mutex_t lock; /* protects the following members */
    uint64_t done;        /* pixels */
    bool shown;
    uint64_t next_us;
};

void progress_begin(struct progress *progress, uint64_t frame_pixels, uint32_t frames);

/* Adds completed pixels; call it from any thread. */
void progress_add(struct progress *progress, uint64_t pixels);

/* Erases the line. */
void progress_end(struct progress *progress);

#endif
