/* lightfield_setup.h - pictures for light-field displays, from the command line: the views, modules or panel for which
 * a scene with an observer line is drawn, see tia/lightfield_setup.h. */
#ifndef TOOLS_TIA_LIGHTFIELD_SETUP_H
#define TOOLS_TIA_LIGHTFIELD_SETUP_H

#include "lightfield_options.h"
#include "options.h"

/* Checks the options without the scene. Returns EXIT_FINE, or the exit status after an error message. */
int light_check(struct options *options);

/* Applies the options to the scene, whose light field they set. Returns as light_check. */
int light_load(struct options *options);

/* Points the scene to the light field in `options`; to be called after `options` was copied. */
void light_attach(struct options *options);

#endif
