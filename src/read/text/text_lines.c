/* text_lines.c - splits text into lines and words. */
#include "text_lines.h"

#include <tia/spelling.h>

/* the UTF-8 byte order mark, which many editors write at the start of a text */
static const char byte_order_mark[] = "\xef\xbb\xbf";
#define MARK_LENGTH (sizeof byte_order_mark - 1)

static bool is_marked(const char *bytes, size_t length)
{
    size_t i = 0;

    while (i < MARK_LENGTH && i < length && bytes[i] == byte_order_mark[i])
        i++;
    return i == MARK_LENGTH;
}

bool tia_text_is_too_long(size_t length)
{
    uint64_t bytes = length; /* always false if size_t has fewer than 32 bits */
    return bytes >= UINT32_MAX;
}

struct tia_text tia_text_begin(const char *bytes, size_t length, const char *file, struct tia_read_error *error)
{
    const char *start = is_marked(bytes, length) ? bytes + MARK_LENGTH : bytes;
    struct tia_text t = {.next = start, .end = bytes, .line_start = start, .line = 1, .file = file, .error = error};

    if (length)
        t.end = bytes + length;
    return t;
}

static void new_line(struct tia_text *t)
{
    t->line++;
    t->line_start = t->next;
}

/* Returns the length of the line end at p, LF or CRLF, or 0 if there is none. */
static unsigned line_end(const char *p, const char *end)
{
    if (p < end && *p == '\n')
        return 1;
    return end - p >= 2 && p[0] == '\r' && p[1] == '\n' ? 2 : 0;
}

/* Returns the length of a backslash and line end at p, or 0 if there is none. */
static unsigned join(const char *p, const char *end)
{
    unsigned length = p < end && *p == '\\' ? line_end(p + 1, end) : 0;
    return length ? length + 1 : 0;
}

static bool is_blank(char c)
{
    return c == ' ' || (c >= '\t' && c <= '\r' && c != '\n');
}

/* True for a byte of a word that cannot be the backslash of a joined line. */
static bool is_plain(char c)
{
    return (unsigned char)c > ' ' && c != '\\';
}

static void skip_blanks(struct tia_text *t)
{
    while (t->next < t->end && !is_plain(*t->next)) {
        unsigned joined = join(t->next, t->end);
        if (!joined && (!is_blank(*t->next) || line_end(t->next, t->end)))
            return;
        t->next += joined ? joined : 1;
        if (joined)
            new_line(t);
    }
}

/* Skips blanks. True if a word follows. */
static bool has_word(struct tia_text *t)
{
    skip_blanks(t);
    return t->next < t->end && *t->next != '#' && !line_end(t->next, t->end);
}

void tia_text_skip(struct tia_text *t)
{
    while (t->next < t->end && *t->next != '\n')
        t->next++;
}

bool tia_text_line(struct tia_text *t)
{
    while (!has_word(t)) {
        tia_text_skip(t);
        if (t->next == t->end)
            return false;
        t->next++;
        new_line(t);
    }
    return true;
}

static struct tia_word empty_word(const struct tia_text *t)
{
    return (struct tia_word){t->next, 0, t->line, (uint32_t)(t->next - t->line_start) + 1};
}

/* Returns the end of the word in which p is. The pointer is not a member, which would be stored for each byte. */
static const char *word_end(const char *p, const char *end)
{
    while (p < end && (is_plain(*p) || (*p != '\n' && !is_blank(*p) && !join(p, end))))
        p++;
    return p;
}

/* Reads the next word of the line, without replacing constants. */
static bool take_word(struct tia_text *t, struct tia_word *word)
{
    bool found = has_word(t);

    *word = empty_word(t);
    if (!found)
        return false;
    t->next = word_end(t->next, t->end);
    word->length = (uint32_t)(t->next - word->at);
    return true;
}

/* Reads the next number of a constant, as a word at the place where the constant is used. */
static bool take_rest(struct tia_text *t, struct tia_word *word)
{
    struct tia_text rest = {.next = t->numbers, .end = t->numbers_end, .line_start = t->numbers};
    bool found = take_word(&rest, word);

    t->numbers = found ? rest.next : NULL;
    word->line = t->use.line;
    word->column = t->use.column;
    return found;
}

bool tia_text_word(struct tia_text *t, struct tia_word *word)
{
    if (t->numbers && take_rest(t, word))
        return true;
    t->negated = false;
    return take_word(t, word);
}

bool tia_text_peek(const struct tia_text *t, struct tia_word *word)
{
    struct tia_text copy = *t;
    return tia_text_word(&copy, word);
}

void tia_text_abandon(struct tia_text *t)
{
    struct tia_word word;

    t->numbers = NULL;
    while (take_word(t, &word))
        continue;
}

bool tia_text_goes_on(const struct tia_text *t)
{
    if (t->tolerance)
        t->tolerance->tell(t->tolerance->ctx);
    return t->tolerance;
}

int tia_text_end(struct tia_text *t)
{
    struct tia_word word;

    if (tia_text_word(t, &word))
        return tia_text_error(t, &word, "is too much", "the end of the line");
    return TIA_OK;
}

/* Checks that a word is a valid name. */
static int check_name(struct tia_text *t, const struct tia_word *name, const char *expected)
{
    if (!name->length)
        return tia_text_error(t, name, "", expected);
    if (name->length > TIA_NAME_MAX)
        return tia_text_error(t, name, "is longer than 255 bytes", expected);
    for (uint32_t i = 0; i < name->length; i++)
        if ((unsigned char)name->at[i] < ' ' || name->at[i] == 127)
            return tia_text_error(t, name, "contains a control character", expected);
    return TIA_OK;
}

int tia_text_name(struct tia_text *t, struct tia_word *name, const char *expected)
{
    (void)tia_text_word(t, name);
    return check_name(t, name, expected);
}

int tia_text_file(struct tia_text *t, struct tia_word *name, const char *expected)
{
    if (!tia_text_peek(t, name) || *name->at != '"')
        return tia_text_name(t, name, expected);
    skip_blanks(t);
    const char *p = ++t->next;
    while (p < t->end && *p != '"' && *p != '\n')
        p++;
    if (p == t->end || *p != '"')
        return tia_text_error(t, name, "has no closing quote", expected);
    *name = empty_word(t);
    name->length = (uint32_t)(p - t->next);
    t->next = p + 1;
    if (!name->length) {
        name->length = 2, name->at--, name->column--; /* the error message shows the quotes */
        return tia_text_error(t, name, "is empty", expected);
    }
    return check_name(t, name, expected);
}

bool tia_word_is(const struct tia_word *word, const char *string)
{
    uint32_t i = 0;

    while (i < word->length && string[i] && word->at[i] == string[i])
        i++;
    return i == word->length && !string[i];
}

struct tia_word tia_word_british(const struct tia_word *word)
{
    const char *british = tia_spelling_british(word->at, (size_t)word->length);
    struct tia_word same = *word;

    if (!british)
        return same;
    same.at = british;
    for (same.length = 0; british[same.length];)
        same.length++;
    return same;
}

void tia_word_copy(char out[TIA_NAME_MAX + 1], const struct tia_word *word)
{
    uint32_t length = word->length < TIA_NAME_MAX ? word->length : TIA_NAME_MAX;

    for (uint32_t i = 0; i < length; i++)
        out[i] = word->at[i];
    out[length] = 0;
}

bool tia_text_locate(struct tia_text rest, unsigned skip, const char *word, struct tia_read_error *error)
{
    struct tia_word found;

    rest.error = error;
    for (unsigned i = 0; tia_text_word(&rest, &found); i++) {
        const struct tia_word british = tia_word_british(&found);
        if (i >= skip && (!word || tia_word_is(&british, word))) {
            tia_text_error_place(&rest, &found);
            return true;
        }
    }
    return false;
}
