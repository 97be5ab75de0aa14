/* scene_words.c - prints the words of scene files, as the reader of .tia files knows them: it reads lines that end with
 * a word that there is not, and notes the words that it compares this word with. The linker passes these comparisons
 * and the tables of fields to the functions below (--wrap).
 *
 * A line for each word: what stands before it, without the values that do not matter; the word; what it is.
 *
 *     TAB sphere TAB statement                     the first word of a line
 *     light spot TAB inner TAB numbers 1           a field: its kind, the number of its values, "needed"
 *     shadows TAB traced TAB word                  a word that chooses
 *     mesh TAB vertex TAB line                     the first word of a line within the block of a statement
 *     mesh TAB - TAB name                          any name can stand here, or, "file", the name of a file
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "read/text/fields.h"
#include <tia/read.h>

#define UNKNOWN "?"
#define VALUE "1"       /* a number, a name and a path */
#define TEXT_MAX 256    /* bytes of a line */
#define WORDS_MAX 512   /* words compared with the unknown one in one reading */
#define STARTS_MAX 1024 /* beginnings of lines */
#define LINES_MAX 16    /* words that begin lines of a block */
#define VALUES_MAX 9    /* values before a word: those of `gravity`, of a fall's name, and the like */

static const char *const kinds[] = {
    [TIA_NUMBERS] = "numbers",  [TIA_LENGTHS] = "lengths", [TIA_VECTOR] = "vector",   [TIA_SPREAD] = "spread",
    [TIA_LONGS] = "numbers",    [TIA_COLOUR] = "colour",   [TIA_EMISSION] = "colour", [TIA_FADING] = "numbers",
    [TIA_DIRECTION] = "vector", [TIA_WHOLE] = "whole",     [TIA_FLAG] = "flag",       [TIA_NAME_FIELD] = "name",
    [TIA_FILE_FIELD] = "file"};

/* What one reading has found. */
static struct found {
    const char *words[WORDS_MAX];
    const struct tia_field *fields[WORDS_MAX]; /* NULL: the word is no field */
    unsigned times[WORDS_MAX];                 /* how often the word was compared */
    unsigned count;
    const char *named;     /* what is named by the unknown word: "name" or "file"; NULL: nothing */
    char values[TEXT_MAX]; /* the fields that the statement needs, with values */
} found;

/* The table of the fields that are being read. */
static struct {
    const struct tia_field *at;
    unsigned count;
} table;

bool __real_tia_word_is(const struct tia_word *word, const char *string);
bool __wrap_tia_word_is(const struct tia_word *word, const char *string);
int __real_tia_fields(struct tia_text *t, const char *what, const struct tia_field *fields, unsigned count, void *out,
                      uint32_t *given);
int __wrap_tia_fields(struct tia_text *t, const char *what, const struct tia_field *fields, unsigned count, void *out,
                      uint32_t *given);

int __real_tia_text_name(struct tia_text *t, struct tia_word *name, const char *expected);
int __wrap_tia_text_name(struct tia_text *t, struct tia_word *name, const char *expected);
int __real_tia_text_file(struct tia_text *t, struct tia_word *name, const char *expected);
int __wrap_tia_text_file(struct tia_text *t, struct tia_word *name, const char *expected);

static void *allocate(size_t size)
{
    void *memory = calloc(1, size);

    if (!memory) {
        fprintf(stderr, "scene_words: no memory\n");
        exit(1);
    }
    return memory;
}

static const char *copied(const char *text)
{
    return strcpy(allocate(strlen(text) + 1), text);
}

static void note(const char *string)
{
    const struct tia_field *field = NULL;

    for (unsigned i = 0; i < table.count; i++)
        if (!strcmp(table.at[i].word, string)) {
            struct tia_field *copy = allocate(sizeof *copy);
            *copy = table.at[i]; /* the table may be the caller's variable */
            field = copy;
        }
    for (unsigned i = 0; i < found.count; i++)
        if (!strcmp(found.words[i], string)) {
            found.times[i]++;
            return;
        }
    if (found.count == WORDS_MAX) {
        fprintf(stderr, "scene_words: more than %d words after one\n", WORDS_MAX);
        exit(1);
    }
    found.words[found.count] = copied(string);
    found.times[found.count] = 1;
    found.fields[found.count++] = field;
}

bool __wrap_tia_word_is(const struct tia_word *word, const char *string)
{
    bool number = *string >= '0' && *string <= '9' && !strchr(string, 'x'); /* 3x3 is a word */

    if (__real_tia_word_is(word, UNKNOWN) && !number)
        note(string);
    return __real_tia_word_is(word, string);
}

static void add_value(const struct tia_field *field)
{
    size_t length = strlen(found.values);
    unsigned values = field->kind == TIA_VECTOR || field->kind == TIA_DIRECTION || field->kind == TIA_FADING ? 3
                      : field->kind == TIA_FLAG                                                              ? 0
                      : field->count > 1 ? field->count
                                         : 1;

    if (strstr(found.values, field->word))
        return;
    (void)snprintf(found.values + length, sizeof found.values - length, " %s", field->word);
    for (unsigned i = 0; i < values && strlen(found.values) + 3 < sizeof found.values; i++)
        strcat(found.values, " " VALUE);
}

int __wrap_tia_fields(struct tia_text *t, const char *what, const struct tia_field *fields, unsigned count, void *out,
                      uint32_t *given)
{
    for (unsigned i = 0; i < count; i++)
        if (fields[i].needed)
            add_value(&fields[i]);
    table.at = fields;
    table.count = count;
    int status = __real_tia_fields(t, what, fields, count, out, given);
    table.count = 0;
    return status;
}

/* Notes that a name is read, if it is the unknown word. */
static void note_name(struct tia_text *t, const char *what)
{
    struct tia_word word;

    if (tia_text_peek(t, &word) && __real_tia_word_is(&word, UNKNOWN))
        found.named = what;
}

int __wrap_tia_text_name(struct tia_text *t, struct tia_word *name, const char *expected)
{
    note_name(t, "name");
    return __real_tia_text_name(t, name, expected);
}

int __wrap_tia_text_file(struct tia_text *t, struct tia_word *name, const char *expected)
{
    note_name(t, "file");
    return __real_tia_text_file(t, name, expected);
}

static int fetch_image(void *ctx, const char *name, struct tia_texture *texture, const char **why)
{
    (void)ctx, (void)name, (void)texture, (void)why;
    return TIA_OK;
}

static int fetch_opacity(void *ctx, const char *name, enum tia_channel channel, struct tia_texture *texture,
                         const char **why)
{
    (void)channel;
    return fetch_image(ctx, name, texture, why);
}

/* Reads the text and then the unknown word. */
static void read_after(const char *text)
{
    char whole[3 * TEXT_MAX + sizeof " " UNKNOWN];
    struct tia_reader reader = {.format = TIA_FORMAT_TIA, .image = fetch_image, .opacity = fetch_opacity};
    struct tia_scene scene;
    size_t need = 0;

    (void)snprintf(whole, sizeof whole, "%s " UNKNOWN, text);
    reader.text = whole;
    reader.length = strlen(whole);
    found.count = 0;
    found.values[0] = 0;
    found.named = NULL;
    void *memory = NULL;
    if (tia_read(&reader, &scene, NULL, 0, &need) == TIA_ERR_MEMORY) {
        memory = allocate(need);
        (void)tia_read(&reader, &scene, memory, need, &need);
    }
    free(memory);
}

/* ---- the words of a statement ---- */

static struct {
    const char *text[STARTS_MAX]; /* beginnings of lines still to be read, and those that were */
    const char *path[STARTS_MAX]; /* the same without values */
    unsigned count;
} starts;
static unsigned statements; /* number of first words of lines */

static void print(const char *path, unsigned i, const char *kind)
{
    const struct tia_field *field = found.fields[i];

    if (field)
        printf("%s\t%s\t%s %u%s\n", path, found.words[i], kinds[field->kind], (unsigned)field->count,
               field->needed ? " needed" : "");
    else
        printf("%s\t%s\t%s\n", path, found.words[i], kind);
}

/* True for a set of words that has been seen after this path or, if they are no fields, in this statement: that of
 * choices that return, as after `shadows map size 64`. */
static bool is_known(const char *path)
{
    static const char *known[STARTS_MAX];
    static unsigned count;
    size_t statement = strcspn(path, " "), path_length = strlen(path);
    char *set = allocate(TEXT_MAX + WORDS_MAX * 16);

    memcpy(set, path, found.count && found.fields[0] ? path_length : statement);
    for (unsigned i = 0; i < found.count; i++)
        strncat(strcat(set, " "), found.words[i], 14);
    for (unsigned i = 0; i < count; i++)
        if (!strcmp(known[i], set)) {
            free(set);
            return true;
        }
    if (count < STARTS_MAX)
        known[count++] = set;
    return false;
}

/* Prints the words that one reading found. Returns false if they are known. */
static bool print_all(const char *path, const char *kind)
{
    if (!found.count || is_known(path))
        return false;
    for (unsigned i = 0; i < found.count; i++)
        print(path, i, kind);
    return true;
}

static void add_start(const char *text, const char *path, const char *word)
{
    char longer[2][TEXT_MAX];

    if (starts.count == STARTS_MAX || strlen(text) + strlen(word) + 2 > TEXT_MAX)
        return;
    (void)snprintf(longer[0], TEXT_MAX, "%s%s%s", text, *text ? " " : "", word);
    (void)snprintf(longer[1], TEXT_MAX, "%s%s%s", path, *path ? " " : "", word);
    starts.text[starts.count] = copied(longer[0]);
    starts.path[starts.count++] = copied(longer[1]);
}

/* Prints the words that can stand after the text and values, and adds those that choose as beginnings. */
static void print_line(const char *text, const char *path)
{
    char values[TEXT_MAX];
    bool fields = false;

    (void)snprintf(values, sizeof values, "%s", text);
    for (unsigned n = 0; n <= VALUES_MAX && !fields && strlen(values) + 3 < sizeof values; n++) {
        read_after(values);
        const struct found all = found;
        if (found.named)
            printf("%s\t-\t%s\n", path, found.named);
        bool is_new = print_all(path, "word");
        for (unsigned i = 0; i < all.count; i++) {
            fields = fields || all.fields[i];
            if (is_new && !all.fields[i])
                add_start(values, path, all.words[i]);
        }
        strcat(values, " " VALUE);
    }
}

static bool is_statement(const char *word)
{
    for (unsigned i = 0; i < statements; i++)
        if (!strcmp(word, starts.text[i]))
            return true;
    return false;
}

/* Returns how often the reading asked whether the line is a statement: the first of these words is as rare as any. */
static unsigned count_questions(void)
{
    for (unsigned i = 0; i < found.count; i++)
        if (!strcmp(found.words[i], starts.text[0]))
            return found.times[i];
    return 0;
}

/* Prints the first words of lines that one reading found after the lines of a block: those that are no statements, or
 * were compared once more. `printed` has the `count` words printed before. Returns the new count. */
static unsigned print_lines(const char *path, const char *printed[], unsigned count)
{
    unsigned questions = count_questions();

    for (unsigned i = 0; i < found.count; i++) {
        bool known = is_statement(found.words[i]) && found.times[i] <= questions;
        for (unsigned k = 0; k < count; k++)
            known = known || !strcmp(found.words[i], printed[k]);
        if (known || count == LINES_MAX)
            continue;
        printed[count++] = found.words[i];
        print(path, i, "line");
    }
    return count;
}

/* Prints the first words of the lines in the block that the statement begins. */
static void print_block(const char *text, const char *path)
{
    char block[3 * TEXT_MAX];
    const char *printed[LINES_MAX];
    unsigned count = 0;

    for (int n = 0; n <= 1; n++) {
        (void)snprintf(block, TEXT_MAX, "%s%s", text, n ? " " VALUE : "");
        read_after(block);
        strcat(strcat(block, found.values), "\n");
        for (int line = 0; line < 2; line++) {
            read_after(block);
            count = print_lines(path, printed, count);
            strcat(block, "row " VALUE "\n"); /* of a grid with one row; in other blocks a mistake */
        }
    }
}

int main(void)
{
    read_after("");
    statements = found.count;
    const struct found all = found;
    (void)print_all("", "statement");
    for (unsigned i = 0; i < all.count; i++)
        add_start("", "", all.words[i]);
    for (unsigned i = 0; i < starts.count; i++) {
        print_line(starts.text[i], starts.path[i]);
        if (i < statements)
            print_block(starts.text[i], starts.path[i]);
    }
    return 0;
}
