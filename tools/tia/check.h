/* check.h - checks that valid options go together. */
#ifndef TOOLS_TIA_CHECK_H
#define TOOLS_TIA_CHECK_H

#include "options.h"

/* EXIT_FINE, or EXIT_USAGE after an error message. Fills in the formats that are not given. */
int check(struct options *options);

/* The same of the scene alone: its format. */
int check_scene(struct options *options);

#endif
