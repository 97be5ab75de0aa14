/* stats.h - the figures of --stats. */
#ifndef TOOLS_TIA_STATS_H
#define TOOLS_TIA_STATS_H

#include <stdint.h>

/* The newest samples only: a program may run for weeks. */
enum { STATS_SAMPLES = 65536 };

struct samples {
    uint64_t count;             /* ever added */
    uint32_t us[STATS_SAMPLES]; /* in a ring */
};

struct stats {
    uint64_t frames;
    struct samples draw, flip; /* of each frame; from a key to its frame on screen */
    const char *display, *format;
    unsigned width, height, threads;
};

void stats_add(struct samples *samples, uint64_t us);

/* The value that `percent` of the samples do not exceed (nearest rank); 0 without samples. Sorts
 * them: the end of adding. */
uint32_t stats_percentile(struct samples *samples, unsigned percent);

/* One JSON object on one line of standard error. */
void stats_print(struct stats *stats);

#endif
