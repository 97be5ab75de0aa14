#include "scene_report.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/message.h"

enum {
    WIDTH = 72,    /* most columns of a line that are shown */
    BEFORE = 24,   /* columns before the word that are shown of a long line, if there are as many after it */
    TAB = 8,       /* distance of tab stops */
    CELLS = 4096,  /* most columns of a line that are looked at */
    CELL_BYTES = 5 /* bytes of a character, and a 0 */
};

/* A line in columns, each with a character. */
struct cells {
    char text[CELLS][CELL_BYTES];
    unsigned count;
};

/* ---- characters ---- */

/* Returns the number of bytes of the UTF-8 character at `at`, and sets *code; 0: it is none. */
static unsigned decode(const unsigned char *at, size_t left, uint32_t *code)
{
    static const uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
    unsigned bytes = *at < 0x80 ? 1 : *at >= 0xf0 && *at < 0xf8 ? 4 : *at >= 0xe0 ? 3 : *at >= 0xc0 ? 2 : 0;

    if (bytes == 0 || bytes > left || *at >= 0xf8)
        return 0;
    *code = bytes == 1 ? *at : *at & (0x7fu >> bytes);
    for (unsigned i = 1; i < bytes; i++) {
        if ((at[i] & 0xc0) != 0x80)
            return 0;
        *code = *code << 6 | (at[i] & 0x3fu);
    }
    return *code >= least[bytes] && *code < 0x110000 && (*code < 0xd800 || *code > 0xdfff) ? bytes : 0;
}

/* True for characters that a terminal obeys or that change where others appear. */
static bool is_control(uint32_t code)
{
    return code < ' ' || (code >= 0x7f && code < 0xa0) || (code >= 0x200b && code <= 0x200f) ||
           (code >= 0x2028 && code <= 0x202e) || (code >= 0x2060 && code <= 0x206f) || code == 0xfeff;
}

static void add_cell(struct cells *cells, const char *bytes, unsigned count)
{
    if (cells->count == CELLS)
        return;
    memcpy(cells->text[cells->count], bytes, count);
    cells->text[cells->count++][count] = '\0';
}

/* Splits the bytes into columns; sets *first and *last to the columns of the bytes from..to. */
static void split(struct cells *cells, const struct tia_read_error *error, unsigned *first, unsigned *last)
{
    const unsigned char *line = (const unsigned char *)error->source;
    uint32_t from = error->column - 1, to = from + error->length;

    cells->count = 0;
    *first = *last = 0;
    for (uint32_t i = 0; i < error->source_length;) {
        uint32_t code = 0;
        unsigned bytes = decode(line + i, error->source_length - i, &code), before = cells->count;
        if (bytes == 1 && code == '\t')
            do
                add_cell(cells, " ", 1);
            while (cells->count % TAB != 0 && cells->count < CELLS);
        else if (bytes == 0 || is_control(code))
            add_cell(cells, "?", 1);
        else
            add_cell(cells, (const char *)line + i, bytes);
        *first = i < from ? cells->count : *first;
        *last = i < to && i >= from ? cells->count : i < from ? before + 1 : *last;
        i += bytes ? bytes : 1;
    }
    *last = *last > *first ? *last : *first + 1;
}

/* ---- texts ---- */

/* Appends a text to the report. */
static void append(struct scene_file *file, const char *text)
{
    size_t used = file->report ? strlen(file->report) : 0, length = strlen(text);
    char *report = realloc(file->report, used + length + 1);

    if (!report)
        return;
    memcpy(report + used, text, length + 1);
    file->report = report;
}

/* Writes the columns from..to of the line, and the mark below it. */
static void append_line(struct scene_file *file, const struct cells *cells, uint32_t number, unsigned first,
                        unsigned last)
{
    char text[WIDTH * CELL_BYTES + 64];
    unsigned end = cells->count > first ? cells->count : first + 1, from = 0;

    if (end > WIDTH && first > BEFORE)
        from = end - WIDTH < first - BEFORE ? end - WIDTH : first - BEFORE;
    bool cut = end - from > WIDTH;
    unsigned to = cut ? from + WIDTH : end;
    int used = snprintf(text, sizeof text, "%5u | %s", number, from ? "..." : "");
    int gutter = snprintf(NULL, 0, "%5u", number);
    for (unsigned i = from + (from ? 3 : 0); i < to - (cut ? 3 : 0) && i < cells->count; i++)
        used += snprintf(text + used, sizeof text - (size_t)used, "%s", cells->text[i]);
    (void)snprintf(text + used, sizeof text - (size_t)used, "%s\n%*s | ", cut ? "..." : "", gutter, "");
    append(file, text);
    memset(text, ' ', first - from);
    memset(text + (first - from), '~', WIDTH);
    text[first - from] = '^';
    last = last < to ? last : to;
    text[(last > first ? last : first + 1) - from] = '\0';
    append(file, text);
    append(file, "\n");
}

void scene_report_add(struct scene_file *file, const char *message, const struct tia_read_error *error)
{
    char text[SCENE_WHY];
    unsigned first, last;

    (void)snprintf(text, sizeof text, "%s", message);
    message_clean(text);
    append(file, text);
    append(file, "\n");
    struct cells *cells = error->source && error->line ? malloc(sizeof *cells) : NULL;
    if (!cells)
        return;
    split(cells, error, &first, &last);
    if (first < CELLS)
        append_line(file, cells, error->line, first, last);
    free(cells);
}

void scene_report_more(struct scene_file *file)
{
    append(file, "and more mistakes\n");
}

void scene_report_free(struct scene_file *file)
{
    free(file->report);
    file->report = NULL;
}
