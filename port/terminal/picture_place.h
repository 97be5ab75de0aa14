/* picture_place.h - the picture's position in the controlling terminal's window, for the mouse: a picture may be
 * smaller than the window. */
#ifndef PORT_TERMINAL_PICTURE_PLACE_H
#define PORT_TERMINAL_PICTURE_PLACE_H

#include "pictures.h"

/* Set the position: a picture of width x height pixels in the window's upper left corner; or this grid; or no picture,
 * so that the window counts instead. */
void place_of_picture(const struct cell *cell, unsigned width, unsigned height);
void place_of_grid(const struct grid *grid, unsigned width, unsigned height);
void place_forget(void);

/* Return the position of a cell's middle, 2^-16 of the picture, 0..65535: at its edge if it is beyond. Columns and rows
 * count from 1; `columns` and `rows` are those of the window. */
int32_t place_across(unsigned column, unsigned columns);
int32_t place_down(unsigned row, unsigned rows);

#endif
