/* display_frame.c - encodes frames: the picture's changes strip by strip, then the text over it. */
#include <string.h>

#include "display_state.h"

static const char clear_bare[] = "\033[0m\033[2J";
static const char clear_direct[] = "\033[48;2;0;0;0m\033[2J", clear_256[] = "\033[48;5;16m\033[2J",
                  clear_few[] = "\033[40m\033[2J";

/* Lays out the text of the frame. Cells that the text no longer covers are erased; in a character mode they are then
 * drawn as changed ones, a picture is drawn whole. */
static void begin_text(struct terminal *t)
{
    const struct sheet_window window = display_sheet_window(t);
    struct port_text none = {.status = NULL};
    struct text *text = &t->output.text;
    struct sheet before = t->before;
    size_t count = text->count;

    t->before = t->sheet;
    t->sheet = before;
    sheet_compose(&t->sheet, t->text ? t->text : &none, &window);
    sheet_erase(&t->before, &t->sheet, text);
    if (text->count > count)
        shown_forget(&t->shown);
    t->grid.covers = t->symbols.covers = t->sheet.covers;
}

/* Sets the window's title if it is another now. */
static void add_title(struct terminal *t)
{
    char sequence[TITLE_SIZE];

    if (!t->titles || !t->text || !t->text->window_title)
        return;
    title_sequence(sequence, t->text->window_title);
    if (strcmp(sequence, t->title) != 0)
        text_add(&t->output.text, strcpy(t->title, sequence));
}

static const char *clearing(const struct terminal *t)
{
    return t->pictures == PICTURES_KITTY || t->grid.letters ? clear_bare
           : t->grid.direct                                 ? clear_direct
           : t->grid.few                                    ? clear_few
                                                            : clear_256;
}

static void begin_frame(struct terminal *t)
{
    if (t->clear) {
        text_add(&t->output.text, clearing(t));
        grid_forget(&t->grid);
        symbols_forget(&t->symbols);
        shown_forget(&t->shown);
        t->sheet.known = false;
        t->title[0] = '\0';
    }
    add_title(t);
    begin_text(t);
    t->clear = t->fresh = t->begun = false;
    t->encoding = true;
    t->next = 0;
}

/* Encodes a strip; adds no text if nothing has changed. */
static void encode_strip(struct terminal *t)
{
    struct strip strip = pictures_strip(t->pictures, &t->cell, t->next, t->canvas.width, t->canvas.height);
    struct text *text = &t->output.text;
    size_t before = text->count, begun;

    if (!t->begun)
        text_add(text, FRAME_BEGIN);
    begun = text->count;
    if (t->pictures == PICTURES_SYMBOLS)
        symbols_draw(&t->symbols, t->canvas.pixels, t->canvas.width, t->canvas.height, strip, t->grid.direct, text);
    else if (t->pictures != PICTURES_SIXEL || shown_update(&t->shown, &t->canvas, strip))
        pictures_draw(t->pictures, t->canvas.pixels, t->canvas.width, strip, &t->cell, text);
    t->begun = t->begun || text->count > begun;
    if (!t->begun)
        text->count = before;
    t->next += strip.rows;
}

static void encode_next(struct terminal *t)
{
    if (!t->pictures) {
        grid_draw(&t->grid, t->canvas.pixels, t->canvas.height, &t->output.text);
        sheet_draw(&t->before, &t->sheet, &t->output.text);
        t->encoding = false;
        return;
    }
    encode_strip(t);
    t->encoding = t->next < t->canvas.height;
    if (t->encoding)
        return;
    t->before.known = t->before.known && !(t->begun && t->pictures > PICTURES_SYMBOLS); /* drawn over it */
    sheet_draw(&t->before, &t->sheet, &t->output.text);
    if (t->begun)
        text_add(&t->output.text, FRAME_END);
}

int display_encode(struct terminal *t)
{
    if (!t->encoding)
        begin_frame(t);
    encode_next(t);
    if (!t->output.text.failed)
        return TIA_OK;
    t->output.text.failed = t->encoding = false;
    t->clear = true;
    (void)display_failed(t, "out of memory");
    return TIA_ERR_MEMORY;
}

int display_print(struct terminal *t)
{
    const struct canvas *canvas = &t->canvas;
    struct text *text = &t->output.text;

    if (!t->pictures) {
        grid_print(&t->grid, canvas->pixels, canvas->height, text);
    } else if (t->pictures == PICTURES_SYMBOLS) {
        symbols_forget(&t->symbols);
        for (unsigned next = 0; next < canvas->height;) {
            struct strip strip = pictures_strip(t->pictures, &t->cell, next, canvas->width, canvas->height);
            symbols_draw(&t->symbols, canvas->pixels, canvas->width, canvas->height, strip, t->grid.direct, text);
            next += strip.rows;
        }
    } else {
        pictures_print(t->pictures, canvas->pixels, canvas->width, canvas->height, &t->cell, text);
    }
    if (!text->failed)
        return TIA_OK;
    (void)display_failed(t, "out of memory");
    return TIA_ERR_MEMORY;
}
