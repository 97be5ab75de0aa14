/* ray_directions.c - directions that cover the sphere: the corners of an icosahedron with divided faces. */
#include "search.h"

#define CORNERS 12
#define EDGES 30
#define FACES 20
#define GOLDEN INT64_C(1737350766) /* (1 + sqrt 5) / 2 in units of 2^-30, to nearest */

static const uint8_t edges[EDGES][2] = {{0, 1},  {0, 4},  {0, 6}, {0, 8},  {0, 9},  {1, 4},  {1, 6},  {1, 10},
                                        {1, 11}, {2, 3},  {2, 5}, {2, 7},  {2, 8},  {2, 9},  {3, 5},  {3, 7},
                                        {3, 10}, {3, 11}, {4, 5}, {4, 8},  {4, 10}, {5, 8},  {5, 10}, {6, 7},
                                        {6, 9},  {6, 11}, {7, 9}, {7, 11}, {8, 9},  {10, 11}};
static const uint8_t faces[FACES][3] = {{0, 1, 4},   {0, 1, 6},  {0, 4, 8},   {0, 6, 9},  {0, 8, 9},
                                        {1, 4, 10},  {1, 6, 11}, {1, 10, 11}, {2, 3, 5},  {2, 3, 7},
                                        {2, 5, 8},   {2, 7, 9},  {2, 8, 9},   {3, 5, 10}, {3, 7, 11},
                                        {3, 10, 11}, {4, 5, 8},  {4, 5, 10},  {6, 7, 9},  {6, 7, 11}};

/* Adds a corner times its weight. Corner 4 a + i has 0 along axis a, +-1 along the next axis and +-golden ratio along
 * the third. */
static void add_corner(int64_t v[3], uint32_t corner, int64_t weight)
{
    uint32_t axis = corner / 4;

    v[(axis + 1) % 3] += corner & 1 ? -weight * TIA_Q30_ONE : weight * TIA_Q30_ONE;
    v[(axis + 2) % 3] += corner & 2 ? -weight * GOLDEN : weight * GOLDEN;
}

uint32_t tia_radio_directions(uint32_t density)
{
    return density - 1 < TIA_RADIO_DENSITY_MAX ? 10 * density * density + 2 : 0;
}

/* Directions are in this order: the corners; the inner points of the edges, edge by edge; those of the faces, face by
 * face and row by row. Weights are at most 2^11, and sums below 2^43. */
int tia_radio_direction(uint32_t density, uint32_t i, int64_t direction[3])
{
    int64_t v[3] = {0, 0, 0};
    uint32_t on_edge = density - 1, in_face = on_edge * (density - 2) / 2;

    if (!direction || i >= tia_radio_directions(density))
        return TIA_ERR_ARGUMENT;
    if (i < CORNERS) {
        add_corner(v, i, 1);
    } else if (i < CORNERS + EDGES * on_edge) {
        const uint8_t *ends = edges[(i - CORNERS) / on_edge];
        uint32_t at = (i - CORNERS) % on_edge + 1;
        add_corner(v, ends[0], density - at);
        add_corner(v, ends[1], at);
    } else {
        uint32_t k = i - CORNERS - EDGES * on_edge, row = 1, in_row = k % in_face;
        const uint8_t *corner = faces[k / in_face];
        for (uint32_t length = density - 2; in_row >= length; length--, row++)
            in_row -= length;
        add_corner(v, corner[0], row);
        add_corner(v, corner[1], in_row + 1);
        add_corner(v, corner[2], density - row - in_row - 1);
    }
    (void)wide_normalise(v, direction);
    return TIA_OK;
}
