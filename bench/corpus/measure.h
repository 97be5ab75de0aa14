/* measure.h - one picture drawn by several arithmetics, and how each misses a reference. */
#ifndef PORT_COMMON_MEASURE_H
#define PORT_COMMON_MEASURE_H

#include <tia/port.h>

#define MEASURE_CORES 2

/* What a pixel is, compared with the reference's; the larger is the worse. */
enum verdict { SAME, ONE_LEVEL, MORE, FLIP };

/* Pixels of one arithmetic. identical + one + more = pixels. */
struct tally {
    uint64_t pixels, identical;
    uint64_t one;     /* the worst channel is off by one of its levels */
    uint64_t more;    /* by more */
    uint64_t flips;   /* another object is hit or other lights reach it, whatever its colour */
    uint64_t stray;   /* off by more than one level and no flip */
    uint64_t largest; /* difference of a channel, in its levels */
    uint64_t astray;  /* the same, of pixels that are no flips */
    uint64_t squares; /* of all channels' differences, full being 31 x 63 */
};

void tally_add(struct tally *sum, const struct tally *part);

/* Percentage identical, and the peak signal to noise ratio in decibels (infinite without errors). */
double tally_percent(const struct tally *tally);
double tally_psnr(const struct tally *tally);

/* A pixel as one arithmetic has it; object and path_hash as in render.h. */
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
    void *workers_ctx;
    tia_rgb565 *picture; /* NULL, or width x height pixels for the reference's picture */

    /* NULL, or called for each pixel that is not the SAME: on any thread, on several at once. */
    void (*differs)(void *arg, unsigned core, enum verdict verdict, const struct measure_pixel *want,
                    const struct measure_pixel *got);
    void *arg;
};

/* Fills in a tally for each of the cores. A negative tia_status: the scene is refused, or no memory. */
int measure(const struct measure *what, struct tally *tallies);

#endif
