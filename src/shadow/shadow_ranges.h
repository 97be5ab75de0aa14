/* shadow_ranges.h - the bounds of the filter in occluder.h and of the cells in technique_map_exact.c. `make prove`
 * inserts these numbers into tests/proofs/shadow_*.g, which prove that they suffice. */
#ifndef TIA_SHADOW_SHADOW_RANGES_H
#define TIA_SHADOW_SHADOW_RANGES_H

/* Error bound of M.D - m s due to products and shifts, where M.D and m s are below 2^62. */
#define OCCLUDER_UNSURE 15
/* Further error bound of M.D, due to the rounding of its three coefficients, for columns and rows below 2^13. */
#define OCCLUDER_CUT 16383

/* Error bound of a visible point's position: SEEN_OFF, in units that are 2^-SEEN_BITS of a vertex's unit. Positions
 * with more than SEEN_FAR bits are not computed. */
#define SEEN_BITS 8
#define SEEN_OFF 5
#define SEEN_FAR 52

/* Views of the alias-free map have 2^28 units to each side of their middle, and 2^CELL_BITS cells in each direction.
 * The cell of a position is uncertain if all its coordinates relative to a point light are below 2^CELL_NEAR. Projected
 * along a light's direction, corners are below 2^ACROSS_BITS and accurate to ACROSS_OFF; if twice the area of three
 * corners is at least 2^ACROSS_THIN, their orientation is certain. */
#define CELL_BITS 13
#define CELL_NEAR 17
#define ACROSS_BITS 27
#define ACROSS_OFF 2
#define ACROSS_THIN 33

#endif
