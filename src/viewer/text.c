/* text.c - small text, and its font. */
#include <tia/text.h>

#include "math/tile.h"

/* Glyphs from ' ' to '~': eight rows of five dots in 40 bits, the top row in the highest bits, and the left dot of a
 * row in the row's highest bit. */
static const uint64_t font[95] = {
    0x0000000000, 0x2108400080, 0x5280000000, 0x52beafa940, 0x23e0e0f880, 0xce44444e60, 0x64a88ac9a0, 0x2100000000,
    0x1110841040, 0x4104211100, 0x012aea9000, 0x0109f21000, 0x0000001088, 0x0001f00000, 0x0000003180, 0x0844444200,
    0x74675cc5c0, 0x23084211c0, 0x74426443e0, 0x744260c5c0, 0x11952f8840, 0xfc3c10c5c0, 0x3221e8c5c0, 0xf844442100,
    0x7462e8c5c0, 0x7462f08980, 0x0318063000, 0x0108001088, 0x0888820820, 0x003e0f8000, 0x8208222200, 0x7442620080,
    0x746f5bc1c0, 0x7463f8c620, 0xf463e8c7c0, 0x74610845c0, 0xf46318c7c0, 0xfc21e843e0, 0xfc21e84200, 0x746178c5e0,
    0x8c63f8c620, 0x71084211c0, 0x3884214980, 0x8ca98a4a20, 0x84210843e0, 0x8eeb58c620, 0x8e7359ce20, 0x746318c5c0,
    0xf463e84200, 0x74631ac9a0, 0xf463ea4a20, 0x7c20e087c0, 0xf908421080, 0x8c6318c5c0, 0x8c63152880, 0x8c635aee20,
    0x8c54454620, 0x8c54421080, 0xf8444443e0, 0x72108421c0, 0x8410410420, 0x70842109c0, 0x22a2000000, 0x000000001f,
    0x4100000000, 0x001c17c5e0, 0x843d18c7c0, 0x001d0841c0, 0x085f18c5e0, 0x001d1fc1c0, 0x3238842100, 0x001f18bc2e,
    0x843d18c620, 0x20184211c0, 0x100c21084c, 0x84254c5240, 0x61084211c0, 0x00355ad6a0, 0x003d18c620, 0x001d18c5c0,
    0x003d18fa10, 0x001f18bc21, 0x002d984200, 0x001f0707c0, 0x42388420c0, 0x002318c5e0, 0x0023152880, 0x00231ad540,
    0x0022a22a20, 0x002318bc2e, 0x003e2223e0, 0x1108821040, 0x2108421080, 0x4108221100, 0x0011510000,
};

static uint64_t glyph(char c)
{
    return c >= ' ' && c <= '~' ? font[c - ' '] : 0;
}

/* ---- lines ---- */

static unsigned line_length(const char *line)
{
    unsigned length = 0;

    while (line[length] && line[length] != '\n')
        length++;
    return length;
}

/* Returns the next line; NULL: there is none. */
static const char *next_line(const char *line)
{
    line += line_length(line);
    return *line ? line + 1 : NULL;
}

struct tia_tile tia_text_area(const struct tia_text *text, unsigned width, unsigned height)
{
    size_t columns = 0, lines = 0;

    if (!text || !text->text)
        return (struct tia_tile){0, 0, 0, 0};
    for (const char *line = text->text; line; line = next_line(line)) {
        columns = line_length(line) > columns ? line_length(line) : columns;
        lines++;
    }
    columns = (columns * TIA_TEXT_WIDTH + 1) * text->scale;
    lines = (lines * TIA_TEXT_HEIGHT + 1) * text->scale;
    width = width > text->x ? width - text->x : 0;
    height = height > text->y ? height - text->y : 0;
    return (struct tia_tile){text->x, text->y, (uint16_t)(columns < width ? columns : width),
                             (uint16_t)(lines < height ? lines : height)};
}

/* ---- drawing ---- */

/* A row of dots; row 0 is the border above the text. */
struct row {
    const char *line; /* NULL: there is no text */
    unsigned length, dots;
};

static struct row row_of(const struct tia_text *text, unsigned dots)
{
    const char *line = dots ? text->text : NULL;

    for (unsigned i = 0; line && i < (dots - 1) / TIA_TEXT_HEIGHT; i++)
        line = next_line(line);
    return (struct row){line, line ? line_length(line) : 0, dots ? (dots - 1) % TIA_TEXT_HEIGHT : 0};
}

static bool is_ink(const struct row *row, unsigned column)
{
    unsigned letter = column ? (column - 1) / TIA_TEXT_WIDTH : 0, dot = column ? (column - 1) % TIA_TEXT_WIDTH : 5;

    if (dot == 5 || letter >= row->length)
        return false;
    return glyph(row->line[letter]) >> (39 - 5 * row->dots - dot) & 1;
}

int tia_text_draw(const struct tia_text *text, struct tia_tile tile, const struct tia_surface *surface)
{
    struct tia_tile area = tia_text_area(text, TIA_SIZE_MAX, TIA_SIZE_MAX);

    if (!text || !text->text || !surface_is_usable(surface))
        return TIA_ERR_ARGUMENT;
    unsigned left = tile.x > area.x ? tile.x : area.x, top = tile.y > area.y ? tile.y : area.y;
    unsigned right = (unsigned)area.x + area.width, bottom = (unsigned)area.y + area.height;

    for (unsigned y = top; y < bottom && y < (unsigned)tile.y + tile.height; y++) {
        struct row row = row_of(text, (y - area.y) / text->scale);
        char *out = (char *)surface->pixels + (ptrdiff_t)(y - tile.y) * surface->pitch;
        for (unsigned x = left; x < right && x < (unsigned)tile.x + tile.width; x++)
            *(tia_rgb565 *)(void *)(out + (ptrdiff_t)(x - tile.x) * surface->step) =
                surface_order(surface, is_ink(&row, (x - area.x) / text->scale) ? text->ink : text->paper);
    }
    return TIA_OK;
}
