/* integration.h - the options of integrators, and of what is shown of them. */
#ifndef TOOLS_TIA_INTEGRATION_H
#define TOOLS_TIA_INTEGRATION_H

#include "options.h"

/* Applies the options to the scene, and chooses how many bits a picture has. EXIT_FINE, or EXIT_USAGE after an error
 * message. */
int integration_load(struct options *options);

#endif
