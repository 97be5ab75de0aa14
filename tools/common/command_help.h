/* command_help.h - what --help prints: the options of a command, or an overview and the options of a theme. */
#ifndef TOOLS_COMMON_COMMAND_HELP_H
#define TOOLS_COMMON_COMMAND_HELP_H

#include "command_table.h"

/* Writes the limits of a row's value, "1 to 16"; for OPTION_HELP its themes, "eye, shadows or all". */
void command_format_limits(const struct option_row *row, char *text, size_t size);

/* Prints the help for a row of the kind OPTION_HELP; theme NULL: none is named. Returns the exit status: 0; 1 if it
 * cannot be printed; 2 after an error message that names the nearest theme. */
int command_help(const struct command *command, const struct option_row *help, const char *theme);

#endif
