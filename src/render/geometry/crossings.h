/* crossings.h - all points in which a ray's line crosses a closed shape. */
#ifndef TIA_RENDER_GEOMETRY_CROSSINGS_H
#define TIA_RENDER_GEOMETRY_CROSSINGS_H

#include "shape.h"

#define TORUS_CROSSINGS 4
#define ROUNDED_CROSSINGS 2

/* The part of a ray's line that is of interest: the first `most` crossings at `from` or later; none is needed if all
 * of the shape is beyond `limit`. */
struct line_part {
    num_length from, limit;
    unsigned most;
};

/* Both give the distances t at which a line enters and leaves the shape by turns, in ascending order, and return their
 * number. If the line is inside the shape at `from`, the first crossing is an exit. For all crossings of the line,
 * `from` is -NUM_LENGTH_MAX, where a line is always outside. */
unsigned torus_crossings(const struct prepared_torus *torus, const struct ray *ray, const struct line_part *part,
                         num_length t[TORUS_CROSSINGS]);
unsigned rounded_crossings(const struct prepared_rounded *box, const struct ray *ray, const struct line_part *part,
                           num_length t[ROUNDED_CROSSINGS]);

/* Gives the first chord between two of `count` crossings of a whole line that ends beyond `after`; false: none. */
bool crossings_chord(const num_length *t, unsigned count, num_length after, struct chord *chord);

#endif
