/* draw.h - one picture into a file. */
#ifndef TOOLS_TIA_DRAW_H
#define TOOLS_TIA_DRAW_H

#include "options.h"

/* Draws options->output. Returns the exit status, after one line on standard error if not 0. */
int draw(const struct options *options);

#endif
