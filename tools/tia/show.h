/* show.h - the picture on a display, changed by keys. */
#ifndef TOOLS_TIA_SHOW_H
#define TOOLS_TIA_SHOW_H

#include "options.h"

/* Both return the exit status, after one line on standard error if it is not 0. */
int show(const struct options *options);

/* Prints every display found, or (--connector help, --mode help) what `only` finds. */
int show_list(const char *only);

#endif
