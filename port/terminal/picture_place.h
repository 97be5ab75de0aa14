/* picture_place.h - the picture's position in the controlling terminal's window, for the mouse: a picture may be
 * smaller than the window. */
#ifndef PORT_TERMINAL_PICTURE_PLACE_H
#define PORT_TERMINAL_PICTURE_PLACE_H

#include "pictures.h"

/* Sets the position of a picture of width x height pixels in the window's upper left corner. */
void place_of_picture(const struct cell *cell, unsigned width, unsigned height);
/* Sets the position of a picture of width x height pixels in a grid. */
void place_of_grid(const struct grid *grid, unsigned width, unsigned height);
/* Removes the picture: positions are then relative to the whole window. */
void place_forget(void);

/* Returns the horizontal position of a cell's middle in the picture, in 2^-16 of its width, 0..65535; for a cell beside
 * the picture, the position of the nearer edge. `column` counts from 1; the window has `columns`. */
int32_t place_across(unsigned column, unsigned columns);
/* Returns the vertical position in the same way, in 2^-16 of the picture's height. */
int32_t place_down(unsigned row, unsigned rows);

#endif
