/* measure.h - draws a picture in several arithmetics and compares each with a reference. */
#ifndef TOOLS_COMMON_CORPUS_MEASURE_H
#define TOOLS_COMMON_CORPUS_MEASURE_H

#include <tia/port.h>

#define MEASURE_CORES 3

/* The result of comparing a pixel with the reference, from best to worst. */
enum verdict { SAME, ONE_LEVEL, MORE, FLIP };

/* Counts for one arithmetic. identical + one + more = pixels. */
struct tally {
    uint64_t pixels, identical;
    uint64_t one;     /* the worst channel differs by one level */
    uint64_t more;    /* the worst channel differs by more than one level */
    uint64_t flips;   /* pixels where another object is hit, or other lights are visible from the hit, whatever the
                         colour */
    uint64_t stray;   /* pixels that differ by more than one level on the same path */
    uint64_t largest; /* largest difference of a channel, in levels */
    uint64_t astray;  /* largest difference of a channel in pixels without a flip, in levels */
    uint64_t squares; /* sum of the squared differences of all channels, in units in which full intensity is 31 x 63 */
};

void tally_add(struct tally *sum, const struct tally *part);

/* Returns the percentage of identical pixels. */
double tally_percent(const struct tally *tally);
/* Returns the peak signal-to-noise ratio in decibels (infinite without errors). */
double tally_psnr(const struct tally *tally);

/* A pixel as drawn by one arithmetic; object and path_hash as in render.h. */
struct measure_pixel {
    unsigned x, y;
    tia_rgb565 colour;
    uint32_t object, path_hash;
};

struct measure {
    const struct tia_scene *scene;
    unsigned width, height;
    bool dither;
    const struct tia_core *reference;
    const struct tia_core *cores[MEASURE_CORES];
    unsigned core_count;
    const struct tia_workers *workers;
    tia_rgb565 *picture; /* NULL, or receives the width x height pixels of the reference's picture */

    /* NULL, or called for each pixel that is not SAME, possibly on several threads at once. */
    void (*differs)(void *arg, unsigned core, enum verdict verdict, const struct measure_pixel *want,
                    const struct measure_pixel *got);
    void *arg;
};

/* Fills a tally for each core. Returns a negative tia_status if the scene is invalid or memory runs out. */
int measure(const struct measure *what, struct tally *tallies);

#endif
