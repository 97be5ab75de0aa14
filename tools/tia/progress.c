#include "progress.h"

#include <stdio.h>
#include <unistd.h>

#include "clock.h"

/* Times. A drawing of less than half a second shows nothing; later a terminal is updated ten times a second, and other
 * outputs get a line once a second. */
enum { FIRST_US = 500000, STEP_US = 100000, LINE_US = 1000000 };

static const char erase[] = "\r\033[K";

/* Erases the line, in the handler of a signal. */
static void undo(void *arg)
{
    struct progress *progress = arg;
    if (progress->shown) {
        ssize_t wrote = write(STDERR_FILENO, erase, sizeof erase - 1);
        (void)wrote; /* a failure has no remedy */
    }
}

void progress_begin(struct progress *progress, uint64_t frame_pixels, uint32_t frames, bool asked)
{
    progress->terminal = isatty(STDERR_FILENO) == 1;
    progress->frame_pixels = frame_pixels;
    progress->frames = frames;
    (void)pthread_mutex_init(&progress->lock, NULL);
    progress->done = 0;
    progress->asked = asked;
    progress->begun_us = clock_now_us();
    progress->next_us = progress->begun_us + (progress->terminal ? FIRST_US : LINE_US);
    progress->cleanup = (struct signals_cleanup){.undo = undo, .arg = progress};
    signals_add(&progress->cleanup);
}

/* Returns the estimated number of seconds left, rounded up. */
static unsigned seconds_left(const struct progress *progress, uint64_t now)
{
    double all = (double)progress->frame_pixels * progress->frames, done = (double)progress->done;

    return (unsigned)((double)(now - progress->begun_us) * (all - done) / done / 1e6) + 1;
}

static void print(const struct progress *progress, uint64_t now)
{
    uint64_t done = progress->done;

    if (progress->terminal)
        (void)fputc('\r', stderr);
    if (progress->text[0]) {
        (void)fprintf(stderr, "drawing: %s", progress->text);
    } else if (progress->frames > 1) {
        (void)fprintf(stderr, "drawing: %u of %u frames, %u %% of the next", (unsigned)(done / progress->frame_pixels),
                      (unsigned)progress->frames,
                      (unsigned)(done % progress->frame_pixels * 100 / progress->frame_pixels));
    } else {
        (void)fprintf(stderr, "drawing: %3u %%", (unsigned)(done * 100 / progress->frame_pixels));
    }
    if (progress->asked && !progress->text[0])
        (void)fprintf(stderr, ", %u s left", seconds_left(progress, now));
    (void)fputs(progress->terminal ? "\033[K" : "\n", stderr);
    (void)fflush(stderr);
}

/* Shows the progress; the caller holds the lock. */
static void show(struct progress *progress, uint64_t now)
{
    if (now < progress->next_us)
        return;
    print(progress, now);
    progress->shown = progress->terminal;
    progress->next_us = now + (progress->terminal ? STEP_US : LINE_US);
}

void progress_add(struct progress *progress, uint64_t pixels)
{
    bool told = progress->terminal || progress->asked;
    uint64_t now = told ? clock_now_us() : 0;

    (void)pthread_mutex_lock(&progress->lock);
    progress->done += pixels;
    if (told && progress->done < progress->frame_pixels * progress->frames)
        show(progress, now);
    (void)pthread_mutex_unlock(&progress->lock);
}

void progress_say(struct progress *progress, const char *text)
{
    (void)pthread_mutex_lock(&progress->lock);
    (void)snprintf(progress->text, sizeof progress->text, "%s", text);
    if (progress->terminal || progress->asked)
        show(progress, clock_now_us());
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
