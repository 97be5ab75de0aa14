/* lightfield.h - pictures for light-field displays, from the command line: what of a scene with an observer line is
 * drawn for whom, see tia/lightfield.h. */
#ifndef TOOLS_TIA_LIGHTFIELD_H
#define TOOLS_TIA_LIGHTFIELD_H

#include "lightfield_options.h"
#include "options.h"

/* Checks the options by themselves; then loads what they say of the scene, which gets its field. EXIT_FINE, or the
 * status after an error message. */
int light_check(struct options *options);
int light_load(struct options *options);

/* The scene's field is that of these options, which have been copied. */
void light_attach(struct options *options);

#endif
