/* progress.h - how far a long drawing has come, on standard error when that is a terminal. */
#ifndef TOOLS_TIA_PROGRESS_H
#define TOOLS_TIA_PROGRESS_H

#include <stdbool.h>
#include <stdint.h>

struct progress {
    bool terminal, shown;
    uint64_t start_us, next_us;
};

void progress_begin(struct progress *progress);
void progress_update(struct progress *progress, unsigned done, unsigned total);

/* Erases the line. */
void progress_end(struct progress *progress);

#endif
