/* against.h - a picture of the library held against the oracle's, pixel by pixel. */
#ifndef TESTS_ORACLE_AGAINST_H
#define TESTS_ORACLE_AGAINST_H

#include "oracle/oracle.h"

#include <tia/port.h>

#define AGAINST_NOTES 8
#define AGAINST_REACH 1e-9 /* of a pixel: a thousand times double's errors, far below those of q16 */

/* A pixel that differs. */
struct against_note {
    unsigned x, y;
    tia_rgb565 colour; /* the library's */
    uint32_t object, reached;
    struct oracle_pixel want;
};

struct against {
    uint64_t pixels, identical;
    uint64_t one;       /* colours off by one level */
    uint64_t flips;     /* another sphere is hit, or other lights reach it */
    uint64_t undecided; /* those of the flips that lie within AGAINST_REACH of a boundary */
    uint64_t stray;     /* colours off by more than one level and no flip */
    double margin;      /* of the pixels off by one level and no flip, the largest: what the errors reached */
    unsigned note_count;
    struct against_note notes[AGAINST_NOTES];
};

void against_add(struct against *sum, const struct against *part);

/* Draws `scene` with `core`, whose lights and spheres `truth` must describe too, and compares every
 * pixel with the oracle's picture of `truth`. A negative tia_status: it could not be drawn. */
int against_oracle(const struct tia_core *core, const struct tia_scene *scene, const struct tia_scene *truth,
                   unsigned width, unsigned height, bool dither, const struct tia_workers *workers, void *workers_ctx,
                   struct against *out);

#endif
