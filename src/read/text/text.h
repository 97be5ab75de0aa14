/* text.h - reading lines of words and numbers out of bytes that nobody vouches for.
 *
 * Words are parted by blanks, lines by LF or CRLF; where a word would begin, # starts a comment; a
 * backslash at a line's very end joins it with the next one. No byte is read twice except by peeking,
 * none beyond the end, and the text need not end in a zero or a newline.
 *
 * A reader looks like this, any function that can fail returning TIA_OK or TIA_ERR_RANGE and the error:
 *
 *     while (tia_text_line(t)) {
 *         tia_text_word(t, &word);            never fails here: the line is not blank
 *         if (tia_word_is(&word, "v"))
 *             status = tia_text_vec3(t, &vertex);
 *         else
 *             status = tia_text_error(t, &word, "is no statement", "v or f");
 *         if (status || (status = tia_text_end(t)))
 *             return status;
 *     }
 */
#ifndef TIA_SRC_READ_TEXT_H
#define TIA_SRC_READ_TEXT_H

#include <tia/read.h>

struct tia_text {
    const char *next, *end, *line_start;
    uint32_t line;
    const char *file; /* "", or the name of the library that this is */
    struct tia_read_error *error;
};

/* Some bytes of the text; where the line ended instead, none, and its end. */
struct tia_word {
    const char *at;
    uint32_t length, line, column;
};

struct tia_text tia_text_begin(const char *bytes, size_t length, const char *file, struct tia_read_error *error);

/* Goes to the first word of this line or a later one; false at the end of the text. */
bool tia_text_line(struct tia_text *t);

/* The next word of the line; false, and an empty word, at the line's end. Peek leaves it there. */
bool tia_text_word(struct tia_text *t, struct tia_word *word);
bool tia_text_peek(const struct tia_text *t, struct tia_word *word);

/* Skips what is left of the line. */
void tia_text_skip(struct tia_text *t);

/* An error where a word is left on the line. */
int tia_text_end(struct tia_text *t);

/* The next word as a name: 1..TIA_NAME_MAX bytes without control characters. A file's name may be in
 * double quotes, then with blanks in it. `expected` is for the error: "a material's name". */
int tia_text_name(struct tia_text *t, struct tia_word *name, const char *expected);
int tia_text_file(struct tia_text *t, struct tia_word *name, const char *expected);

bool tia_word_is(const struct tia_word *word, const char *string);

/* Copies a name and a zero. */
void tia_word_copy(char out[TIA_NAME_MAX + 1], const struct tia_word *word);

/* ---- numbers: [+-] digits with or without a point and an exponent (1e-3), however many digits ---- */

enum tia_decimal { TIA_DECIMAL_FINE, TIA_DECIMAL_NONE, TIA_DECIMAL_RANGE };

/* The number times 2^bits, to nearest, ties away from zero; bits in 0..32, the result below 2^63. */
enum tia_decimal tia_decimal(int64_t *out, const struct tia_word *word, unsigned bits);

/* Whether the next word of the line is a number. */
bool tia_text_has_number(const struct tia_text *t);

/* The next word as a number: in Q16.16; in Q2.30; in Q31.32; a whole one. */
int tia_text_q16(struct tia_text *t, tia_q16 *out);
int tia_text_q30(struct tia_text *t, tia_q30 *out);
int tia_text_q32(struct tia_text *t, int64_t *out);
int tia_text_integer(struct tia_text *t, int64_t *out, int64_t min, int64_t max);

/* The next three words as numbers. A direction may have any length but 0; it gets 1, within 2 ulp. */
int tia_text_vec3(struct tia_text *t, struct tia_vec3 *out);
int tia_text_rgb(struct tia_text *t, struct tia_rgb *out);
int tia_text_dir3(struct tia_text *t, struct tia_dir3 *out);

/* Any vector but (0, 0, 0), each |v| <= 2^62, at length 1. */
bool tia_dir3_of(struct tia_dir3 *out, const int64_t v[3]);

/* ---- errors: they all return TIA_ERR_RANGE ---- */

/* "'WORD' WHAT, expected EXPECTED", or where the line ended "the line ends here, expected EXPECTED". */
int tia_text_error(struct tia_text *t, const struct tia_word *word, const char *what, const char *expected);

/* The same without text: tia_say adds it, as long as it fits. */
int tia_text_error_at(struct tia_text *t, const struct tia_word *word);
void tia_say(struct tia_read_error *error, const char *string);
void tia_say_word(struct tia_read_error *error, const struct tia_word *word); /* 'word', safe to print */
void tia_say_number(struct tia_read_error *error, int64_t number);

#endif
