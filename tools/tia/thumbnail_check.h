/* thumbnail_check.h - the options of --thumbnail. */
#ifndef TOOLS_TIA_THUMBNAIL_CHECK_H
#define TOOLS_TIA_THUMBNAIL_CHECK_H

#include "options.h"

/* Checks the options of --thumbnail and sets those that follow from it. Returns EXIT_FINE, also without --thumbnail, or
 * EXIT_USAGE after an error message. */
int thumbnail_check(struct options *options);

#endif
