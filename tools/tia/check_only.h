/* check_only.h - tia --check SCENE ...: the mistakes of scenes, for editors and scripts. */
#ifndef TOOLS_TIA_CHECK_ONLY_H
#define TOOLS_TIA_CHECK_ONLY_H

#include "options.h"

/* Reads each scene, and prints its mistakes and warnings. Returns EXIT_FINE, or EXIT_RUNNING if one of the scenes
 * cannot be read. */
int check_only(const struct options *options);

#endif
