/* lightfield_setup.h - the options for light-field displays: the views, modules or panel for which a scene with an
 * observer line is drawn, see tia/lightfield.h. */
#ifndef TOOLS_TIA_LIGHTFIELD_SETUP_H
#define TOOLS_TIA_LIGHTFIELD_SETUP_H

#include "lightfield_options.h"
#include "options.h"

/* Checks the options without the scene. Returns EXIT_FINE, or the exit status after an error message. */
int light_check(struct options *options);

/* Applies the options to the scene: sets its light field. Returns as light_check does. */
int light_load(struct options *options);

/* Makes the scene point to the light field in `options`; call it after copying `options`. */
void light_attach(struct options *options);

#endif
