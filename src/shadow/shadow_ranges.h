/* shadow_ranges.h - the bounds of the filter in occluder.h and of the cells in technique_map_exact.c. `make prove` puts
 * these numbers into tests/proofs/shadow_*.g, which show that they suffice. */
#ifndef TIA_SHADOW_SHADOW_RANGES_H
#define TIA_SHADOW_SHADOW_RANGES_H

/* Error bounds of the difference between M.D and m s, both below 2^62: of the products and shifts; and the further
 * error of M.D where its three numbers are cut, at columns and rows below 2^13. */
#define OCCLUDER_UNSURE 15
#define OCCLUDER_CUT 16383

/* Accuracy of a visible point: within SEEN_OFF, in units of 2^-SEEN_BITS of a vertex's; positions of more than SEEN_FAR
 * bits are not computed. */
#define SEEN_BITS 8
#define SEEN_OFF 5
#define SEEN_FAR 52

/* Views of the alias-free map have 2^28 units to each side of their middle, and 2^CELL_BITS cells. A position relative
 * to a point light with fewer than CELL_NEAR bits is in no certain cell. Across a direction the positions of corners
 * are below 2^ACROSS_BITS and within ACROSS_OFF; if twice their area is at least 2^ACROSS_THIN, their order is certain.
 */
#define CELL_BITS 13
#define CELL_NEAR 17
#define ACROSS_BITS 27
#define ACROSS_OFF 2
#define ACROSS_THIN 33

#endif
