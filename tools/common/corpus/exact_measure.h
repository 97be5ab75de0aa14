/* exact_measure.h - draws a picture in several ways and compares each with the exact picture of docs/definition.md. */
#ifndef TOOLS_COMMON_CORPUS_EXACT_MEASURE_H
#define TOOLS_COMMON_CORPUS_EXACT_MEASURE_H

#include <tia/port.h>
#include <tia/simd.h>

#define EXACT_DRAWERS 10
#define EXACT_STAGES 4 /* precisions of 64, 128, 256 and 512 bits */

/* A way to draw: an arithmetic, in plain C or with vector units. */
struct exact_drawer {
    const char *name;
    const struct tia_core *core;
    const struct tia_simd *simd; /* NULL: plain C */
    bool approximate;            /* its pictures may differ: floating point */
};

/* The pixels that one drawer drew, those that differ, and the first of these. */
struct exact_drawn {
    uint64_t pixels, differ;
    unsigned x, y;
    tia_rgb565 want, got;
};

struct exact_tally {
    uint64_t pixels;              /* number of pixels compared */
    uint64_t stage[EXACT_STAGES]; /* number of pixels that 64 << i bits decide; their sum is `pixels` */
    uint64_t ties;
    struct exact_drawn by[EXACT_DRAWERS]; /* all 0 where a drawer does not draw the scene */
};

/* A picture to measure, and the ways to draw it. */
struct exact_measure {
    const struct tia_scene *scene;
    unsigned width, height;
    bool dither;
    uint32_t step; /* every `step`th pixel of the picture is compared, counted row by row */
    struct exact_drawer drawers[EXACT_DRAWERS];
    unsigned drawer_count;
    const struct tia_workers *workers;
};

/* Sets the drawers to plain C, the smaller code of tia_core_spheres_small, and all vector units of this machine. */
void exact_drawers(struct exact_measure *what);

/* Adds a drawer in another arithmetic. */
void exact_add(struct exact_measure *what, const struct tia_core *core);

/* Adds a tally to another one. */
void exact_tally_add(struct exact_tally *sum, const struct exact_tally *part);

/* Draws the picture in all ways and compares it. Returns a negative tia_status: TIA_ERR_UNSUPPORTED if the definition
 * does not cover the scene, TIA_ERR_RANGE if tia_scene_check refuses it, TIA_ERR_MEMORY. */
int exact_measure(const struct exact_measure *what, struct exact_tally *tally);

#endif
