/* stats.h - the figures of --stats. */
#ifndef TOOLS_TIA_STATS_H
#define TOOLS_TIA_STATS_H

#include <stdint.h>

/* Keeps only the newest samples, since a program may run for weeks. */
enum { STATS_SAMPLES = 65536 };

struct samples {
    uint64_t count;             /* samples added in all */
    uint32_t us[STATS_SAMPLES]; /* ring buffer */
};

struct stats {
    uint64_t frames;
    struct samples draw, flip; /* draw time of each frame; time from a key press to its frame on screen */
    struct samples coarse;     /* and to the first coarse picture of it, where there was one */
    const char *display, *format, *level;
    unsigned width, height, threads, scale_bits; /* the last: of the scene */
};

void stats_add(struct samples *samples, uint64_t us);

/* A percentile by nearest rank; 0 without samples. Sorts the samples, so none can be added afterwards. */
uint32_t stats_percentile(struct samples *samples, unsigned percent);

/* Prints one JSON object on one line of standard error; -1 when it cannot be written. */
int stats_print(struct stats *stats);

#endif
