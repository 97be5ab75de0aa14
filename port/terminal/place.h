/* place.h - where the display has put the picture in the controlling terminal's window, for its mouse: a picture may be
 * smaller than the window. */
#ifndef PORT_TERMINAL_PLACE_H
#define PORT_TERMINAL_PLACE_H

#include <stdint.h>

#define PLACE_CELL 256 /* parts of a cell's width and height that the size is told in */

struct place {
    unsigned left, top;     /* cells, from 0 */
    uint32_t width, height; /* 1/PLACE_CELL cells; 0: the whole window */
};

void place_set(const struct place *place);

/* Where a cell's middle is, 2^-16 of the picture, 0..65535: at its edge if it is beyond. Columns and rows count from 1,
 * the window has so many. */
int32_t place_across(unsigned column, unsigned columns);
int32_t place_down(unsigned row, unsigned rows);

#endif
