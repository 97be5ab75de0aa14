/* record_parse.c - reads a record. */
#include <inttypes.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <tia/tia.h>

#include "record.h"

enum { LINE = RECORD_NAME + 128 };

struct parser {
    struct record *record;
    const char *text, *end, *begin; /* the next line, the end of the text, the beginning of the current line */
    unsigned number;                /* number of the current line, from 1 */
    char line[LINE + 1];            /* the current line, without its end */
    char *why;
};

__attribute__((format(printf, 2, 3))) static bool refuse(struct parser *p, const char *format, ...)
{
    va_list values;
    int used = snprintf(p->why, RECORD_WHY, "%u: ", p->number);

    va_start(values, format);
    (void)vsnprintf(p->why + used, RECORD_WHY - (size_t)used, format, values);
    va_end(values);
    return false;
}

/* Reads the next line. */
static bool next(struct parser *p)
{
    size_t left = (size_t)(p->end - p->text);
    const char *newline = memchr(p->text, '\n', left);
    size_t length = newline ? (size_t)(newline - p->text) : left;

    p->number++;
    if (!newline)
        return refuse(p, "the record was cut");
    if (length > LINE || memchr(p->text, '\0', length))
        return refuse(p, "not a line of a record");
    if (length > 0 && p->text[length - 1] == '\r')
        return refuse(p, "the line ends with CR and LF, those of a record with LF");
    memcpy(p->line, p->text, length);
    p->line[length] = '\0';
    p->begin = p->text;
    p->text = newline + 1;
    return true;
}

/* Reads the next line if it begins with the word and a space; *rest receives what follows. */
static bool next_is(struct parser *p, const char *word, const char **rest)
{
    size_t length = strlen(word), left = (size_t)(p->end - p->text);

    if (left <= length || memcmp(p->text, word, length) != 0 || p->text[length] != ' ')
        return false;
    *rest = p->line + length + 1;
    return next(p);
}

static bool need(struct parser *p, const char *word, const char **rest)
{
    size_t length = strlen(word), left = (size_t)(p->end - p->text);

    if (next_is(p, word, rest))
        return true;
    if (p->why[0])
        return false;
    p->number++;
    return refuse(p, left <= length && !memcmp(p->text, word, left) ? "the record was cut" : "no line '%s'", word);
}

static bool parse_hash(const char *text, unsigned char hash[SHA256_BYTES])
{
    static const char digits[] = "0123456789abcdef";

    for (unsigned i = 0; i < 2 * SHA256_BYTES; i++) {
        const char *digit = text[i] ? strchr(digits, text[i]) : NULL;
        if (!digit)
            return false;
        unsigned value = (unsigned)(digit - digits);
        hash[i / 2] = (unsigned char)(i % 2 ? hash[i / 2] | value : value << 4);
    }
    return true;
}

/* ---- the lines ---- */

static bool parse_versions(struct parser *p)
{
    struct record *r = p->record;
    const char *rest;
    unsigned version;

    if (!need(p, "TIARECORD", &rest))
        return p->number == 1 && strstr(p->why, "no line") ? refuse(p, "not a record by tia") : false;
    if (sscanf(rest, "%9u", &version) != 1 || version != RECORD_FORMAT)
        return refuse(p, "a record of version %.20s; this tia reads version %u", rest, (unsigned)RECORD_FORMAT);
    if (!need(p, "tia", &rest))
        return false;
    (void)snprintf(r->tia, sizeof r->tia, "%s", rest);
    if (!need(p, "definition", &rest))
        return false;
    return sscanf(rest, "%9" SCNu32, &r->definition) == 1 ? true : refuse(p, "not the version of a definition");
}

static bool parse_picture(struct parser *p)
{
    struct record *r = p->record;
    const char *rest;
    char format[16];
    int used = 0;

    if (!need(p, "picture", &rest))
        return false;
    if (sscanf(rest, "%15s %n", format, &used) != 1 || !used)
        return refuse(p, "not a picture");
    r->format = image_format_called(format);
    if (r->format == IMAGE_UNKNOWN)
        return refuse(p, "no format of pictures");
    if (strlen(rest + used) > RECORD_NAME || !record_name_stays(rest + used) || strchr(rest + used, '/'))
        return refuse(p, "a picture's name leaves the record's folder");
    (void)snprintf(r->picture, sizeof r->picture, "%s", rest + used);
    return true;
}

/* Checks the numbers of a film. */
static const char *film_mistake(const struct image_film *f)
{
    if (!f->width || !f->height || f->width > TIA_SIZE_MAX || f->height > TIA_SIZE_MAX)
        return "a picture has 1x1 to 8192x8192 pixels";
    if (!f->rows || f->rows > f->height || f->first_row > f->height - f->rows)
        return "rows outside the picture";
    if (!f->frames || f->frames > f->all_frames || f->first_frame > f->all_frames - f->frames)
        return "frames outside the film";
    if (!f->rate[0] || !f->rate[1] || f->rate[0] > 1000000 || f->rate[1] > 1000000)
        return "no rate of frames";
    if (f->depth != 0 && f->depth != 8 && f->depth != 16 && f->depth != 32 && f->depth != RECORD_SUMS)
        return "no depth of pixels";
    return NULL;
}

static bool parse_film(struct parser *p)
{
    struct image_film *f = &p->record->film;
    const char *rest;

    if (!need(p, "film", &rest))
        return false;
    if (sscanf(rest, "W%9u H%9u R%9u+%9u N%10" SCNu32 "+%10" SCNu32 "/%10" SCNu32 " F%9" SCNu32 ":%9" SCNu32 " D%9u",
               &f->width, &f->height, &f->first_row, &f->rows, &f->first_frame, &f->frames, &f->all_frames, &f->rate[0],
               &f->rate[1], &f->depth) != 10)
        return refuse(p, "not the size and frames of a picture");
    const char *mistake = film_mistake(f);
    return mistake ? refuse(p, "%s", mistake) : true;
}

static bool parse_files(struct parser *p)
{
    const char *rest;

    while (next_is(p, "file", &rest)) {
        struct record_file *file = record_add_file(p->record);
        int used = 0;
        if (!file)
            return refuse(p, "more than %u files, or no memory", (unsigned)RECORD_ITEMS);
        if (!parse_hash(rest, file->hash) ||
            sscanf(rest + 2 * SHA256_BYTES, " %19" SCNu64 " %n", &file->size, &used) != 1 || !used)
            return refuse(p, "not a file (SHA-256, bytes, name)");
        const char *name = rest + 2 * SHA256_BYTES + used;
        if (strlen(name) > RECORD_NAME || !record_name_stays(name))
            return refuse(p, "the name '%.100s' leaves the record's folder", name);
        (void)snprintf(file->name, sizeof file->name, "%s", name);
    }
    return !p->why[0];
}

static bool parse_options(struct parser *p)
{
    const char *rest;

    while (next_is(p, "option", &rest)) {
        char *option = record_add_option(p->record);
        if (!option)
            return refuse(p, "more than %u options, or no memory", (unsigned)RECORD_ITEMS);
        if (strlen(rest) > RECORD_NAME || !*rest)
            return refuse(p, "not an option");
        (void)snprintf(option, RECORD_NAME + 1, "%s", rest);
    }
    return !p->why[0];
}

static bool parse_group(struct parser *p, struct record_group *group)
{
    struct record_group given;
    const char *rest;
    int used = 0;

    if (!need(p, "rows", &rest))
        return false;
    if (sscanf(rest, "%10" SCNu32 " %9u %9u %8" SCNx32 " %n", &given.frame, &given.first, &given.count, &given.crc,
               &used) != 4 ||
        !used || !parse_hash(rest + used, given.hash))
        return refuse(p, "not rows (frame, first, count, CRC-32, SHA-256)");
    if (given.frame != group->frame || given.first != group->first || given.count != group->count)
        return refuse(p, "rows %u to %u of frame %u stand here in a record", group->first,
                      group->first + group->count - 1, (unsigned)group->frame);
    *group = given;
    return true;
}

static bool parse_frame(struct parser *p, size_t number)
{
    struct record *r = p->record;
    unsigned each = record_frame_groups(&r->film);
    uint32_t frame;
    const char *rest;

    for (unsigned i = 0; i < each; i++)
        if (!parse_group(p, &r->groups[number * each + i]))
            return false;
    if (!need(p, "frame", &rest))
        return false;
    if (sscanf(rest, "%10" SCNu32 " %8" SCNx32, &frame, &r->frames[number]) != 2 ||
        frame != r->film.first_frame + number)
        return refuse(p, "not frame %u and its CRC-32", (unsigned)(r->film.first_frame + number));
    return true;
}

/* Parses all rows. A line of a group has at least 80 bytes, so that a few bytes do not take much memory. */
static bool parse_frames(struct parser *p)
{
    struct record *r = p->record;

    if ((uint64_t)record_frame_groups(&r->film) * r->film.frames > (size_t)(p->end - p->text) / 80) {
        p->number++;
        return refuse(p, "the record was cut");
    }
    if (!record_make_groups(r))
        return refuse(p, "no memory for the rows");
    for (uint32_t i = 0; i < r->film.frames; i++)
        if (!parse_frame(p, i))
            return false;
    return true;
}

static bool parse_root(struct parser *p)
{
    unsigned char given[SHA256_BYTES];
    const char *rest;

    if (!need(p, "root", &rest))
        return false;
    if (!parse_hash(rest, given) || !record_set_root(p->record) || memcmp(given, p->record->root, sizeof given) != 0)
        return refuse(p, "the root is not that of the rows");
    return true;
}

/* Verifies the hash of everything before the last line. */
static bool parse_end(struct parser *p, const char *text)
{
    unsigned char given[SHA256_BYTES], sum[SHA256_BYTES];
    const char *rest;
    struct sha256 sha;

    if (!need(p, "end", &rest))
        return false;
    sha256_begin(&sha);
    sha256_add(&sha, text, (size_t)(p->begin - text));
    sha256_end(&sha, sum);
    if (!parse_hash(rest, given) || memcmp(given, sum, sizeof sum) != 0)
        return refuse(p, "the record was changed: its SHA-256 is another");
    return p->text == p->end ? true : refuse(p, "more follows the end of the record");
}

/* Checks that the text is spelled as tia writes it: no number has leading zeros, and nothing follows a line. */
static bool is_spelled(struct parser *p, const char *text, size_t length)
{
    size_t count;
    char *again = record_print(p->record, &count);
    bool same = again && count == length && !memcmp(again, text, length);

    free(again);
    return same;
}

bool record_parse(struct record *record, const char *text, size_t length, char *why)
{
    struct parser p = {.record = record, .text = text, .end = text + length, .begin = text, .why = why};

    *record = (struct record){.format = IMAGE_UNKNOWN};
    why[0] = '\0';
    if (!parse_versions(&p) || !parse_picture(&p) || !parse_film(&p) || !parse_files(&p) || !parse_options(&p) ||
        !parse_frames(&p) || !parse_root(&p) || !parse_end(&p, text))
        return false;
    if (is_spelled(&p, text, length))
        return true;
    (void)snprintf(why, RECORD_WHY, "not spelled as tia writes records");
    return false;
}
