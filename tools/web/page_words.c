/* page_words.c - the words of the scene language, for the editor: those with which the parser compares a word that no
 * table has. So they come from the parser's own tables, and from nowhere else.
 *
 * The linker replaces tia_word_is (src/read/text/text_lines.h) by the function below (port/web/web.mk). */
#include <stdio.h>
#include <string.h>

#include <tia/read.h>

#define EXPORT(name) __attribute__((export_name(name)))
#define PROBE "\x7f" /* the word that no table has */

enum { WORDS_MOST = 96, MEMORY = 1 << 18 };

/* The words found so far; NULL: not looked for. */
struct found {
    const char *words[WORDS_MOST];
    unsigned count;
};
static struct found *found;

struct tia_word; /* of the parser */

bool __real_tia_word_is(const struct tia_word *word, const char *string);
bool __wrap_tia_word_is(const struct tia_word *word, const char *string);
bool __wrap_tia_word_is(const struct tia_word *word, const char *string)
{
    unsigned i = 0;

    if (found && __real_tia_word_is(word, PROBE)) {
        while (i < found->count && strcmp(found->words[i], string) != 0)
            i++;
        if (i == found->count && i < WORDS_MOST)
            found->words[found->count++] = string;
    }
    return __real_tia_word_is(word, string);
}

/* Adds the words that the parser expects where `line` has PROBE. */
static void probe(struct found *into, const char *line)
{
    static uint64_t memory[MEMORY / sizeof(uint64_t)];
    struct tia_reader reader = {.format = TIA_FORMAT_TIA, .text = line, .length = strlen(line)};
    struct tia_scene scene;
    size_t need;

    found = into;
    (void)tia_read(&reader, &scene, memory, sizeof memory, &need);
    found = NULL;
}

/* Adds the words of a statement's line: those that may follow it at once, or after a name and perhaps a kind. */
static void probe_statement(struct found *into, const char *statement)
{
    static const char *const forms[] = {"%s " PROBE "\n", "%s x " PROBE "\n", "%s 1 " PROBE "\n"};
    struct found kinds;
    char line[128];

    for (unsigned i = 0; i < sizeof forms / sizeof forms[0]; i++) {
        (void)snprintf(line, sizeof line, forms[i], statement);
        probe(into, line);
    }
    kinds = *into;
    for (unsigned i = 0; i < 2 * kinds.count; i++) {
        (void)snprintf(line, sizeof line, i % 2 ? "%s x %s " PROBE "\n" : "%s %s " PROBE "\n", statement,
                       kinds.words[i / 2]);
        probe(into, line);
    }
}

/* Returns a line for each statement: its word, and the words of its line. */
EXPORT("web_words") const char *web_words(void);
const char *web_words(void)
{
    static char text[16384];
    static struct found statements, words;
    size_t used = 0;

    statements.count = 0;
    probe(&statements, PROBE "\n");
    for (unsigned i = 0; i < statements.count && used < sizeof text; i++) {
        words.count = 0;
        probe_statement(&words, statements.words[i]);
        used += (size_t)snprintf(text + used, sizeof text - used, "%s", statements.words[i]);
        for (unsigned k = 0; k < words.count && used < sizeof text; k++)
            used += (size_t)snprintf(text + used, sizeof text - used, " %s", words.words[k]);
        if (used < sizeof text)
            used += (size_t)snprintf(text + used, sizeof text - used, "\n");
    }
    return text;
}
