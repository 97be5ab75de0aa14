/* encode.c - encodes the cells that have changed, in few bytes. */
#include "encode.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "dither.h"
#include "terminal_colour.h"

#define BLACK_256 16
#define UNKNOWN UINT32_MAX /* neither a colour's code nor a cell's column */

static bool text_room(struct text *text, size_t more)
{
    if (text->capacity - text->count >= more)
        return true;
    size_t capacity = text->capacity * 2 > text->count + more ? text->capacity * 2 : text->count + more;
    char *bytes = realloc(text->bytes, capacity);
    if (!bytes) {
        text->failed = true;
        return false;
    }
    text->bytes = bytes;
    text->capacity = capacity;
    return true;
}

void text_add(struct text *text, const char *string)
{
    size_t n = strlen(string);

    if (text_room(text, n)) {
        memcpy(text->bytes + text->count, string, n);
        text->count += n;
    }
}

void text_free(struct text *text)
{
    free(text->bytes);
    *text = (struct text){0};
}

/* Returns the number of the window's columns that a cell covers. */
static unsigned span(const struct grid *grid)
{
    return grid->spaces ? 2 : 1;
}

int grid_resize(struct grid *grid, unsigned width, unsigned height, unsigned window_columns, unsigned window_rows)
{
    unsigned rows = grid->spaces ? height : (height + 1) / 2, columns = width * span(grid);

    grid_free(grid);
    grid->cells = malloc((size_t)width * rows * sizeof *grid->cells);
    if (!grid->cells)
        return TIA_ERR_MEMORY;
    grid->columns = width;
    grid->rows = rows;
    grid->left = window_columns > columns ? (window_columns - columns) / 2 : 0;
    grid->top = (window_rows - rows) / 2;
    grid_forget(grid);
    return TIA_OK;
}

void grid_forget(struct grid *grid)
{
    grid->known = false;
}

void grid_free(struct grid *grid)
{
    free(grid->cells);
    grid->cells = NULL;
    grid->columns = grid->rows = 0;
}

/* The pen: the terminal's cursor position, and the colours that are set. */
struct pen {
    struct text *text;
    bool direct, few;
    unsigned column, row; /* position in the grid, or UNKNOWN */
    uint32_t fore, back;  /* codes, or UNKNOWN */
};

/* Appends bytes. This function and those below need room, which draw_row has reserved. */
static void put(struct text *text, const char *bytes, size_t count)
{
    memcpy(text->bytes + text->count, bytes, count);
    text->count += count;
}

static void put_number(struct text *text, unsigned n)
{
    char digits[10];
    size_t count = 0;

    do
        digits[sizeof digits - ++count] = (char)('0' + n % 10);
    while (n /= 10);
    put(text, digits + sizeof digits - count, count);
}

static void move(struct pen *pen, const struct grid *grid, unsigned column, unsigned row)
{
    struct text *text = pen->text;
    unsigned left = grid->left + column * span(grid), gap = (column - pen->column) * span(grid);

    if (row == pen->row && column == pen->column)
        return;
    put(text, "\033[", 2);
    if (row == pen->row && pen->column < column) {
        if (gap > 1)
            put_number(text, gap);
        put(text, "C", 1);
        return;
    }
    put_number(text, grid->top + row + 1);
    if (left > 0) {
        put(text, ";", 1);
        put_number(text, left + 1);
    }
    put(text, "H", 1);
}

static void put_colour(struct pen *pen, const char *direct, const char *indexed, uint32_t code)
{
    if (pen->direct) {
        struct rgb8 c = colour_expand((tia_rgb565)code);
        put(pen->text, direct, 5);
        put_number(pen->text, c.r);
        put(pen->text, ";", 1);
        put_number(pen->text, c.g);
        put(pen->text, ";", 1);
        put_number(pen->text, c.b);
    } else if (pen->few) {
        put_number(pen->text, colour_code(code, direct[0] == '4'));
    } else {
        put(pen->text, indexed, 5);
        put_number(pen->text, code);
    }
}

static void set_colours(struct pen *pen, uint32_t fore, uint32_t back)
{
    bool change_fore = fore != pen->fore, change_back = back != pen->back;

    if (!change_fore && !change_back)
        return;
    put(pen->text, "\033[", 2);
    if (change_fore)
        put_colour(pen, "38;2;", "38;5;", fore);
    if (change_fore && change_back)
        put(pen->text, ";", 1);
    if (change_back)
        put_colour(pen, "48;2;", "48;5;", back);
    put(pen->text, "m", 1);
    pen->fore = fore;
    pen->back = back;
}

static const char upper_block[] = "\xe2\x96\x80", lower_block[] = "\xe2\x96\x84", full_block[] = "\xe2\x96\x88";

/* Writes a cell of a terminal whose backgrounds are the first 8 of the 16 colours: a bright colour is the block's. Of
 * two different bright ones the upper becomes the dark one of its hue. */
static void put_dim_cell(struct pen *pen, uint32_t upper, uint32_t lower)
{
    bool full = upper == lower;

    set_colours(pen, lower, full ? pen->back : upper & 7);
    put(pen->text, full ? full_block : lower_block, 3);
}

/* Writes a cell of two pixels, or one of two spaces. A single colour is written as spaces, which need no foreground
 * colour. */
static void put_colours(struct pen *pen, const struct grid *grid, uint32_t upper, uint32_t lower)
{
    set_colours(pen, upper == lower ? pen->fore : upper, lower);
    if (upper == lower)
        put(pen->text, "  ", span(grid));
    else
        put(pen->text, upper_block, 3);
}

static void put_cell(struct pen *pen, const struct grid *grid, unsigned column, unsigned row, uint32_t cell)
{
    uint32_t upper = cell >> 16, lower = cell & 0xffff;

    move(pen, grid, column, row);
    if (grid->letters)
        put(pen->text, &(char){(char)cell}, 1);
    else if (grid->dim_back && !grid->spaces && lower > 7)
        put_dim_cell(pen, upper, lower);
    else
        put_colours(pen, grid, upper, lower);
    pen->row = row;
    pen->column = column + 1; /* terminals differ after the last column, but no cell of the row follows it */
}

static uint32_t code_of(const struct grid *grid, tia_rgb565 pixel, unsigned x, unsigned y)
{
    if (grid->direct)
        return pixel;
    return grid->dither ? dither_pixel(grid->dither, pixel, x, y) : colour_nearest(colour_expand(pixel));
}

static uint32_t cell_of(const struct grid *grid, const tia_rgb565 *pixels, unsigned height, unsigned column,
                        unsigned row)
{
    const tia_rgb565 *upper = pixels + (size_t)(grid->spaces ? 1 : 2) * row * grid->columns + column;
    uint32_t lower = grid->direct || grid->few ? 0 : BLACK_256;

    if (grid->letters)
        return (unsigned char)colour_letter(*upper, 2 * row + 1 < height ? upper[grid->columns] : *upper);
    if (grid->spaces) {
        lower = code_of(grid, *upper, column, row);
        return lower << 16 | lower;
    }
    if (2 * row + 1 < height)
        lower = code_of(grid, upper[grid->columns], column, 2 * row + 1);
    return code_of(grid, *upper, column, 2 * row) << 16 | lower;
}

/* True if text covers a part of the cell. */
static bool is_hidden(const struct grid *grid, unsigned column, unsigned row)
{
    const struct cover *cover = grid->covers ? &grid->covers[grid->top + row] : NULL;
    unsigned left = grid->left + column * span(grid);

    return cover && left + span(grid) > cover->left && left < cover->left + cover->width;
}

static void draw_row(struct pen *pen, struct grid *grid, const tia_rgb565 *pixels, unsigned height, unsigned row)
{
    uint64_t *cells = grid->cells + (size_t)row * grid->columns;

    if (!text_room(pen->text, (size_t)grid->columns * GRID_CELL_BYTES))
        return;
    for (unsigned column = 0; column < grid->columns; column++) {
        if (is_hidden(grid, column, row)) {
            cells[column] = GRID_HIDDEN;
            continue;
        }
        uint32_t cell = cell_of(grid, pixels, height, column, row);
        if (!grid->known || cell != cells[column]) {
            put_cell(pen, grid, column, row, cell);
            cells[column] = cell;
        }
    }
}

void grid_draw(struct grid *grid, const tia_rgb565 *pixels, unsigned height, struct text *text)
{
    struct pen pen = {text, grid->direct, grid->few, UNKNOWN, UNKNOWN, UNKNOWN, UNKNOWN};
    size_t before = text->count, begun;

    text_add(text, FRAME_BEGIN);
    if (grid->letters)
        text_add(text, "\033[0m"); /* the text over the picture may be bold or reversed */
    begun = text->count;
    for (unsigned row = 0; row < grid->rows && !text->failed; row++)
        draw_row(&pen, grid, pixels, height, row);
    bool changed = text->count > begun;
    text_add(text, FRAME_END);
    if (text->failed || !changed)
        text->count = before;
    grid->known = !text->failed;
}

void grid_print(struct grid *grid, const tia_rgb565 *pixels, unsigned height, struct text *text)
{
    for (unsigned row = 0; row < grid->rows && text_room(text, (size_t)grid->columns * GRID_CELL_BYTES); row++) {
        struct pen pen = {text, grid->direct, grid->few, 0, row, UNKNOWN, UNKNOWN};
        for (unsigned column = 0; column < grid->columns; column++)
            put_cell(&pen, grid, column, row, cell_of(grid, pixels, height, column, row));
        text_add(text, grid->letters ? "\r\n" : LINE_END);
    }
}
