#include "picture_place.h"

#define CELL 256 /* Parts per cell, since a picture may end inside a cell. */

/* Position of the picture; a process has one controlling terminal. */
static struct {
    unsigned left, top;     /* cells, from 0 */
    uint32_t width, height; /* in units of 1/CELL cell; 0: there is no picture */
} place;

void place_of_picture(const struct cell *cell, unsigned width, unsigned height)
{
    place.left = place.top = 0;
    place.width = width * CELL / cell->width;
    place.height = height * CELL / cell->height;
}

void place_of_grid(const struct grid *grid, unsigned width, unsigned height)
{
    place.left = grid->left;
    place.top = grid->top;
    place.width = width * CELL * (grid->spaces ? 2 : 1);
    place.height = height * CELL / (grid->spaces ? 1 : 2);
}

void place_forget(void)
{
    place.width = place.height = 0;
}

static int32_t part_of(unsigned at, unsigned from, uint32_t size)
{
    int64_t middle = ((int64_t)at - 1 - from) * CELL + CELL / 2, part = size ? middle * 65536 / size : 65535;

    return (int32_t)(part < 0 ? 0 : part > 65535 ? 65535 : part);
}

int32_t place_across(unsigned column, unsigned columns)
{
    return place.width ? part_of(column, place.left, place.width) : part_of(column, 0, columns * CELL);
}

int32_t place_down(unsigned row, unsigned rows)
{
    return place.height ? part_of(row, place.top, place.height) : part_of(row, 0, rows * CELL);
}
