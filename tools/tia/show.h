/* show.h - shows the scene on a display. */
#ifndef TOOLS_TIA_SHOW_H
#define TOOLS_TIA_SHOW_H

#include "options.h"

/* Shows the scene. Returns the exit status, after an error message if it is not 0. */
int show(struct options *options);

/* Draws one picture with a gaze into options->output. Returns as `show` does. */
int show_into_file(struct options *options);

/* Lists every display found or, for --connector help and --mode help, those of the port `only`. Returns as `show`
 * does. */
int show_list(const char *only);

#endif
