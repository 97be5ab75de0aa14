/* piped.h - draws trials by another program: it reads a line for each from standard input and writes the pixels. */
#ifndef BENCH_CONFORM_PIPED_H
#define BENCH_CONFORM_PIPED_H

#include "trial.h"

struct piped;

/* Starts `command` by sh. The program first writes a line with the name of its driver. For each trial it gets a line of
 * decimal numbers: the number of triangles and the stencil value at first; then for each triangle x and y of its
 * corners in 1/256 pixel, its level, the test of depth (enum tia_compare), whether it writes depth, whether it writes
 * colours, whether front and back faces are culled; and for front faces, then for back faces, test, reference, mask and
 * written bits of the stencil and its operations fail, zfail, zpass (enum tia_stencil_op). It answers with SIDE x SIDE
 * bytes, the top row first: the number of the triangle that a pixel shows, 255 for none; and as many with the stencil
 * values. Returns NULL on failure. */
struct piped *piped_open(const char *command);

/* Returns the driver's name. */
const char *piped_driver(const struct piped *piped);

/* A trial_drawer; `ctx` is a struct piped. */
bool piped_draw(void *ctx, const struct trial *trial, struct pixels *pixels);

void piped_close(struct piped *piped);

#endif
