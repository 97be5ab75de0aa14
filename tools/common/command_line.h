/* command_line.h - parses the options of a command, by its table. */
#ifndef TOOLS_COMMON_COMMAND_LINE_H
#define TOOLS_COMMON_COMMAND_LINE_H

#include "command_table.h"

enum { COMMAND_RUN = -1 };

/* Stores the options in the command's struct, which already holds the defaults. Returns COMMAND_RUN, with the remaining
 * arguments in argc and argv; or the exit status: 0 after --help and --version, 1 if these could not be printed, 2
 * after an error message. */
int command_parse(const struct command *command, void *options, int *argc, char ***argv);

struct command_extra {
    const struct option_row *more; /* further options, which --help does not list; NULL: none */
    /* Receives each option before its value, which may be changed then, is parsed; value: NULL for a flag. NULL: none.
     */
    void (*seen)(void *ctx, const struct option_row *row, const char *value);
    void *ctx;
};

/* Parses as command_parse does, with these extras. */
int command_parse_extra(const struct command *command, const struct command_extra *extra, void *options, int *argc,
                        char ***argv);

#endif
