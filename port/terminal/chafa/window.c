/* window.c - the size of pictures in a terminal's window. */
#include <stdlib.h>
#include <sys/ioctl.h>

#include "terminal/pictures.h"
#include "terminal/symbols.h"

static const struct cell symbols_cell = {SYMBOLS_WIDTH, SYMBOLS_HEIGHT, {0, 0}};

static bool cell_is_known(int fd, struct cell *cell)
{
    struct winsize size;

    if (ioctl(fd, TIOCGWINSZ, &size) != 0 || !size.ws_col || !size.ws_row)
        return false;
    *cell = (struct cell){.width = size.ws_xpixel / size.ws_col, .height = size.ws_ypixel / size.ws_row};
    return cell->width && cell->height >= PICTURES_BAND;
}

enum pictures pictures_find(int fd, struct cell *cell)
{
    if (!cell_is_known(fd, cell))
        return PICTURES_HALF_BLOCKS;
    enum pictures found = answers_ask(fd, getenv("TERM"), &cell->limit);
    if (found == PICTURES_SYMBOLS)
        *cell = symbols_cell;
    return found;
}

/* Returns the reason why a multiplexer cannot show these pictures, or NULL. A multiplexer silently drops pictures that
 * it cannot show, but its answer reports sixel. */
static const char *multiplexer_needs(int fd, enum pictures pictures, struct limit *limit)
{
    const char *term = getenv("TERM");

    if (pictures <= PICTURES_SYMBOLS || !answers_multiplexer(term))
        return NULL;
    if (pictures == PICTURES_KITTY)
        return "tmux and screen show no pictures of kitty's (terminal:symbols works there)";
    return answers_ask(fd, term, limit) == PICTURES_SIXEL
               ? NULL
               : "this tmux or screen has no sixel (terminal:symbols works there)";
}

const char *pictures_need(int fd, enum pictures pictures, struct cell *cell)
{
    if (pictures == PICTURES_SYMBOLS)
        *cell = symbols_cell;
    if (pictures <= PICTURES_SYMBOLS)
        return NULL;
    return cell_is_known(fd, cell) ? multiplexer_needs(fd, pictures, &cell->limit)
                                   : "does not report its size in pixels";
}

static unsigned whole_cells(unsigned count, unsigned cell, unsigned most)
{
    return count * cell <= most ? count * cell : most > cell ? most / cell * cell : cell;
}

static unsigned within(unsigned most, unsigned limit)
{
    return limit && limit < most ? limit : most;
}

/* Most pixels of a strip for sixel or kitty's protocol. libchafa takes some 30 to 50 ns per pixel. */
#define STRIP_PIXELS (1u << 19)
/* Most pixels of a strip of symbols. libchafa takes 100 ns per pixel. */
#define SYMBOLS_PIXELS (1u << 18)

/* Returns the least common multiple of a and b. */
static unsigned common(unsigned a, unsigned b)
{
    unsigned multiple = a;

    while (multiple % b)
        multiple += a;
    return multiple;
}

struct strip pictures_strip(enum pictures pictures, const struct cell *cell, unsigned first, unsigned width,
                            unsigned height)
{
    unsigned unit = pictures == PICTURES_SIXEL ? common(cell->height, PICTURES_BAND) : cell->height;
    unsigned pixels = pictures == PICTURES_SYMBOLS ? SYMBOLS_PIXELS : STRIP_PIXELS;
    unsigned most = pixels / width / unit * unit, left = height - first;

    most = most ? most : unit;
    return (struct strip){first, left < most ? left : most};
}

uint16_t pictures_width(const struct cell *cell, unsigned columns, unsigned most)
{
    return (uint16_t)whole_cells(columns, cell->width, within(most, cell->limit.width));
}

uint16_t pictures_height(enum pictures pictures, const struct cell *cell, unsigned rows, unsigned most)
{
    unsigned used = pictures == PICTURES_SYMBOLS ? rows : rows > 1 ? rows - 1 : 1;
    unsigned height = whole_cells(used, cell->height, within(most, cell->limit.height));

    return (uint16_t)(pictures == PICTURES_SIXEL ? height - height % PICTURES_BAND : height);
}
