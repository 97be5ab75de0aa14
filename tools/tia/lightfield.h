/* lightfield.h - pictures for light-field displays, from the command line: what of a scene with an observer line is
 * drawn for whom, see tia/lightfield.h. */
#ifndef TOOLS_TIA_LIGHTFIELD_H
#define TOOLS_TIA_LIGHTFIELD_H

#include "lightfield_options.h"
#include "options.h"

/* Takes one of its options. EXIT_FINE, or EXIT_USAGE after an error message. */
int light_parse(struct options *options, int option, char *value);

/* What the command line says by itself; then what it says of the scene, which gets its field. */
int light_check(struct options *options);
int light_load(struct options *options);

/* The scene's field is that of these options, which have been copied. */
void light_attach(struct options *options);

#endif
