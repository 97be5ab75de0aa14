/* integration.h - the options of integrators, and of the conversion of their samples. */
#ifndef TOOLS_TIA_INTEGRATION_H
#define TOOLS_TIA_INTEGRATION_H

#include "options.h"

/* Applies the options to the scene, and chooses the number of bits in a picture. EXIT_FINE, or EXIT_USAGE after an
 * error message. */
int integration_load(struct options *options);

#endif
