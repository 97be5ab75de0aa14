/* draw.h - draws a picture or film into a file. */
#ifndef TOOLS_TIA_DRAW_H
#define TOOLS_TIA_DRAW_H

#include "options.h"

/* Draws options->output. Returns the exit status, after an error message if it is not 0. */
int draw(const struct options *options);

/* Draws as `draw` does, or by samples, as the options and the scene say. */
int draw_file(const struct options *options);

#endif
