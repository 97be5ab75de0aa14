/* line_parse.c - reads the line of a result. */
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "common/checksum.h"
#include "common/thread_pool.h"
#include "line.h"

enum { FIELD_MOST = 64 };

struct parser {
    const char *at, *end;
    char *why;
};

__attribute__((format(printf, 2, 3))) static bool refuse(struct parser *p, const char *format, ...)
{
    va_list values;

    va_start(values, format);
    (void)vsnprintf(p->why, BENCHMARK_WHY, format, values);
    va_end(values);
    return false;
}

/* Skips a word that must follow. */
static bool skip(struct parser *p, const char *word)
{
    size_t length = strlen(word);

    if ((size_t)(p->end - p->at) < length || memcmp(p->at, word, length) != 0)
        return false;
    p->at += length;
    return true;
}

/* Reads digits of the base, at least one, at most `most`. */
static bool take(struct parser *p, unsigned base, unsigned most, uint64_t *number)
{
    unsigned count = 0;

    for (*number = 0; p->at < p->end && count < most; p->at++, count++) {
        char c = *p->at;
        unsigned digit = c >= '0' && c <= '9'   ? (unsigned)(c - '0')
                         : c >= 'a' && c <= 'f' ? (unsigned)(c - 'a') + 10
                                                : 16;
        if (digit >= base)
            break;
        *number = *number * base + digit;
    }
    return count > 0;
}

static bool take_number(struct parser *p, uint64_t most, unsigned *number)
{
    uint64_t wide;
    bool fine = take(p, 10, 10, &wide) && wide <= most;

    *number = fine ? (unsigned)wide : 0;
    return fine;
}

/* Reads a number with three decimals, times 1000. */
static bool take_thousandths(struct parser *p, uint32_t *number)
{
    uint64_t whole, part;
    bool fine = take(p, 10, 7, &whole) && skip(p, ".") && take(p, 10, 3, &part) && 1000 * whole + part <= UINT32_MAX;

    *number = fine ? (uint32_t)(1000 * whole + part) : 0;
    return fine;
}

/* Reads characters that a field can have up to `stop`, which is not skipped. */
static bool take_text(struct parser *p, char stop, char *field, size_t size)
{
    const char *found = memchr(p->at, stop, (size_t)(p->end - p->at));
    size_t length = found ? (size_t)(found - p->at) : size;
    char text[FIELD_MOST];

    field[0] = '\0';
    if (length >= size || length >= sizeof text)
        return false;
    memcpy(text, p->at, length);
    text[length] = '\0';
    benchmark_set_text(field, size, text);
    if (strlen(field) != length || memcmp(field, text, length) != 0)
        return false;
    p->at = found;
    return true;
}

/* ---- the line's parts ---- */

static bool take_head(struct parser *p, struct benchmark_line *line)
{
    return skip(p, " version=") && take_text(p, ' ', line->version, sizeof line->version) && skip(p, " definition=") &&
           take_number(p, UINT32_MAX, &line->definition) && skip(p, " cpu=\"") &&
           take_text(p, '"', line->cpu, sizeof line->cpu) && skip(p, "\" machine=\"") &&
           take_text(p, '"', line->machine, sizeof line->machine) && skip(p, "\" compiler=\"") &&
           take_text(p, '"', line->compiler, sizeof line->compiler) && skip(p, "\" threads=") &&
           take_number(p, THREADS_MAX, &line->threads);
}

static bool take_each(struct parser *p, struct benchmark_line *line)
{
    unsigned frames = 0;

    line->by_frames = skip(p, " frames=");
    if (!line->by_frames)
        return skip(p, " seconds=") && take_thousandths(p, &line->each);
    bool fine = take_number(p, UINT32_MAX, &frames);
    line->each = frames;
    return fine;
}

static bool take_crcs(struct parser *p, struct benchmark_line *line)
{
    uint64_t crc;

    for (unsigned i = 0; i < BENCHMARK_FRAMES; i++) {
        if (!skip(p, i ? "," : " crc=") || !skip(p, benchmark_frames[i].name) || !skip(p, ":") || !take(p, 16, 8, &crc))
            return false;
        line->crcs[i] = (uint32_t)crc;
    }
    return true;
}

/* True if the row may follow those before it: see struct benchmark_line. */
static bool is_next(const struct benchmark_line *line, const struct benchmark_row *row)
{
    const struct benchmark_row *last = line->row_count ? &line->rows[line->row_count - 1] : NULL;

    if (row->threads > line->threads)
        return false;
    if (last && strcmp(row->level, last->level) == 0)
        return row->threads > last->threads;
    for (unsigned i = 0; i < line->row_count; i++)
        if (strcmp(row->level, line->rows[i].level) == 0)
            return false;
    return row->threads == 1 && (last || strcmp(row->level, "plain") == 0);
}

static bool take_row(struct parser *p, struct benchmark_line *line)
{
    struct benchmark_row *row = &line->rows[line->row_count];
    uint32_t total;
    bool fine = skip(p, " ") && take_text(p, '.', row->level, sizeof row->level) && skip(p, ".") &&
                strspn(row->level, "abcdefghijklmnopqrstuvwxyz0123456789") == strlen(row->level) &&
                take_number(p, THREADS_MAX, &row->threads);

    for (unsigned i = 0; i < BENCHMARK_FRAMES && fine; i++)
        fine = skip(p, i ? "," : "=") && take_thousandths(p, &row->rates[i]) && row->rates[i];
    if (!fine || !skip(p, ":") || !take_thousandths(p, &total))
        return refuse(p, "row %u of scores is not spelled as tia prints it", line->row_count + 1);
    if (!is_next(line, row))
        return refuse(p, "%s.%u: not the row of scores that tia prints here", row->level, row->threads);
    if (total != benchmark_total(row->rates))
        return refuse(p, "%s.%u: its total is not the geometric mean of its scores", row->level, row->threads);
    line->row_count++;
    return true;
}

static bool take_rows(struct parser *p, struct benchmark_line *line)
{
    while (p->at < p->end && line->row_count < BENCHMARK_ROWS)
        if (!take_row(p, line))
            return false;
    return (p->at == p->end && line->row_count > 0) || refuse(p, "not as many rows of scores as tia prints");
}

/* ---- the line ---- */

/* Cuts the check word off, and verifies it. */
static bool take_check(struct parser *p, const char *text)
{
    static const char word[] = " check=";
    const size_t size = sizeof word - 1 + 8;
    size_t left = (size_t)(p->end - p->at);
    struct parser tail = {left < size ? p->end : p->end - size, p->end, p->why};
    uint64_t crc;

    if (!skip(&tail, word) || !take(&tail, 16, 8, &crc) || tail.at != p->end)
        return refuse(p, "the line was cut: it ends without its check word");
    p->end -= size;
    uint32_t right = checksum_bytes(0, text, (size_t)(p->end - text));
    return right == crc ||
           refuse(p, "the line was changed: its check word is %08x, not %08x", (unsigned)crc, (unsigned)right);
}

static bool take_line(struct parser *p, struct benchmark_line *line, const char *text)
{
    if (!skip(p, BENCHMARK_WORD) || !take_number(p, UINT32_MAX, &line->set))
        return refuse(p, "not a line of tia --benchmark");
    if (line->set != BENCHMARK_SET)
        return refuse(p, "of benchmark %u; this tia has benchmark %u", line->set, (unsigned)BENCHMARK_SET);
    if (!take_check(p, text))
        return false;
    if (!take_head(p, line) || !take_each(p, line) || !take_crcs(p, line))
        return refuse(p, "not spelled as tia prints it, at byte %zu", (size_t)(p->at - text) + 1);
    return take_rows(p, line);
}

bool benchmark_parse(struct benchmark_line *line, const char *text, size_t length, char *why)
{
    struct parser p = {text, text + length, why};
    char again[BENCHMARK_LINE];

    *line = (struct benchmark_line){.set = 0};
    if (length >= BENCHMARK_LINE)
        return refuse(&p, "longer than a line of tia --benchmark");
    if (!take_line(&p, line, text))
        return false;
    if (benchmark_print(line, again) == length && memcmp(again, text, length) == 0)
        return true;
    return refuse(&p, "not spelled as tia prints it");
}
