/* command_line.h - the options of a command. One table holds them: command_parse reads it, --help prints it, and
 * tools/generate/options.py makes from it the completions of shells and the headings of the manuals. */
#ifndef TOOLS_COMMON_COMMAND_LINE_H
#define TOOLS_COMMON_COMMAND_LINE_H

#include <stddef.h>
#include <stdint.h>

/* The values of options, and the members that they go to. Where an argument is written as words, "srgb|linear", no
 * other value is taken, but by a parser of its own. Case does not matter there. */
enum option_kind {
    OPTION_FLAG,    /* none: bool, which becomes true */
    OPTION_TEXT,    /* any text: const char * */
    OPTION_NUMBER,  /* min to max: an unsigned number */
    OPTION_DECIMAL, /* "1.25", times 2^(16 + bits), min to max: tia_q16 or uint32_t */
    OPTION_CHOICE,  /* the argument's words: min for the first one, and so on */
    OPTION_SIZE,    /* "640x480", each 1 to max: two unsigned numbers */
    OPTION_PIXEL,   /* "3,4", each up to max: the same */
    OPTION_RANGE,   /* "0-99", up to max, not falling: the same */
    OPTION_PARSED,  /* any that `parse` accepts; it gets NULL where there is no argument */
    OPTION_HELP,
    OPTION_VERSION
};

struct option_row {
    const char *name; /* without hyphens; NULL ends a table */
    char letter;      /* '\0': none */
    enum option_kind kind;
    const char *argument; /* for --help: capitals stand for values, all else is literal. NULL: the option takes none */
    const char *help;     /* '#' stands for the limits */

    /* Offsets in the command's struct. */
    size_t at, size; /* the member that gets the value */
    size_t second;   /* the member, of the same size, that gets the second of two numbers; 0: none */
    size_t given;    /* a bool that becomes true; 0: none */

    uint64_t min, max;
    int bits;
    /* Returns NULL, or the mistake, "" for the one that `rule` names. May change the value. */
    const char *(*parse)(void *options, char *value);
    const char *rule; /* for messages: the values that are allowed, "not a rate (...)". NULL: made from the row */
};

/* For rows of a command whose struct is `type`. */
#define OPTION_TO(type, member) .at = offsetof(type, member), .size = sizeof(((type *)0)->member)
#define OPTION_PAIR(type, first, last) OPTION_TO(type, first), .second = offsetof(type, last)
/* The last rows of every table. */
#define OPTION_END                                                                                                     \
    {"help", 'h', OPTION_HELP, .help = "this text"}, {"version", 'V', OPTION_VERSION, .help = "the version"},          \
    {                                                                                                                  \
        .name = NULL                                                                                                   \
    }

struct command {
    const char *name;
    const char *about; /* above the options */
    const struct option_row *options;
    const char *notes; /* below them */
};

enum { COMMAND_RUN = -1 };

/* Stores the options in the command's struct, which already holds the defaults. Returns COMMAND_RUN, with the arguments
 * that are left in argc and argv; or the status to exit with: 0 after --help and --version, 1 if they could not be
 * printed, 2 after an error message. */
int command_parse(const struct command *command, void *options, int *argc, char ***argv);

#endif
