/* symbols.c - libchafa chooses the characters and their colours; this file writes those that changed. */
#include "terminal/symbols.h"

#include <chafa.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "terminal/chafa/chafa_pixels.h"
#include "terminal/terminal_colour.h"

#define POINTS 8 /* points across a character */
#define UNKNOWN UINT32_MAX
#define BRAILLE_BLANK 0x2800

/* A character; colours are 0xrrggbb, or indices of the 256 or 16. */
struct symbol {
    uint32_t code, fore, back;
};

/* The cursor's position and the colours that are set. */
struct pen {
    unsigned column, row;
    uint32_t fore, back;
};

void symbols_forget(struct symbols *symbols)
{
    symbols->known = false;
}

void symbols_free(struct symbols *symbols)
{
    free(symbols->cells);
    *symbols = (struct symbols){.few = symbols->few, .prints = symbols->prints, .covers = symbols->covers};
}

static bool is_hidden(const struct symbols *symbols, unsigned column, unsigned row)
{
    const struct cover *cover = symbols->covers ? &symbols->covers[row] : NULL;

    return cover && column >= cover->left && column < cover->left + cover->width;
}

static bool resize(struct symbols *symbols, unsigned columns, unsigned rows)
{
    if (symbols->cells && symbols->columns == columns && symbols->rows == rows)
        return true;
    symbols_free(symbols);
    symbols->cells = malloc((size_t)columns * rows * sizeof *symbols->cells);
    symbols->columns = columns;
    symbols->rows = rows;
    return symbols->cells;
}

static ChafaSymbolMap *map_new(void)
{
    ChafaSymbolMap *map = chafa_symbol_map_new();

    chafa_symbol_map_add_by_tags(map, CHAFA_SYMBOL_TAG_SPACE | CHAFA_SYMBOL_TAG_BLOCK | CHAFA_SYMBOL_TAG_BORDER |
                                          CHAFA_SYMBOL_TAG_BRAILLE);
    chafa_symbol_map_remove_by_tags(map, CHAFA_SYMBOL_TAG_WIDE);
    chafa_symbol_map_remove_by_range(map, BRAILLE_BLANK, BRAILLE_BLANK); /* a space, equally blank, is in every font */
    return map;
}

/* Makes a canvas. A palette's colours are dithered in DIN99d, a space of nearly uniform perceived distances. */
static ChafaCanvas *canvas_new(unsigned columns, unsigned rows, ChafaCanvasMode mode)
{
    ChafaCanvasConfig *config = chafa_canvas_config_new();
    ChafaSymbolMap *map = map_new();

    chafa_canvas_config_set_geometry(config, (gint)columns, (gint)rows);
    chafa_canvas_config_set_pixel_mode(config, CHAFA_PIXEL_MODE_SYMBOLS);
    chafa_canvas_config_set_canvas_mode(config, mode);
    if (mode != CHAFA_CANVAS_MODE_TRUECOLOR) {
        chafa_canvas_config_set_color_space(config, CHAFA_COLOR_SPACE_DIN99D);
        chafa_canvas_config_set_dither_mode(config, CHAFA_DITHER_MODE_ORDERED);
    }
    chafa_canvas_config_set_symbol_map(config, map);
    ChafaCanvas *canvas = chafa_canvas_new(config);
    chafa_symbol_map_unref(map);
    chafa_canvas_config_unref(config);
    return canvas;
}

/* Returns a cell's character. A character of one colour is a space, which needs no foreground colour. */
static struct symbol symbol_at(ChafaCanvas *canvas, unsigned column, unsigned row, bool direct)
{
    gint fore, back;
    struct symbol s = {.code = chafa_canvas_get_char_at(canvas, (gint)column, (gint)row)};

    if (direct)
        chafa_canvas_get_colors_at(canvas, (gint)column, (gint)row, &fore, &back);
    else
        chafa_canvas_get_raw_colors_at(canvas, (gint)column, (gint)row, &fore, &back);
    s.fore = (uint32_t)fore & 0xffffff;
    s.back = (uint32_t)back & 0xffffff;
    if (s.fore == s.back || s.code == ' ') {
        s.code = ' ';
        s.fore = s.back;
    }
    return s;
}

static void put_colour(struct text *text, char ground, uint32_t code, bool direct, bool few)
{
    char sequence[32];

    if (few && !direct)
        (void)snprintf(sequence, sizeof sequence, "\033[%um", colour_code(code, ground == '4'));
    else if (direct)
        (void)snprintf(sequence, sizeof sequence, "\033[%c8;2;%u;%u;%um", ground, (unsigned)(code >> 16),
                       (unsigned)(code >> 8 & 255), (unsigned)(code & 255));
    else
        (void)snprintf(sequence, sizeof sequence, "\033[%c8;5;%um", ground, (unsigned)code);
    text_add(text, sequence);
}

static void move(struct pen *pen, unsigned column, unsigned row, struct text *text)
{
    char sequence[32];

    if (pen->column == column && pen->row == row)
        return;
    (void)snprintf(sequence, sizeof sequence, "\033[%u;%uH", row + 1, column + 1);
    text_add(text, sequence);
}

static void put_symbol(struct pen *pen, const struct symbol *s, bool direct, bool few, struct text *text)
{
    char character[7] = "";

    if (s->code != ' ' && s->fore != pen->fore) {
        put_colour(text, '3', s->fore, direct, few);
        pen->fore = s->fore;
    }
    if (s->back != pen->back) {
        put_colour(text, '4', s->back, direct, few);
        pen->back = s->back;
    }
    (void)g_unichar_to_utf8(s->code, character);
    text_add(text, character);
}

/* Writes the characters that have changed; row 0 of the canvas is row `top` of the window. */
static void put_changed(struct symbols *symbols, ChafaCanvas *canvas, unsigned top, unsigned rows, bool direct,
                        struct text *text)
{
    struct pen pen = {UNKNOWN, UNKNOWN, UNKNOWN, UNKNOWN};

    for (unsigned i = 0; i < symbols->columns * rows; i++) {
        unsigned column = i % symbols->columns, row = i / symbols->columns;
        struct symbol s = symbol_at(canvas, column, row, direct);
        struct symbol *known = &symbols->cells[(size_t)top * symbols->columns + i];
        if (is_hidden(symbols, column, top + row)) {
            *known = (struct symbol){UNKNOWN, UNKNOWN, UNKNOWN};
            continue;
        }
        if (symbols->known && s.code == known->code && s.fore == known->fore && s.back == known->back)
            continue;
        if (symbols->prints && column == 0)
            pen = (struct pen){0, top + row, UNKNOWN, UNKNOWN};
        move(&pen, column, top + row, text);
        put_symbol(&pen, &s, direct, symbols->few, text);
        pen.column = column + 1; /* terminals differ after the last column, but then a new row begins */
        pen.row = top + row;
        *known = s;
        if (symbols->prints && column + 1 == symbols->columns)
            text_add(text, LINE_END);
    }
}

void symbols_draw(struct symbols *symbols, const tia_rgb565 *pixels, unsigned width, unsigned height,
                  struct strip strip, bool direct, struct text *text)
{
    unsigned columns = width / SYMBOLS_WIDTH, rows = strip.rows / SYMBOLS_HEIGHT, top = strip.first / SYMBOLS_HEIGHT;
    uint8_t *rgba = expand(pixels + (size_t)strip.first * width, (size_t)width * strip.rows, POINTS / SYMBOLS_WIDTH);

    if (!rgba || !resize(symbols, columns, height / SYMBOLS_HEIGHT)) {
        free(rgba);
        symbols_free(symbols);
        text->failed = true;
        return;
    }
    chafa_set_n_threads(1); /* ports start no threads */
    ChafaCanvasMode palette = symbols->few ? CHAFA_CANVAS_MODE_INDEXED_16 : CHAFA_CANVAS_MODE_INDEXED_240;
    ChafaCanvas *canvas = canvas_new(columns, rows, direct ? CHAFA_CANVAS_MODE_TRUECOLOR : palette);
    chafa_canvas_draw_all_pixels(canvas, CHAFA_PIXEL_RGBA8_UNASSOCIATED, rgba, (gint)(columns * POINTS),
                                 (gint)(rows * SYMBOLS_HEIGHT), (gint)(4 * columns * POINTS));
    put_changed(symbols, canvas, top, rows, direct, text);
    symbols->known = !text->failed && (symbols->known || top + rows == symbols->rows);
    chafa_canvas_unref(canvas);
    free(rgba);
}
