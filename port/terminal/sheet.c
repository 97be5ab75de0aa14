/* sheet.c - lays out lines of text in a window, and writes the rows that have changed. */
#include "sheet.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PANEL_LINES 128 /* most lines of a panel, after wrapping */
#define MARGIN 1        /* blank columns on both sides of notes and of a panel */
#define GAP 2           /* columns between the two parts of a panel's line */
#define NOTES_STEP 8    /* the width of notes is a multiple of it, since numbers in them change their lengths */
#define LEAST_TEXT 12   /* least columns for the second part of a panel's line beside the first */

enum style { BODY, KEY, TITLE, TITLE_KEY };

/* The attributes of each style, by the colours. */
static const char *const styles[][4] = {{"\033[0;38;5;252;48;5;235m", "\033[0;1;38;5;222;48;5;235m",
                                         "\033[0;38;5;255;48;5;24m", "\033[0;1;38;5;231;48;5;24m"},
                                        {"\033[0;37;40m", "\033[0;1;33;40m", "\033[0;37;44m", "\033[0;1;37;44m"},
                                        {"\033[0m", "\033[0;1m", "\033[0;7m", "\033[0;1;7m"}};
static const char *const backs[] = {";48;5;16", ";40", ""}; /* of erased cells */

/* A part of a string. */
struct part {
    const char *text;
    size_t length;
};

/* A row being written: the columns that are left. */
struct writer {
    struct sheet *sheet;
    unsigned left;
};

/* ---- characters ---- */

static bool is_middle(char c)
{
    return ((unsigned char)c & 0xc0) == 0x80;
}

/* Returns the number of characters. */
static unsigned length_of(struct part part)
{
    unsigned count = 0;

    for (size_t i = 0; i < part.length; i++)
        count += !is_middle(part.text[i]);
    return count;
}

/* True for a character of two bytes that takes one column in every font: Latin, Greek, Cyrillic; U+00A1 to U+02FF and
 * U+0370 to U+052F. */
static bool is_narrow_pair(const char *at, size_t left)
{
    if (left < 2 || ((unsigned char)at[0] & 0xe0) != 0xc0 || !is_middle(at[1]))
        return false;
    unsigned code = ((unsigned)at[0] & 0x1f) << 6 | ((unsigned)at[1] & 0x3f);
    return (code >= 0xa1 && code < 0x300) || (code >= 0x370 && code < 0x530);
}

/* Writes a string as far as it fits. */
static void put(struct writer *w, struct part part)
{
    struct text *text = &w->sheet->text;

    for (size_t i = 0; i < part.length && w->left > 0;) {
        const char *at = part.text + i;
        char one[3] = {*at >= ' ' && *at < 127 ? *at : '?', 0, 0};
        size_t used = 1;
        if (w->sheet->window.utf8 && is_narrow_pair(at, part.length - i))
            one[0] = *at, one[1] = at[1];
        while (i + used < part.length && is_middle(at[used]))
            used++;
        text_add(text, one);
        w->left--;
        i += used;
    }
}

static void put_blanks(struct writer *w, unsigned count)
{
    for (; count > 0 && w->left > 0; count--, w->left--)
        text_add(&w->sheet->text, " ");
}

static void put_style(const struct writer *w, enum style style)
{
    text_add(&w->sheet->text, styles[w->sheet->window.colours][style]);
}

static struct part part_of(const char *text)
{
    return (struct part){text, strlen(text)};
}

/* Takes the part up to `end` off a string. */
static struct part take(const char **text, char end)
{
    const char *stop = strchr(*text, end);
    struct part part = {*text, stop ? (size_t)(stop - *text) : strlen(*text)};

    *text += part.length + (stop ? 1 : 0);
    return part;
}

/* Takes the beginning of a part that fits into `columns`, cut at a blank if there is one in its second half. */
static struct part take_fitting(struct part *part, unsigned columns)
{
    size_t used = 0, cut = 0;

    for (unsigned count = 0; used < part->length && (count < columns || is_middle(part->text[used])); used++) {
        count += !is_middle(part->text[used]);
        if (part->text[used] == ' ' && count > columns / 2)
            cut = used;
    }
    if (used < part->length && part->text[used] != ' ' && cut > 0)
        used = cut;
    struct part first = {part->text, used};
    while (used < part->length && part->text[used] == ' ')
        used++;
    *part = (struct part){part->text + used, part->length - used};
    return first;
}

/* ---- rows ---- */

static struct writer begin_row(struct sheet *sheet, unsigned row, unsigned left, unsigned width, enum style style)
{
    struct writer w = {sheet, width};
    char move[32];

    (void)snprintf(move, sizeof move, "\033[%u;%uH", row + 1, left + 1);
    text_add(&sheet->text, move);
    sheet->covers[row] = (struct cover){left, width};
    put_style(&w, style);
    return w;
}

static void end_row(struct writer *w, unsigned row)
{
    put_blanks(w, w->left);
    w->sheet->ends[row] = w->sheet->text.count;
}

/* Writes the parts of the status that fit, the first one in any case. */
static void put_status(struct sheet *sheet, const char *status)
{
    unsigned row = sheet->window.rows - 1;
    struct writer w = begin_row(sheet, row, 0, sheet->window.columns, TITLE_KEY);

    put_blanks(&w, MARGIN);
    put(&w, take(&status, '\t'));
    put_style(&w, TITLE);
    while (*status != '\0') {
        struct part part = take(&status, '\t');
        if (length_of(part) + GAP > w.left)
            continue;
        put_blanks(&w, GAP);
        put(&w, part);
    }
    end_row(&w, row);
}

/* Returns the width of notes: the longest line, rounded up. */
static unsigned notes_width(const char *notes, unsigned columns)
{
    unsigned longest = 0, width;

    while (*notes != '\0') {
        unsigned length = length_of(take(&notes, '\n'));
        longest = length > longest ? length : longest;
    }
    width = (longest + 2 * MARGIN + NOTES_STEP - 1) / NOTES_STEP * NOTES_STEP;
    return width < columns ? width : columns;
}

static void put_notes(struct sheet *sheet, const char *notes, unsigned rows)
{
    unsigned width = notes_width(notes, sheet->window.columns);
    unsigned inside = width > 2 * MARGIN + 1 ? width - 2 * MARGIN : 1;

    for (unsigned row = 0; *notes != '\0' && row < rows;) {
        struct part line = take(&notes, '\n');
        do {
            struct writer w = begin_row(sheet, row, 0, width, BODY);
            put_blanks(&w, MARGIN);
            put(&w, take_fitting(&line, inside));
            end_row(&w, row++);
        } while (line.length > 0 && row < rows);
    }
}

/* ---- the panel ---- */

/* A line of the panel: what it is about, and the text. */
struct panel_line {
    struct part key, text;
};

struct panel {
    unsigned key_columns, text_columns, count;
    struct panel_line lines[PANEL_LINES];
};

/* Finds the widths of both parts: the longest, or what the window has. */
static void measure_panel(struct panel *panel, const char *text, unsigned columns)
{
    unsigned inside = columns > 2 * MARGIN + 1 ? columns - 2 * MARGIN : 1;

    while (*text != '\0') {
        struct part line = take(&text, '\n');
        const char *tab = memchr(line.text, '\t', line.length);
        unsigned key = tab ? (unsigned)(tab - line.text) : 0;
        unsigned rest = (unsigned)line.length - key - (tab ? 1 : 0);
        panel->key_columns = key > panel->key_columns ? key : panel->key_columns;
        panel->text_columns = rest > panel->text_columns ? rest : panel->text_columns;
    }
    unsigned most = inside > GAP + LEAST_TEXT + 1 ? inside - GAP - LEAST_TEXT : 1;
    panel->key_columns = panel->key_columns < most ? panel->key_columns : most;
    most = inside > panel->key_columns + GAP ? inside - panel->key_columns - GAP : 1;
    panel->text_columns = panel->text_columns < most ? panel->text_columns : most;
}

static void wrap_panel(struct panel *panel, const char *text)
{
    while (*text != '\0') {
        struct part line = take(&text, '\n'), key = {line.text, 0};
        const char *tab = memchr(line.text, '\t', line.length);
        if (tab) {
            key.length = (size_t)(tab - line.text);
            line = (struct part){tab + 1, line.length - key.length - 1};
        }
        do {
            if (panel->count == PANEL_LINES)
                return;
            struct panel_line *now = &panel->lines[panel->count++];
            now->key = take_fitting(&key, panel->key_columns);
            now->text = take_fitting(&line, panel->text_columns);
        } while (key.length > 0 || line.length > 0);
    }
}

static void put_title(struct sheet *sheet, const struct port_text *text, const struct panel *panel, unsigned shown,
                      unsigned left, unsigned width)
{
    struct writer w = begin_row(sheet, 0, left, width, TITLE_KEY);
    char where[48] = "";

    if (text->more)
        (void)snprintf(where, sizeof where, "%u-%u of %u, %s", text->first + 1, text->first + shown, panel->count,
                       text->scroll ? text->scroll : "");
    put_blanks(&w, MARGIN);
    put(&w, part_of(text->title ? text->title : ""));
    put_style(&w, TITLE);
    put_blanks(&w, GAP);
    put(&w, part_of(where));
    end_row(&w, 0);
}

/* Puts the panel into the middle, below the window's first row, which has its title. */
static void put_panel(struct sheet *sheet, struct port_text *text, unsigned rows)
{
    struct panel panel = {0};
    unsigned columns = sheet->window.columns;

    measure_panel(&panel, text->panel, columns);
    wrap_panel(&panel, text->panel);
    unsigned width = panel.key_columns + GAP + panel.text_columns + 2 * MARGIN, shown = rows > 1 ? rows - 1 : 0;
    width = width < columns ? width : columns;
    unsigned left = (columns - width) / 2;
    text->more = panel.count > shown;
    shown = text->more ? shown : panel.count;
    text->first = text->first + shown > panel.count ? panel.count - shown : text->first;
    put_title(sheet, text, &panel, shown, left, width);
    for (unsigned i = 0; i < shown; i++) {
        const struct panel_line *line = &panel.lines[text->first + i];
        struct writer w = begin_row(sheet, i + 1, left, width, KEY);
        put_blanks(&w, MARGIN);
        put(&w, line->key);
        put_blanks(&w, panel.key_columns - (unsigned)line->key.length + GAP);
        put_style(&w, BODY);
        put(&w, line->text);
        end_row(&w, i + 1);
    }
}

/* ---- the sheet ---- */

static bool make_room(struct sheet *sheet, unsigned rows)
{
    if (sheet->covers && sheet->window.rows == rows)
        return true;
    sheet_free(sheet);
    sheet->covers = calloc(rows, sizeof *sheet->covers);
    sheet->ends = calloc(rows, sizeof *sheet->ends);
    if (sheet->covers && sheet->ends)
        return true;
    sheet_free(sheet);
    return false;
}

static bool is_some(const char *text)
{
    return text && *text != '\0';
}

/* Rows without text end where the row before ends. */
static void fill_ends(struct sheet *sheet)
{
    for (unsigned row = 1; row < sheet->window.rows; row++)
        if (sheet->ends[row] < sheet->ends[row - 1])
            sheet->ends[row] = sheet->ends[row - 1];
}

void sheet_compose(struct sheet *sheet, struct port_text *text, const struct sheet_window *window)
{
    bool room = make_room(sheet, window->rows);

    sheet->window = *window;
    sheet->known = false;
    sheet->text.count = 0;
    sheet->text.failed = !room;
    text->more = false;
    if (!room)
        return;
    memset(sheet->covers, 0, window->rows * sizeof *sheet->covers);
    memset(sheet->ends, 0, window->rows * sizeof *sheet->ends);
    bool status = is_some(text->status) && window->rows >= SHEET_STATUS_ROWS;
    unsigned rows = status ? window->rows - 1 : window->rows;
    if (is_some(text->panel) && rows > 0)
        put_panel(sheet, text, rows);
    else if (is_some(text->notes))
        put_notes(sheet, text->notes, rows);
    if (status)
        put_status(sheet, text->status);
    fill_ends(sheet);
    if (sheet->text.failed)
        memset(sheet->covers, 0, window->rows * sizeof *sheet->covers);
}

static void erase(const struct sheet *sheet, unsigned row, struct text *text)
{
    const struct cover *cover = &sheet->covers[row];
    char move[64];

    (void)snprintf(move, sizeof move, "\033[%u;%uH\033[0%sm", row + 1, cover->left + 1,
                   sheet->window.bare_back ? "" : backs[sheet->window.colours]);
    text_add(text, move);
    for (unsigned i = 0; i < cover->width; i++)
        text_add(text, " ");
}

static bool same_cover(const struct cover *a, const struct cover *b)
{
    return a->width == b->width && (a->left == b->left || a->width == 0);
}

void sheet_erase(const struct sheet *before, const struct sheet *now, struct text *text)
{
    if (!before->known || !before->covers || before->window.rows != now->window.rows)
        return;
    for (unsigned row = 0; row < now->window.rows; row++)
        if (before->covers[row].width > 0 && !(now->covers && same_cover(&before->covers[row], &now->covers[row])))
            erase(before, row, text);
}

static struct part row_of(const struct sheet *sheet, unsigned row)
{
    size_t from = row > 0 ? sheet->ends[row - 1] : 0;

    return (struct part){sheet->text.bytes ? sheet->text.bytes + from : NULL, sheet->ends[row] - from};
}

static void add(struct text *text, struct part part)
{
    for (size_t i = 0; i < part.length; i++)
        text_add(text, (const char[]){part.text[i], '\0'});
}

void sheet_draw(const struct sheet *before, struct sheet *now, struct text *text)
{
    bool all = !before->known || !before->covers || before->window.rows != now->window.rows;

    for (unsigned row = 0; now->covers && row < now->window.rows; row++) {
        struct part want = row_of(now, row), had = all ? (struct part){NULL, 0} : row_of(before, row);
        if (want.length > 0 && (all || want.length != had.length || memcmp(want.text, had.text, want.length) != 0))
            add(text, want);
    }
    now->known = !text->failed;
}

void sheet_free(struct sheet *sheet)
{
    free(sheet->covers);
    free(sheet->ends);
    text_free(&sheet->text);
    *sheet = (struct sheet){.known = false};
}
