/* place.h - where the display has put the picture in the controlling terminal's window, for its mouse: a picture may be
 * smaller than the window. */
#ifndef PORT_TERMINAL_PLACE_H
#define PORT_TERMINAL_PLACE_H

#include "pictures.h"

/* A picture of width x height pixels is in the window's upper left corner; or is this grid; or there is none, and the
 * window counts instead. */
void place_of_picture(const struct cell *cell, unsigned width, unsigned height);
void place_of_grid(const struct grid *grid, unsigned width, unsigned height);
void place_forget(void);

/* Where a cell's middle is, 2^-16 of the picture, 0..65535: at its edge if it is beyond. Columns and rows count from 1,
 * the window has so many. */
int32_t place_across(unsigned column, unsigned columns);
int32_t place_down(unsigned row, unsigned rows);

#endif
