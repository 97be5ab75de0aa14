/* text_lines.h - reads lines of words and numbers from untrusted bytes.
 *
 * Blanks separate words, LF or CRLF separates lines. A # at the beginning of a word starts a comment. A backslash at
 * the very end of a line joins the next line to it. The text needs no final newline or 0; nothing beyond its end is
 * read.
 *
 * Functions that can fail return TIA_OK, or set the error and return TIA_ERR_RANGE. A reader looks like this:
 *
 *     while (tia_text_line(t)) {
 *         tia_text_word(t, &word);            never fails here: the line is not blank
 *         if (tia_word_is(&word, "v"))
 *             status = tia_text_vec3(t, &vertex);
 *         else
 *             status = tia_text_error(t, &word, "is not a statement", "v or f");
 *         if (status || (status = tia_text_end(t)))
 *             return status;
 *     }
 */
#ifndef TIA_READ_TEXT_TEXT_LINES_H
#define TIA_READ_TEXT_TEXT_LINES_H

#include <tia/read.h>

/* A part of the text. An empty word at the end of the line means that the line has no more words. */
struct tia_word {
    const char *at;
    uint32_t length, line, column;
};

/* Receives mistakes after which a reader goes on; *error has the mistake. */
struct tia_tolerance {
    void (*tell)(void *ctx);
    void *ctx;
};

struct tia_text {
    const char *next, *end, *line_start;
    uint32_t line;
    const char *file; /* "", or the name of the library being read */
    struct tia_read_error *error;
    const struct tia_tolerance *tolerance; /* NULL: the reader ends at the first mistake */
    struct tia_lengths *lengths;           /* units and bounds of lengths, see length.h; NULL: none */

    /* Names for numbers, see constants.h; NULL: none. The numbers of a name replace it: they are read before the next
     * word of the line, and errors give the place of the name. */
    const struct tia_constants *constants;
    const char *numbers, *numbers_end; /* numbers of the name that are still to be read; NULL: none */
    struct tia_word use;               /* the name, where it is used */
    bool negated;                      /* the last word is such a number, and the name had a minus */
};

/* True if lines, columns and indices would need more than 32 bits. */
bool tia_text_is_too_long(size_t length);

/* Begins a text; skips a byte order mark at the start. */
struct tia_text tia_text_begin(const char *bytes, size_t length, const char *file, struct tia_read_error *error);

/* Skips to the next word on this line or a later one. Returns false at the end of the text. */
bool tia_text_line(struct tia_text *t);

/* Reads the next word of the line. At the end of the line the word is empty, and the function returns false. */
bool tia_text_word(struct tia_text *t, struct tia_word *word);
/* Reads the next word of the line without consuming it. */
bool tia_text_peek(const struct tia_text *t, struct tia_word *word);

/* Skips the rest of the line. */
void tia_text_skip(struct tia_text *t);

/* Skips the rest of the line and the lines that are joined to it. */
void tia_text_abandon(struct tia_text *t);

/* Called after an error was set: if the text has a `tolerance`, tells it the error and returns true, and the reader
 * goes on. */
bool tia_text_goes_on(const struct tia_text *t);

/* Fails if the line has another word. */
int tia_text_end(struct tia_text *t);

/* Reads a name: 1..TIA_NAME_MAX bytes without control characters. `expected` describes the name in an error: "a
 * material's name". */
int tia_text_name(struct tia_text *t, struct tia_word *name, const char *expected);
/* Reads a file's name likewise. A name in double quotes may contain blanks. */
int tia_text_file(struct tia_text *t, struct tia_word *name, const char *expected);

bool tia_word_is(const struct tia_word *word, const char *string);
/* Returns the word in British spelling, or as it is. */
struct tia_word tia_word_british(const struct tia_word *word);

/* Sets the error's place to word number `skip`, from 0, of the rest of a line. If `word` is not NULL, sets it to the
 * first word that equals `word`, starting at that number. Returns false, and leaves the place unchanged, if there is no
 * such word. */
bool tia_text_locate(struct tia_text rest, unsigned skip, const char *word, struct tia_read_error *error);

/* Copies a name as a 0-terminated string. */
void tia_word_copy(char out[TIA_NAME_MAX + 1], const struct tia_word *word);

/* ---- numbers: [+-], any number of digits with or without a point, and perhaps an exponent (1e-3) ---- */

enum tia_decimal { TIA_DECIMAL_FINE, TIA_DECIMAL_NONE, TIA_DECIMAL_RANGE };

/* Converts a word to a number times 2^bits, rounded to nearest, ties away from zero; bits is in 0..53. The result must
 * be below 2^63 in size. */
enum tia_decimal tia_decimal(int64_t *out, const struct tia_word *word, unsigned bits);

/* True if the next word of the line is a number, or a name that stands for numbers. */
bool tia_text_has_number(const struct tia_text *t);

/* Reads a number as Q16.16. */
int tia_text_q16(struct tia_text *t, tia_q16 *out);
/* Reads a number times 2^bits, bits in -16..16, as Q16.16. */
int tia_text_scaled(struct tia_text *t, tia_q16 *out, int bits);
/* Reads a number times 2^bits, bits in -16..16, as Q31.32; the product is in the range of Q16.16. */
int tia_text_fine(struct tia_text *t, int64_t *out, int bits);
/* Reads a number with `bits` fractional bits, 0..53. The number must be below 2^31 in size, and *out below 2^63. */
int tia_text_long(struct tia_text *t, int64_t *out, unsigned bits);
/* Reads a number as Q2.30. */
int tia_text_q30(struct tia_text *t, tia_q30 *out);
/* Reads a number as Q31.32. */
int tia_text_q32(struct tia_text *t, int64_t *out);

/* Reads a channel of a colour: 0 to 1. */
int tia_text_unit(struct tia_text *t, tia_q30 *out);
/* Reads a channel of a light's colour: 0 to below 2. */
int tia_text_bright(struct tia_text *t, tia_q30 *out);
/* Reads a channel of an emission, with 30 fractional bits: 2^13 times a number to `most`, which is 1 or, for a channel
 * below 2, INT32_MAX. */
int tia_text_radiance(struct tia_text *t, tia_q30 most, int64_t *out);
/* Reads an integer in min..max. */
int tia_text_integer(struct tia_text *t, int64_t *out, int64_t min, int64_t max);

/* Reads three numbers as Q16.16. */
int tia_text_vec3(struct tia_text *t, struct tia_vec3 *out);
/* Reads channels as tia_text_unit does or, if `bright`, as tia_text_bright does. */
int tia_text_rgb(struct tia_text *t, struct tia_rgb *out, bool bright);
/* Reads a direction, of any length but 0, and normalises it, within 2 ulp. */
int tia_text_dir3(struct tia_text *t, struct tia_dir3 *out);

/* Normalises v, whose components are at most 2^62 in size. Returns false if v is 0. */
bool tia_dir3_of(struct tia_dir3 *out, const int64_t v[3]);

/* ---- errors ---- */

/* Sets "'WORD' WHAT, expected EXPECTED" or, for an empty word, "the line ends here, expected EXPECTED"; returns
 * TIA_ERR_RANGE. */
int tia_text_error(struct tia_text *t, const struct tia_word *word, const char *what, const char *expected);

/* Sets the error's place, and nothing else. */
void tia_text_error_place(struct tia_text *t, const struct tia_word *word);
/* Sets the error's place, empties its text for tia_say, and returns TIA_ERR_RANGE. */
int tia_text_error_at(struct tia_text *t, const struct tia_word *word);
/* Appends a string to the error's text, as far as it fits. */
void tia_say(struct tia_read_error *error, const char *string);
/* Appends a word in quotes, with bytes that are safe to print. */
void tia_say_word(struct tia_read_error *error, const struct tia_word *word);
/* Appends the word without quotes. */
void tia_say_plain(struct tia_read_error *error, const struct tia_word *word);
/* Appends a number in decimal. */
void tia_say_number(struct tia_read_error *error, int64_t number);

#endif
