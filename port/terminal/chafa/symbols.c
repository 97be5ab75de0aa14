/* symbols.c - libchafa chooses the characters and their colours; what changed is written here. */
#include "terminal/symbols.h"

#include <chafa.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "terminal/chafa/expand.h"
#include "terminal/colour.h"

#define POINTS 8 /* of a character, across */
#define UNKNOWN UINT32_MAX
#define BRAILLE_BLANK 0x2800

static const char frame_begin[] = "\033[?2026h", frame_end[] = "\033[?2026l";

/* Colours are 0xrrggbb, or indices of the 256. */
struct symbol {
    uint32_t code, fore, back;
};

/* Where the cursor is and which colours it has. */
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
    *symbols = (struct symbols){0};
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
    chafa_symbol_map_remove_by_range(map, BRAILLE_BLANK, BRAILLE_BLANK); /* the space is in every font */
    return map;
}

static ChafaCanvas *canvas_new(unsigned columns, unsigned rows)
{
    ChafaCanvasConfig *config = chafa_canvas_config_new();
    ChafaSymbolMap *map = map_new();

    chafa_canvas_config_set_geometry(config, (gint)columns, (gint)rows);
    chafa_canvas_config_set_pixel_mode(config, CHAFA_PIXEL_MODE_SYMBOLS);
    chafa_canvas_config_set_canvas_mode(config, CHAFA_CANVAS_MODE_TRUECOLOR);
    chafa_canvas_config_set_symbol_map(config, map);
    ChafaCanvas *canvas = chafa_canvas_new(config);
    chafa_symbol_map_unref(map);
    chafa_canvas_config_unref(config);
    return canvas;
}

static uint32_t code_of(gint colour, bool direct)
{
    uint32_t c = (uint32_t)colour & 0xffffff;

    return direct ? c : colour_nearest((struct rgb8){(uint8_t)(c >> 16), (uint8_t)(c >> 8), (uint8_t)c});
}

/* A character of one colour is a space, which needs no foreground colour. */
static struct symbol symbol_at(ChafaCanvas *canvas, unsigned column, unsigned row, bool direct)
{
    gint fore, back;
    struct symbol s = {.code = chafa_canvas_get_char_at(canvas, (gint)column, (gint)row)};

    chafa_canvas_get_colors_at(canvas, (gint)column, (gint)row, &fore, &back);
    s.fore = code_of(fore, direct);
    s.back = code_of(back, direct);
    if (s.fore == s.back || s.code == ' ') {
        s.code = ' ';
        s.fore = s.back;
    }
    return s;
}

static void put_colour(struct text *text, char ground, uint32_t code, bool direct)
{
    char sequence[32];

    if (direct)
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

static void put_symbol(struct pen *pen, const struct symbol *s, bool direct, struct text *text)
{
    char character[7] = "";

    if (s->code != ' ' && s->fore != pen->fore) {
        put_colour(text, '3', s->fore, direct);
        pen->fore = s->fore;
    }
    if (s->back != pen->back) {
        put_colour(text, '4', s->back, direct);
        pen->back = s->back;
    }
    (void)g_unichar_to_utf8(s->code, character);
    text_add(text, character);
}

static void put_changed(struct symbols *symbols, ChafaCanvas *canvas, bool direct, struct text *text)
{
    struct pen pen = {UNKNOWN, UNKNOWN, UNKNOWN, UNKNOWN};

    for (unsigned i = 0; i < symbols->columns * symbols->rows; i++) {
        unsigned column = i % symbols->columns, row = i / symbols->columns;
        struct symbol s = symbol_at(canvas, column, row, direct), *known = &symbols->cells[i];
        if (symbols->known && s.code == known->code && s.fore == known->fore && s.back == known->back)
            continue;
        move(&pen, column, row, text);
        put_symbol(&pen, &s, direct, text);
        pen.column = column + 1; /* after the last column terminals differ, but there the next row begins */
        pen.row = row;
        *known = s;
    }
}

/* Adds nothing where nothing changed. */
static void put_frame(struct symbols *symbols, ChafaCanvas *canvas, bool direct, struct text *text)
{
    size_t before = text->count, begun;

    text_add(text, frame_begin);
    begun = text->count;
    put_changed(symbols, canvas, direct, text);
    bool changed = text->count > begun;
    text_add(text, frame_end);
    if (text->failed || !changed)
        text->count = before;
    symbols->known = !text->failed;
}

void symbols_draw(struct symbols *symbols, const tia_rgb565 *pixels, unsigned width, unsigned height, bool direct,
                  struct text *text)
{
    unsigned columns = width / SYMBOLS_WIDTH, rows = height / SYMBOLS_HEIGHT;
    uint8_t *rgba = expand(pixels, (size_t)width * height, POINTS / SYMBOLS_WIDTH);

    if (!rgba || !resize(symbols, columns, rows)) {
        free(rgba);
        symbols_free(symbols);
        text->failed = true;
        return;
    }
    chafa_set_n_threads(1); /* a port starts none */
    ChafaCanvas *canvas = canvas_new(columns, rows);
    chafa_canvas_draw_all_pixels(canvas, CHAFA_PIXEL_RGBA8_UNASSOCIATED, rgba, (gint)(columns * POINTS),
                                 (gint)(rows * SYMBOLS_HEIGHT), (gint)(4 * columns * POINTS));
    put_frame(symbols, canvas, direct, text);
    chafa_canvas_unref(canvas);
    free(rgba);
}
