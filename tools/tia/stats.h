/* stats.h - the figures of --stats. */
#ifndef TOOLS_TIA_STATS_H
#define TOOLS_TIA_STATS_H

#include <stdint.h>
#include <tia/viewer.h>

/* Number of samples that are stored, the newest ones, since a program may run for weeks. */
enum { STATS_SAMPLES = 65536 };

struct samples {
    uint64_t count;             /* number of all samples added */
    uint32_t us[STATS_SAMPLES]; /* ring buffer of the newest samples */
};

/* Statistics of the frames shown while the picture moves, if --fps sets a target frame rate. */
struct paced {
    uint64_t asked_us;      /* period of the target frame rate; 0: there is none */
    uint64_t sum_us, count; /* time between successive frames: sum and count */
    uint64_t last_us;       /* time of the last frame; 0: it was not moving */
    uint64_t blocks[5];     /* number of frames with blocks of 1, 2, 4, 8 and 16 pixels */
};

struct stats {
    uint64_t frames;
    struct samples draw, flip; /* draw time of each frame; time from a key press to its frame on screen */
    struct samples coarse;     /* time from a key press to the first picture, coarse or complete */
    bool answered;             /* a coarse picture with a key's effect was shown, the complete one not yet */
    const char *display, *format, *simd;
    unsigned width, height, threads;
    int scale_bits;              /* scale_bits of the scene */
    uint64_t pixels, all_pixels; /* number of drawn pixels, and of the pixels of all frames */
    bool gazes;                  /* a gaze is given, so that pixels are left out */
    struct paced paced;
};

/* Adds the latency of a picture: the time since the key press whose effect the picture shows; 0: it shows no new
 * effect. */
void stats_key(struct stats *stats, uint64_t us, bool coarse);

/* Adds a frame shown at time now_us. */
void stats_paced(struct paced *paced, const struct tia_frame *frame, uint64_t now_us);

void stats_add(struct samples *samples, uint64_t us);

/* Returns a percentile by nearest rank; 0 without samples. Sorts the samples, so none can be added afterwards. */
uint32_t stats_percentile(struct samples *samples, unsigned percent);

/* Prints one JSON object on one line of standard error; -1 when it cannot be written. */
int stats_print(struct stats *stats);

#endif
