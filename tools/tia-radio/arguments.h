/* arguments.h - the command line of tia-radio. */
#ifndef TOOLS_RADIO_ARGUMENTS_H
#define TOOLS_RADIO_ARGUMENTS_H

#include "options.h"

/* FINE, or REFUSED after printing why; -1 after --help or the like. */
int arguments_parse(struct options *options, int argc, char **argv);

#endif
