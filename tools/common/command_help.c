#include "command_help.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "message.h"
#include "near_word.h"

enum {
    TEXT_SIZE = 400,
    LINE_WIDTH = 79, /* a terminal of 80 columns */
    LEFT_MOST = 32,  /* width of the column of options; wider rows have their help text on the next line */
    THEME_WIDTH = 40 /* width of the columns of themes in the overview: two on a terminal of 80 */
};

/* ---- themes ---- */

/* Writes "eye, shadows or all". */
static void list_themes(const struct help_theme *themes, char *text, size_t size)
{
    size_t used = 0;

    for (const struct help_theme *theme = themes; theme && theme->name && used < size; theme++)
        used += (size_t)snprintf(text + used, size - used, "%s%s", used > 0 ? ", " : "", theme->name);
    if (used < size)
        (void)snprintf(text + used, size - used, " or all");
}

void command_format_limits(const struct option_row *row, char *text, size_t size)
{
    unsigned long long min = row->min, max = row->max;

    if (row->kind == OPTION_HELP)
        list_themes(row->themes, text, size);
    else if (row->kind == OPTION_SIZE)
        (void)snprintf(text, size, "1x1 to %llux%llu", max, max);
    else
        (void)snprintf(text, size, "%llu to %llu", min, max);
}

/* True if `words`, separated by spaces, contain the word. */
static bool has_word(const char *words, const char *word)
{
    size_t length = strlen(word);

    for (size_t n; *words != '\0'; words += n + strspn(words + n, " ")) {
        n = strcspn(words, " ");
        if (n == length && strncmp(words, word, n) == 0)
            return true;
    }
    return false;
}

static int refuse_theme(const char *tool, const struct option_row *help, const char *name)
{
    struct near_word near = {.word = name, .length = strlen(name)};
    char themes[TEXT_SIZE];

    for (const struct help_theme *theme = help->themes; theme->name; theme++)
        near_word_try(&near, theme->name, strlen(theme->name));
    near_word_try(&near, "all", 3);
    if (near.found)
        return message(tool, 2, "--help '%.200s': unknown (did you mean %s?)", name, near.found);
    list_themes(help->themes, themes, sizeof themes);
    return message(tool, 2, "--help '%.200s': not %s", name, themes);
}

/* ---- rows ---- */

/* Writes "  -s, --size WIDTHxHEIGHT". Returns its width. */
static unsigned format_left(const struct option_row *row, char *text, size_t size)
{
    const char letter[] = {'-', row->letter, ',', '\0'};

    return (unsigned)snprintf(text, size, "  %3s --%s%s%s", row->letter ? letter : "", row->name,
                              row->argument ? " " : "", row->argument ? row->argument : "");
}

/* Writes the row's help text, with the limits in place of '#'. */
static void format_right(const struct option_row *row, char *text, size_t size)
{
    const char *mark = strchr(row->help, '#');
    char limits[TEXT_SIZE];

    command_format_limits(row, limits, sizeof limits);
    (void)snprintf(text, size, "%.*s%s%s", mark ? (int)(mark - row->help) : (int)strlen(row->help), row->help,
                   mark ? limits : "", mark ? mark + 1 : "");
}

static void print_row(const struct option_row *row, unsigned column)
{
    char left[TEXT_SIZE], right[2 * TEXT_SIZE];
    unsigned at = format_left(row, left, sizeof left);

    format_right(row, right, sizeof right);
    (void)fputs(left, stdout);
    for (const char *word = right; *word != '\0';) {
        unsigned length = (unsigned)strcspn(word, " ");
        bool starts = word == right && at + 2 <= column;
        if (!starts && (word == right || at + 1 + length > LINE_WIDTH)) {
            (void)putchar('\n');
            at = 0;
        }
        unsigned indent = at < column ? column - at : 1;
        (void)printf("%*s%.*s", (int)indent, "", (int)length, word);
        at += indent + length;
        word += length + strspn(word + length, " ");
    }
    (void)putchar('\n');
}

/* Prints the rows that a theme names; all of them if it is NULL. */
static void print_rows(const struct option_row *rows, const struct help_theme *theme)
{
    unsigned column = 0;
    char left[TEXT_SIZE];

    for (const struct option_row *row = rows; row->name; row++) {
        unsigned width = format_left(row, left, sizeof left) + 2;
        if (!theme || has_word(theme->options, row->name))
            column = width > column && width <= LEFT_MOST ? width : column;
    }
    for (const struct option_row *row = rows; row->name; row++)
        if (!theme || has_word(theme->options, row->name))
            print_row(row, column);
}

/* ---- pages ---- */

static int print_all(const struct command *command)
{
    (void)fputs(command->about, stdout);
    print_rows(command->options, NULL);
    return message_output(command->name, command->notes);
}

static int print_overview(const struct command *command, const struct option_row *help)
{
    (void)fputs(help->overview, stdout);
    for (const struct help_theme *theme = help->themes; theme->name; theme++) {
        bool ends = (theme - help->themes) % 2 || !theme[1].name;
        int length = printf("  %-10s  %s", theme->name, theme->title);
        (void)printf("%*s", ends ? 1 : THEME_WIDTH - length, ends ? "\n" : "");
    }
    return message_output(command->name, "");
}

int command_help(const struct command *command, const struct option_row *help, const char *name)
{
    const struct help_theme *theme = help->themes;

    if (!theme || (name && strcmp(name, "all") == 0))
        return print_all(command);
    if (!name)
        return print_overview(command, help);
    while (theme->name && strcmp(theme->name, name) != 0)
        theme++;
    if (!theme->name)
        return refuse_theme(command->name, help, name);
    (void)printf("%s: %s\n\n", theme->name, theme->title);
    print_rows(command->options, theme);
    if (!theme->notes)
        return message_output(command->name, "");
    (void)putchar('\n');
    return message_output(command->name, theme->notes);
}
