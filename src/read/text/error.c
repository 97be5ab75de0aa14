/* error.c - error messages. */
#include "text_lines.h"

#define SHOWN 40 /* a message shows at most this many bytes of a word */

static void add(struct tia_read_error *error, const char *bytes, size_t count)
{
    size_t length = 0;

    while (error->text[length])
        length++;
    for (size_t i = 0; i < count && length + 1 < sizeof error->text; i++)
        error->text[length++] = bytes[i];
    error->text[length] = 0;
}

void tia_say(struct tia_read_error *error, const char *string)
{
    size_t length = 0;

    while (string[length])
        length++;
    add(error, string, length);
}

void tia_say_plain(struct tia_read_error *error, const struct tia_word *word)
{
    char shown[SHOWN];
    size_t length = word->length <= SHOWN ? (size_t)word->length : SHOWN;

    for (size_t i = 0; i < length; i++)
        shown[i] = word->at[i] >= ' ' && word->at[i] < 127 ? word->at[i] : '?';
    add(error, shown, length);
}

void tia_say_word(struct tia_read_error *error, const struct tia_word *word)
{
    tia_say(error, "'");
    tia_say_plain(error, word);
    tia_say(error, word->length <= SHOWN ? "'" : "...'");
}

void tia_say_number(struct tia_read_error *error, int64_t number)
{
    char digits[20];
    size_t first = sizeof digits;
    uint64_t left = number < 0 ? 0 - (uint64_t)number : (uint64_t)number;

    do {
        digits[--first] = (char)('0' + left % 10);
        left /= 10;
    } while (left);
    if (number < 0)
        digits[--first] = '-';
    add(error, digits + first, sizeof digits - first);
}

/* Sets the line of the text in which the word is, up to TIA_SOURCE_AFTER bytes behind it. */
static void set_source(struct tia_text *t, const struct tia_word *word)
{
    const char *end = word->at ? word->at + word->length : NULL;

    t->error->source = NULL;
    t->error->source_length = 0;
    if (!word->line || !end || end > t->end)
        return;
    t->error->source = word->at - (word->column - 1);
    for (unsigned more = 0; more < TIA_SOURCE_AFTER && end < t->end && *end != '\n'; more++)
        end++;
    t->error->source_length = (uint32_t)(end - t->error->source);
}

void tia_text_error_place(struct tia_text *t, const struct tia_word *word)
{
    /* a number of a constant is elsewhere: the name's place is told */
    if (word->line == t->use.line && word->column == t->use.column && t->use.length)
        word = &t->use;
    t->error->line = word->line;
    t->error->column = word->column;
    t->error->length = word->length;
    set_source(t, word);
}

int tia_text_error_at(struct tia_text *t, const struct tia_word *word)
{
    unsigned i = 0;

    for (; i < TIA_NAME_MAX && t->file[i]; i++)
        t->error->file[i] = t->file[i];
    t->error->file[i] = 0;
    tia_text_error_place(t, word);
    t->error->text[0] = 0;
    return TIA_ERR_RANGE;
}

int tia_text_error(struct tia_text *t, const struct tia_word *word, const char *what, const char *expected)
{
    (void)tia_text_error_at(t, word);
    if (word->length) {
        tia_say_word(t->error, word);
        tia_say(t->error, " ");
        tia_say(t->error, what);
    } else {
        tia_say(t->error, "the line ends here");
    }
    tia_say(t->error, ", expected ");
    tia_say(t->error, expected);
    return TIA_ERR_RANGE;
}
