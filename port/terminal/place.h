/* place.h - the picture's position in the controlling terminal's window, for its mouse: a picture may be smaller than
 * the window. */
#ifndef PORT_TERMINAL_PLACE_H
#define PORT_TERMINAL_PLACE_H

#include "pictures.h"

/* Places a picture of width x height pixels in the window's upper left corner. */
void place_of_picture(const struct cell *cell, unsigned width, unsigned height);
/* Places it as this grid. */
void place_of_grid(const struct grid *grid, unsigned width, unsigned height);
/* Removes the picture: the whole window counts instead. */
void place_forget(void);

/* Returns the position of a column's middle in 2^-16 of the picture's width, clamped to 0..65535. Columns count from 1,
 * the window has `columns`. */
int32_t place_across(unsigned column, unsigned columns);
/* Returns the same of a row and the picture's height. */
int32_t place_down(unsigned row, unsigned rows);

#endif
