/* none.c - builds without libchafa: the terminal shows half blocks and gets no queries. */
#include <stddef.h>

#include "terminal/pictures.h"
#include "terminal/symbols.h"

enum pictures pictures_find(int fd, struct cell *cell)
{
    (void)fd, (void)cell;
    return PICTURES_HALF_BLOCKS;
}

const char *pictures_need(int fd, enum pictures pictures, struct cell *cell)
{
    (void)fd, (void)cell;
    return pictures == PICTURES_HALF_BLOCKS ? NULL : "built without libchafa, shows halfblocks alone";
}

uint16_t pictures_width(const struct cell *cell, unsigned columns, unsigned most)
{
    (void)cell, (void)columns;
    return (uint16_t)most;
}

uint16_t pictures_height(enum pictures pictures, const struct cell *cell, unsigned rows, unsigned most)
{
    (void)pictures, (void)cell, (void)rows;
    return (uint16_t)most;
}

struct strip pictures_strip(enum pictures pictures, const struct cell *cell, unsigned first, unsigned width,
                            unsigned height)
{
    (void)pictures, (void)cell, (void)width;
    return (struct strip){first, height - first};
}

void pictures_draw(enum pictures pictures, const tia_rgb565 *pixels, unsigned width, struct strip strip,
                   const struct cell *cell, struct text *text)
{
    (void)pictures, (void)pixels, (void)width, (void)strip, (void)cell, (void)text;
}

void pictures_print(enum pictures pictures, const tia_rgb565 *pixels, unsigned width, unsigned height,
                    const struct cell *cell, struct text *text)
{
    (void)pictures, (void)pixels, (void)width, (void)height, (void)cell, (void)text;
}

void symbols_draw(struct symbols *symbols, const tia_rgb565 *pixels, unsigned width, unsigned height,
                  struct strip strip, bool direct, struct text *text)
{
    (void)symbols, (void)pixels, (void)width, (void)height, (void)strip, (void)direct, (void)text;
}

void symbols_forget(struct symbols *symbols)
{
    (void)symbols;
}

void symbols_free(struct symbols *symbols)
{
    (void)symbols;
}
