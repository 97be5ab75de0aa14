/* lightfield_setup.h - pictures for light-field displays, from the command line: the views, modules or panel for which
 * a scene with an observer line is drawn, see tia/lightfield_setup.h. */
#ifndef TOOLS_TIA_LIGHTFIELD_SETUP_H
#define TOOLS_TIA_LIGHTFIELD_SETUP_H

#include "lightfield_options.h"
#include "options.h"

/* Check the options by themselves; apply them to the scene, which gets its field. EXIT_FINE, or the status after an
 * error message. */
int light_check(struct options *options);
int light_load(struct options *options);

/* Points the scene to the field of these options, after they have been copied. */
void light_attach(struct options *options);

#endif
