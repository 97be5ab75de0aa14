#include "command_line.h"

#include <getopt.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include <tia/tia.h>

#include "command_help.h"
#include "message.h"
#include "near_word.h"
#include "parse.h"

enum {
    OPTIONS_MOST = 128, /* rows of a command */
    SPELLINGS_MOST = 8, /* rows whose names have a second spelling */
    CODE = 256,         /* code of the first row for getopt_long: greater than any letter */
    TEXT_SIZE = 400
};

/* ---- values ---- */

/* Returns the index of `value` among the words of "a|b|C", where a word in capitals stands for any value; -1 if it is
 * not one of them. */
static int word_of(const char *words, const char *value)
{
    size_t length = strlen(value);
    const char *british = tia_spelling_british(value, length);

    for (int i = 0;; i++) {
        size_t word = strcspn(words, "|");
        if ((*words >= 'A' && *words <= 'Z') || (word == length && strncasecmp(words, value, length) == 0))
            return i;
        if (british && word == strlen(british) && strncmp(words, british, word) == 0)
            return i;
        if (words[word] == '\0')
            return -1;
        words += word + 1;
    }
}

static bool has_words(const struct option_row *row)
{
    return row->argument && strchr(row->argument, '|');
}

static void store(const struct option_row *row, void *to, uint64_t value)
{
    uint8_t byte = (uint8_t)value;
    uint16_t half = (uint16_t)value;
    uint32_t word = (uint32_t)value;
    const void *from = row->size == 1   ? (const void *)&byte
                       : row->size == 2 ? (const void *)&half
                       : row->size == 4 ? (const void *)&word
                                        : &value;

    memcpy(to, from, row->size);
}

static bool parse_pair(const struct option_row *row, const char *value, uint64_t pair[2])
{
    char separator = row->kind == OPTION_SIZE ? 'x' : row->kind == OPTION_PIXEL ? ',' : '-';
    uint64_t low = row->kind == OPTION_SIZE;
    const char *rest;

    return parse_wide(value, &rest, low, row->max, &pair[0]) && *rest == separator &&
           parse_wide(rest + 1, NULL, row->kind == OPTION_RANGE ? pair[0] : low, row->max, &pair[1]);
}

static bool parse_decimal(const struct option_row *row, const char *value, uint64_t *number)
{
    tia_q16 scaled;
    bool fine = parse_scaled(value, row->bits, &scaled);

    *number = fine ? (uint64_t)scaled : 0;
    return fine && *number >= row->min && *number <= row->max;
}

/* Reads the one or two numbers of a value; texts and parsed values have none. `word` is the value's index among the
 * row's words. */
static bool parse_numbers(const struct option_row *row, const char *value, int word, uint64_t numbers[2])
{
    switch (row->kind) {
    case OPTION_FLAG:
        numbers[0] = row->min ? row->min : true;
        return true;
    case OPTION_CHOICE:
        numbers[0] = row->min + (uint64_t)word;
        return true;
    case OPTION_NUMBER:
        return parse_wide(value, NULL, row->min, row->max, &numbers[0]);
    case OPTION_DECIMAL:
        return parse_decimal(row, value, &numbers[0]);
    default:
        return parse_pair(row, value, numbers);
    }
}

/* Stores a value. Returns NULL, or a message like that of `parse`. */
static const char *set(const struct option_row *row, char *options, char *value)
{
    uint64_t numbers[2];

    if (row->given)
        *(bool *)(void *)(options + row->given) = true;
    if (row->kind == OPTION_PARSED)
        return row->parse(options + row->at, value);
    int word = has_words(row) ? word_of(row->argument, value) : 0;
    if (word < 0)
        return "";
    if (row->kind == OPTION_TEXT) {
        memcpy(options + row->at, &value, sizeof value);
        return NULL;
    }
    if (!parse_numbers(row, value, word, numbers))
        return "";
    store(row, options + row->at, numbers[0]);
    if (row->second)
        store(row, options + row->second, numbers[1]);
    return NULL;
}

/* The rows of --help, and further ones. */
struct tables {
    const struct option_row *own, *more;
};

/* Returns row number `i` of both tables; NULL after the last. */
static const struct option_row *row_at(const struct tables *tables, int i)
{
    const struct option_row *row = tables->own;

    for (; row->name && i > 0; i--)
        row++;
    if (row->name || !tables->more)
        return row->name ? row : NULL;
    for (row = tables->more; row->name && i > 0; i--)
        row++;
    return row->name ? row : NULL;
}

/* ---- messages ---- */

/* Writes "a|b|c" as "a, b or c". */
static void list_words(const char *words, char *text, size_t size)
{
    size_t used = 0;

    text[0] = '\0';
    while (*words != '\0' && used < size) {
        int word = (int)strcspn(words, "|");
        bool last = words[word] == '\0';
        const char *before = used == 0 ? "" : last ? " or " : ", ";
        used += (size_t)snprintf(text + used, size - used, "%s%.*s", before, word, words);
        words += word + !last;
    }
}

static void format_rule(const struct option_row *row, char *text, size_t size)
{
    char allowed[TEXT_SIZE];
    bool words = has_words(row);

    if (words)
        list_words(row->argument, allowed, sizeof allowed);
    else
        command_format_limits(row, allowed, sizeof allowed);
    if (row->rule)
        (void)snprintf(text, size, "%s", row->rule);
    else if (row->kind == OPTION_PIXEL)
        (void)snprintf(text, size, "not a pixel (X,Y from 0,0 at the upper left)");
    else if (row->kind == OPTION_RANGE)
        (void)snprintf(text, size, "not a range (FIRST-LAST, counted from 0)");
    else if (row->kind == OPTION_SIZE)
        (void)snprintf(text, size, "not a size (%s, like 640x480)", allowed);
    else
        (void)snprintf(text, size, "not %s%s", words ? "" : "a number from ", allowed);
}

/* Writes "unknown (did you mean WORD?)" if a word of the row is near the value. */
static bool format_near(const struct option_row *row, const char *value, char *text, size_t size)
{
    struct near_word near = {.word = value, .length = strlen(value)};

    for (const char *words = has_words(row) ? row->argument : ""; *words != '\0';) {
        size_t word = strcspn(words, "|");
        if (strcspn(words, "=") > word) /* "ao=DISTANCE" is no word */
            near_word_try(&near, words, word);
        words += word + (words[word] != '\0');
    }
    (void)snprintf(text, size, "unknown (did you mean %.*s?)", (int)near.found_length, near.found ? near.found : "");
    return near.found;
}

static int refuse(const struct command *command, const struct option_row *row, const char *value, const char *mistake)
{
    char rule[TEXT_SIZE + 40];

    if (!value || *mistake || row->rule || !format_near(row, value, rule, sizeof rule))
        format_rule(row, rule, sizeof rule);
    return message(command->name, 2, "--%s '%.200s': %s", row->name, value ? value : "", *mistake ? mistake : rule);
}

/* Reports an unknown option, with the one that was probably meant. */
static int refuse_unknown(const char *tool, const char *name, const struct tables *tables)
{
    struct near_word near = {.word = name + strspn(name, "-")};
    const struct option_row *row;

    near.length = strcspn(near.word, "=");
    for (int i = 0; strncmp(name, "--", 2) == 0 && (row = row_at(tables, i)) != NULL; i++)
        near_word_try(&near, row->name, strlen(row->name));
    if (near.found)
        return message(tool, 2, "%.200s: unknown option (did you mean --%s?)", name, near.found);
    return message(tool, 2, "%.200s: unknown option (%s -h lists them)", name, tool);
}

/* Reports an invalid option: getopt_long returned the code ':' for a missing value, '?' for anything else. */
static int refuse_option(const char *tool, int code, char **argv, const struct tables *tables)
{
    const char letter[] = {'-', (char)optopt, '\0'};
    bool is_short = optopt > 0 && optopt < CODE && strncmp(argv[optind - 1], "--", 2) != 0;
    const char *name = is_short ? letter : argv[optind - 1];

    if (code == ':')
        return message(tool, 2, "%.200s: a value is missing (%s -h shows which)", name, tool);
    if (!is_short && optopt != 0)
        return message(tool, 2, "%.200s: takes no value", name);
    return refuse_unknown(tool, name, tables);
}

/* ---- help ---- */

/* Prints the help; a command with themes takes one after --help. */
static int print_help(const struct command *command, const struct option_row *row, const char *next)
{
    bool is_theme = row->themes && next && *next != '-';

    return command_help(command, row, optarg ? optarg : is_theme ? next : NULL);
}

static int print_version(const struct command *command)
{
    (void)printf("%s " TIA_VERSION "\n", command->name);
    return message_output(command->name, "");
}

/* ---- the command line ---- */

static int argument_of(const struct option_row *row)
{
    return !row->argument ? no_argument : row->kind == OPTION_HELP ? optional_argument : required_argument;
}

/* Adds the options whose names have a second spelling. */
static void name_american(const struct tables *tables, struct option *longs)
{
#define PAIR(american, british) {american, british},
    static const char *const pairs[][2] = {TIA_SPELLINGS(PAIR)};
#undef PAIR
    const struct option_row *row;

    for (int i = 0; i < OPTIONS_MOST && (row = row_at(tables, i)) != NULL; i++)
        for (size_t k = 0; k < sizeof pairs / sizeof *pairs; k++)
            if (strcmp(row->name, pairs[k][1]) == 0)
                *longs++ = (struct option){pairs[k][0], argument_of(row), NULL, CODE + i};
}

static void name_options(const struct tables *tables, struct option *longs, char *shorts)
{
    const struct option_row *row;
    int count = 0;

    *shorts++ = ':';
    for (int i = 0; i < OPTIONS_MOST && (row = row_at(tables, i)) != NULL; i++) {
        longs[count++] = (struct option){row->name, argument_of(row), NULL, CODE + i};
        if (row->letter)
            *shorts++ = row->letter;
        for (int colons = row->letter ? argument_of(row) : 0; colons > 0; colons--)
            *shorts++ = ':'; /* two for an optional argument */
    }
    *shorts = '\0';
    name_american(tables, longs + count);
}

/* Returns the row for a code of getopt_long; NULL for the codes of an invalid option. */
static const struct option_row *row_of(const struct tables *tables, int code)
{
    const struct option_row *row;
    int i = 0;

    if (code >= CODE)
        return row_at(tables, code - CODE);
    while ((row = row_at(tables, i)) != NULL && row->letter != code)
        i++;
    return row;
}

int command_parse(const struct command *command, void *options, int *argc, char ***argv)
{
    return command_parse_extra(command, &(struct command_extra){.more = NULL}, options, argc, argv);
}

int command_parse_extra(const struct command *command, const struct command_extra *extra, void *options, int *argc,
                        char ***argv)
{
    const struct tables tables = {command->options, extra->more};
    struct option longs[OPTIONS_MOST + SPELLINGS_MOST + 1] = {{0}};
    char shorts[3 * OPTIONS_MOST + 2];

    name_options(&tables, longs, shorts);
    opterr = 0;
    optind = 0; /* a command may parse several lists of arguments */
    for (int code; (code = getopt_long(*argc, *argv, shorts, longs, NULL)) != -1;) {
        const struct option_row *row = row_of(&tables, code);
        if (!row)
            return refuse_option(command->name, code, *argv, &tables);
        if (row->kind == OPTION_HELP)
            return print_help(command, row, optind < *argc ? (*argv)[optind] : NULL);
        if (row->kind == OPTION_VERSION)
            return print_version(command);
        if (extra->seen)
            extra->seen(extra->ctx, row, optarg);
        const char *mistake = set(row, options, optarg);
        if (mistake)
            return refuse(command, row, optarg, mistake);
    }
    *argc -= optind;
    *argv += optind;
    return COMMAND_RUN;
}
