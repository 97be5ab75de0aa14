/* measure.h - one frame drawn by several arithmetics, and how each misses the reference. */
#ifndef TIA_COMPARE_MEASURE_H
#define TIA_COMPARE_MEASURE_H

#include <tia/port.h>

#define MEASURE_CORES 2

/* What a pixel is, compared with the reference; the larger is the worse. */
enum verdict { SAME, ONE_LEVEL, MORE, FLIP };

/* Pixels of one arithmetic. identical + one + more = pixels. */
struct tally {
    uint64_t pixels, identical;
    uint64_t one;     /* the worst channel is off by one of its levels */
    uint64_t more;    /* by more */
    uint64_t flips;   /* another object is hit or other lights reach it, whatever its colour */
    uint64_t stray;   /* off by more than one level and no flip */
    uint64_t largest; /* difference of a channel, in its levels */
    uint64_t squares; /* of all channels' differences, full being 31 x 63 */
};

void tally_add(struct tally *sum, const struct tally *part);

/* Percentage identical, and the peak signal to noise ratio in decibels (infinite without errors). */
double tally_percent(const struct tally *tally);
double tally_psnr(const struct tally *tally);

/* Where the differences are: filled in when the caller gives the memory, width x height each. */
struct measure_map {
    tia_rgb565 *picture;                   /* the reference's */
    unsigned char *verdict[MEASURE_CORES]; /* enum verdict */
};

/* Draws `scene` with `reference` and each of `cores`, a band of rows at a time on the threads of
 * `workers`. A negative tia_status: the scene is refused, or no memory. */
int measure(const struct tia_scene *scene, unsigned width, unsigned height, const struct tia_core *reference,
            const struct tia_core *const *cores, unsigned core_count, const struct tia_workers *workers,
            void *workers_ctx, struct tally *tallies, const struct measure_map *map);

#endif
