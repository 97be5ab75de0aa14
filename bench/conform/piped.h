/* piped.h - draws trials by another program: it reads a line for each from standard input and writes the pixels. */
#ifndef BENCH_CONFORM_PIPED_H
#define BENCH_CONFORM_PIPED_H

#include "trial.h"

struct piped;

/* Starts `command` by sh. The program first writes a line with the name of its driver. For each trial it gets a line
 * with the decimal numbers of trial_numbers, and answers with the bytes of trial_take. Returns NULL on failure. */
struct piped *piped_open(const char *command);

/* Returns the driver's name. */
const char *piped_driver(const struct piped *piped);

/* A trial_drawer; `ctx` is a struct piped. */
bool piped_draw(void *ctx, const struct trial *trial, struct pixels *pixels);

void piped_close(struct piped *piped);

#endif
