#include "progress.h"

#include <stdio.h>
#include <unistd.h>

#include "common/clock.h"

/* What is done within half a second needs no word; then ten times a second is smooth enough. */
enum { FIRST_US = 500000, STEP_US = 100000 };

void progress_begin(struct progress *progress)
{
    *progress = (struct progress){.terminal = isatty(STDERR_FILENO) == 1, .start_us = clock_now_us()};
    progress->next_us = progress->start_us + FIRST_US;
}

void progress_update(struct progress *progress, unsigned done, unsigned total)
{
    uint64_t now = clock_now_us();
    if (!progress->terminal || now < progress->next_us) {
        return;
    }
    (void)fprintf(stderr, "\rdrawing: %3u %%", (unsigned)((uint64_t)done * 100 / total));
    (void)fflush(stderr);
    progress->shown = true;
    progress->next_us = now + STEP_US;
}

void progress_end(struct progress *progress)
{
    if (progress->shown) {
        (void)fputs("\r\033[K", stderr);
    }
    progress->shown = false;
}
