/* command_table.h - the table of a command's options: command_parse and --help use it, and tools/generate/options.py
 * generates the shells' completions and the manuals' headings from it. */
#ifndef TOOLS_COMMON_COMMAND_TABLE_H
#define TOOLS_COMMON_COMMAND_TABLE_H

#include <stddef.h>
#include <stdint.h>

/* The kinds of an option's value, each with the type of the member that receives it. If the argument is a list of
 * words, as "srgb|linear", only these are accepted, in upper or lower case. There are two exceptions: a word that
 * begins with a capital, as in "NAME|help", stands for any value; and the row may have a parser that accepts more. */
enum option_kind {
    OPTION_FLAG,    /* no value: stores min, or true if min is 0 */
    OPTION_TEXT,    /* any text: const char * */
    OPTION_NUMBER,  /* min to max: an unsigned number */
    OPTION_DECIMAL, /* "1.25", times 2^(16 + bits), min to max: tia_q16 or uint32_t */
    OPTION_CHOICE,  /* the argument's words: min for the first one, and so on */
    OPTION_SIZE,    /* "640x480", each 1 to max: two unsigned numbers */
    OPTION_PIXEL,   /* "3,4", each up to max: two unsigned numbers */
    OPTION_RANGE,   /* "0-99", up to max, the first not above the last: two unsigned numbers */
    OPTION_PARSED,  /* any value that `parse` accepts */
    OPTION_HELP,
    OPTION_VERSION
};

/* A theme of --help: some of the options. */
struct help_theme {
    const char *name; /* NULL ends the list */
    const char *title;
    const char *options; /* their names, separated by spaces */
    const char *notes;   /* text below the options; NULL: none */
};

struct option_row {
    const char *name; /* the name without hyphens; NULL ends a table */
    char letter;      /* a short name; '\0': none */
    enum option_kind kind;
    const char *argument; /* for --help: capitals stand for values, all else is literal. NULL: the option has no
                             argument */
    const char *help;     /* text of --help; '#' stands for the limits, or for the themes */

    /* Offsets in the command's struct. */
    size_t at, size; /* the member that gets the value */
    size_t second;   /* the member, of the same size, that receives the second of two numbers; 0: none */
    size_t given;    /* a bool that becomes true if the option is given; 0: none */

    uint64_t min, max;
    int bits;
    /* stores a value, whose text it may change; returns NULL, or a message; "" stands for the message made from
     * `rule` */
    const char *(*parse)(void *member, char *value);
    const char *rule; /* the allowed values, for messages: "not a rate (...)"; NULL: made from the row */

    /* OPTION_HELP: without a theme the overview is printed, before the list of themes; NULL: always all options */
    const struct help_theme *themes;
    const char *overview;
};

/* Initialises `at` and `size` for the member of struct `type` that gets a row's value. */
#define OPTION_TO(type, member) .at = offsetof(type, member), .size = sizeof(((type *)0)->member)
/* Initialises `at`, `size` and `second` for the two members that get a row's two numbers. */
#define OPTION_PAIR(type, first, last) OPTION_TO(type, first), .second = offsetof(type, last)
/* The last rows of every table; and those of a command whose options have themes. */
#define OPTION_END OPTION_END_HELP(.help = "this text")
#define OPTION_END_THEMES(the_themes, the_overview)                                                                    \
    OPTION_END_HELP(.argument = "[THEME]", .help = "an overview; or the options of a theme: #",                        \
                    .themes = (the_themes), .overview = (the_overview))
#define OPTION_END_HELP(...)                                                                                           \
    {"help", 'h', OPTION_HELP, __VA_ARGS__}, {"version", 'V', OPTION_VERSION, .help = "the version"},                  \
    {                                                                                                                  \
        .name = NULL                                                                                                   \
    }

struct command {
    const char *name;
    const char *about; /* text of --help above the options */
    const struct option_row *options;
    const char *notes; /* text of --help below the options */
};

#endif
