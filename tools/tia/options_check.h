/* options_check.h - checks that options, each valid by itself, go together. */
#ifndef TOOLS_TIA_OPTIONS_CHECK_H
#define TOOLS_TIA_OPTIONS_CHECK_H

#include "options.h"

/* Checks the options and sets the formats that are not given. EXIT_FINE, or EXIT_USAGE after an error message. */
int check(struct options *options);

/* Checks the options for the scene alone, and sets its format. */
int check_scene(struct options *options);

#endif
