/* chafa.c - sixel and kitty's protocol by libchafa. */
#include <chafa.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "terminal/chafa/chafa_pixels.h"
#include "terminal/pictures.h"

/* Removes earlier pictures, which kitty's protocol would keep below the new one. */
static const char remove_before[] = "\033_Ga=d,q=2\033\\";

static unsigned cells(unsigned size, unsigned cell)
{
    return (size + cell - 1) / cell;
}

static ChafaCanvas *canvas_for(enum pictures pictures, unsigned width, unsigned height, unsigned cell_width,
                               unsigned cell_height)
{
    ChafaCanvasConfig *config = chafa_canvas_config_new();

    chafa_canvas_config_set_geometry(config, (gint)cells(width, cell_width), (gint)cells(height, cell_height));
    chafa_canvas_config_set_cell_geometry(config, (gint)cell_width, (gint)cell_height);
    chafa_canvas_config_set_pixel_mode(config,
                                       pictures == PICTURES_KITTY ? CHAFA_PIXEL_MODE_KITTY : CHAFA_PIXEL_MODE_SIXELS);
    chafa_canvas_config_set_canvas_mode(config, CHAFA_CANVAS_MODE_TRUECOLOR);
    ChafaCanvas *canvas = chafa_canvas_new(config);
    chafa_canvas_config_unref(config);
    return canvas;
}

/* Prints the canvas with the control sequences of any terminal: the answers have shown that this one supports them. */
static GString *print(ChafaCanvas *canvas)
{
    ChafaTermInfo *info = chafa_term_info_new(), *all = chafa_term_db_get_fallback_info(chafa_term_db_get_default());

    chafa_term_info_supplement(info, all);
    GString *printed = chafa_canvas_print(canvas, info);
    chafa_term_info_unref(all);
    chafa_term_info_unref(info);
    return printed;
}

/* Repairs base64: libchafa 1.12 does not shift the last bits of a part whose length is not a multiple of three. Each
 * such part ends with an alpha of 255, which must be encoded as "8=" or "w==", not as "P=" or "D==". */
static void mend_base64(char *text)
{
    for (char *end = strchr(text, '='); end; end = strchr(end + 1, '=')) {
        bool one_byte = end[1] == '=';
        if (memcmp(end + 1 + one_byte, "\033\\", 2) != 0 || end == text)
            continue;
        if (end[-1] == (one_byte ? 'D' : 'P'))
            end[-1] = one_byte ? 'w' : '8';
    }
}

/* A layer below all text and all backgrounds of cells but the terminal's own: the protocol has those below -2^30. */
#define BELOW_TEXT "z=-1073741825,"

/* Adds a picture of kitty's protocol in the layer below the text. */
static void add_below(const char *printed, struct text *text)
{
    const char *head = strstr(printed, "\033_G");

    if (!head) {
        text_add(text, printed);
        return;
    }
    head += strlen("\033_G");
    for (const char *at = printed; at < head; at++)
        text_add(text, (const char[]){*at, '\0'});
    text_add(text, BELOW_TEXT);
    text_add(text, head);
}

static void put_cursor(unsigned row, struct text *text)
{
    char sequence[32];

    (void)snprintf(sequence, sizeof sequence, "\033[%uH", row + 1);
    text_add(text, sequence);
}

/* Returns the text for a picture, to be freed by g_string_free; NULL: memory is short. */
static GString *encode(enum pictures pictures, const tia_rgb565 *pixels, unsigned width, unsigned height,
                       const struct cell *cell)
{
    uint8_t *rgba = expand(pixels, (size_t)width * height, 1);

    if (!rgba)
        return NULL;
    chafa_set_n_threads(1); /* ports start no threads */
    ChafaCanvas *canvas = canvas_for(pictures, width, height, cell->width, cell->height);
    chafa_canvas_draw_all_pixels(canvas, CHAFA_PIXEL_RGBA8_UNASSOCIATED, rgba, (gint)width, (gint)height,
                                 (gint)(4 * width));
    GString *printed = print(canvas);
    if (pictures == PICTURES_KITTY)
        mend_base64(printed->str);
    chafa_canvas_unref(canvas);
    free(rgba);
    return printed;
}

void pictures_draw(enum pictures pictures, const tia_rgb565 *pixels, unsigned width, struct strip strip,
                   const struct cell *cell, struct text *text)
{
    GString *printed = encode(pictures, pixels + (size_t)strip.first * width, width, strip.rows, cell);

    if (!printed) {
        text->failed = true;
        return;
    }
    if (pictures == PICTURES_KITTY && strip.first == 0)
        text_add(text, remove_before);
    put_cursor(strip.first / cell->height, text);
    if (pictures == PICTURES_KITTY)
        add_below(printed->str, text);
    else
        text_add(text, printed->str);
    (void)g_string_free(printed, TRUE);
}

void pictures_print(enum pictures pictures, const tia_rgb565 *pixels, unsigned width, unsigned height,
                    const struct cell *cell, struct text *text)
{
    GString *printed = encode(pictures, pixels, width, height, cell);

    text->failed = text->failed || !printed;
    if (!printed)
        return;
    text_add(text, printed->str);
    text_add(text, LINE_END);
    (void)g_string_free(printed, TRUE);
}
