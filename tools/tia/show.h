/* show.h - shows the scene on a display. */
#ifndef TOOLS_TIA_SHOW_H
#define TOOLS_TIA_SHOW_H

#include "options.h"

/* Both return the exit status, after an error message if it is not 0. */
int show(const struct options *options);

/* Lists every display found or, for --connector help and --mode help, those of the port `only`. */
int show_list(const char *only);

#endif
