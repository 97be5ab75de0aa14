/* pictures.h - pictures in a terminal, as symbols or by sixel or kitty's protocol, in builds that have libchafa. */
#ifndef PORT_TERMINAL_PICTURES_H
#define PORT_TERMINAL_PICTURES_H

#include <tia/port.h>

#include "answers.h"
#include "encode.h"

#define PICTURES_BAND 6 /* pixel rows of a sixel band; heights of sixel pictures are multiples of it */

/* The size of a character in pixels, and of the largest picture. */
struct cell {
    unsigned width, height;
    struct limit limit;
};

/* Queries the terminal for the pictures that it can show, and sets the size of its cells. A terminal that does not
 * report that size gets no query: a picture's size would be unknown. */
enum pictures pictures_find(int fd, struct cell *cell);

/* Sets the size of the cells for pictures that the user chose; returns NULL, or the reason why the terminal cannot show
 * them. */
const char *pictures_need(int fd, enum pictures pictures, struct cell *cell);

/* Returns the width of a picture, in pixels, in a window of `columns` columns: whole cells, `most` pixels at most and
 * no more than the terminal shows, but at least one cell. */
uint16_t pictures_width(const struct cell *cell, unsigned columns, unsigned most);
/* Returns the height of a picture, in pixels, in a window of `rows` rows: whole cells as for the width, and then whole
 * bands for sixel. Only symbols use the last row, since some terminals scroll after a picture in it. */
uint16_t pictures_height(enum pictures pictures, const struct cell *cell, unsigned rows, unsigned most);

/* Returns the strip that begins at row `first` of a picture of width x height pixels. Strips consist of whole cells
 * and, for sixel, whole bands, except the last strip. Encoding one takes some 30 ms at most. */
struct strip pictures_strip(enum pictures pictures, const struct cell *cell, unsigned first, unsigned width,
                            unsigned height);

/* Adds the text that shows a strip of a picture by sixel or kitty's protocol, the picture being in the window's upper
 * left corner. symbols.h draws symbols. The picture's rows have `width` pixels. They are not scaled if the strip covers
 * whole cells or, for sixel, as many bands as fit into the cells that it touches. A frame's strips come from the top
 * down. Sets text->failed when memory is short. */
void pictures_draw(enum pictures pictures, const tia_rgb565 *pixels, unsigned width, struct strip strip,
                   const struct cell *cell, struct text *text);

/* Adds the text that shows a picture of width x height pixels at the cursor, and the end of a line, in the same way. */
void pictures_print(enum pictures pictures, const tia_rgb565 *pixels, unsigned width, unsigned height,
                    const struct cell *cell, struct text *text);

#endif
