#include "progress.h"

#include <stdio.h>
#include <unistd.h>

#include "clock.h"

/* Shows nothing for drawings of less than half a second; then updates ten times a second. */
enum { FIRST_US = 500000, STEP_US = 100000 };

static const char erase[] = "\r\033[K";

/* In the handler of a signal. */
static void undo(void *arg)
{
    struct progress *progress = arg;
    if (progress->shown) {
        ssize_t wrote = write(STDERR_FILENO, erase, sizeof erase - 1);
        (void)wrote; /* nothing is left to do about it */
    }
}

void progress_begin(struct progress *progress, uint64_t frame_pixels, uint32_t frames)
{
    progress->terminal = isatty(STDERR_FILENO) == 1;
    progress->frame_pixels = frame_pixels;
    progress->frames = frames;
    (void)pthread_mutex_init(&progress->lock, NULL);
    progress->done = 0;
    progress->next_us = clock_now_us() + FIRST_US;
    progress->cleanup = (struct signals_cleanup){.undo = undo, .arg = progress};
    signals_add(&progress->cleanup);
}

static void print(const struct progress *progress, uint64_t done)
{
    if (progress->frames > 1) {
        (void)fprintf(stderr, "\rdrawing: %u of %u frames, %u %% of the next",
                      (unsigned)(done / progress->frame_pixels), (unsigned)progress->frames,
                      (unsigned)(done % progress->frame_pixels * 100 / progress->frame_pixels));
    } else {
        (void)fprintf(stderr, "\rdrawing: %3u %%", (unsigned)(done * 100 / progress->frame_pixels));
    }
    (void)fputs("\033[K", stderr);
    (void)fflush(stderr);
}

void progress_add(struct progress *progress, uint64_t pixels)
{
    uint64_t now = progress->terminal ? clock_now_us() : 0;

    (void)pthread_mutex_lock(&progress->lock);
    progress->done += pixels;
    if (now >= progress->next_us && progress->done < progress->frame_pixels * progress->frames) {
        print(progress, progress->done);
        progress->shown = true;
        progress->next_us = now + STEP_US;
    }
    (void)pthread_mutex_unlock(&progress->lock);
}

void progress_erase(struct progress *progress)
{
    if (progress->shown)
        (void)fputs(erase, stderr);
    progress->shown = false;
}

void progress_end(struct progress *progress)
{
    progress_erase(progress);
    signals_remove(&progress->cleanup);
}
