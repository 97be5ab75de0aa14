/* parse_option.h - parses the value of one option. */
#ifndef TOOLS_TIA_PARSE_OPTION_H
#define TOOLS_TIA_PARSE_OPTION_H

#include "option_codes.h"
#include "options.h"

/* An option of option_codes.h or a letter of tia's. EXIT_FINE, or EXIT_USAGE after an error message. May change the
 * text of `value`. */
int parse_option(struct options *options, int option, char *value);

#endif
