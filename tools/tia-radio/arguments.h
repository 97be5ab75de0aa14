/* arguments.h - the command line of tia-radio. */
#ifndef TOOLS_RADIO_ARGUMENTS_H
#define TOOLS_RADIO_ARGUMENTS_H

#include "options.h"

/* Parses the command line. Returns COMMAND_RUN; or the status to exit with, FINE after --help or the like, else after
 * an error message. */
int arguments_parse(struct options *options, int argc, char **argv);

#endif
