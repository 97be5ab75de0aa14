/* check.h - checks that valid options are consistent. */
#ifndef TOOLS_TIA_CHECK_H
#define TOOLS_TIA_CHECK_H

#include "options.h"

/* Checks the options and fills in the formats that are not given. EXIT_FINE, or EXIT_USAGE after an error message. */
int check(struct options *options);

/* Does so for the scene alone: its format. */
int check_scene(struct options *options);

#endif
