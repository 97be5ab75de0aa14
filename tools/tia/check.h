/* check.h - whether options that are right each for itself go together. */
#ifndef TOOLS_TIA_CHECK_H
#define TOOLS_TIA_CHECK_H

#include "options.h"

/* EXIT_FINE, or EXIT_USAGE after one line that says what is wrong. Settles the file's format and what is
 * to be done. */
int check(struct options *options);

#endif
