/* grids.c - the empty cubes of a grid's cells: for each cell and each octant of directions, the number of cells along
 * an edge of the largest cube that has this cell in one corner, extends into the octant and has only empty cells. */
#include "grids.h"

/* Returns the least number of the seven neighbours of a cell in an octant; `step` and `ahead` tell, for each axis, the
 * distance in memory to the next cell, and whether there is one. Beyond the grid all is empty. */
static uint8_t least_beside(const uint8_t *cell, const ptrdiff_t step[3], const bool ahead[3])
{
    uint8_t least = SURE_GRID_FAR;

    for (int way = 1; way < 8; way++) {
        ptrdiff_t at = 0;
        bool in = true;
        for (int i = 0; i < 3; i++) {
            at += way >> i & 1 ? step[i] : 0;
            in = in && (ahead[i] || !(way >> i & 1));
        }
        if (in && cell[at] < least)
            least = cell[at];
    }
    return least;
}

/* Sets the cubes of an octant, the cells that are farthest along it first. */
static void set_octant(uint8_t *to, const struct tia_grid *grid, unsigned octant)
{
    const int size[3] = {grid->size[0], grid->size[1], grid->size[2]};
    const ptrdiff_t stride[3] = {1, size[0], (ptrdiff_t)size[0] * size[1]}, cells = stride[2] * size[2];
    ptrdiff_t step[3];
    bool ahead[3];

    for (int i = 0; i < 3; i++)
        step[i] = octant >> i & 1 ? -stride[i] : stride[i];
    for (ptrdiff_t k = 0; k < cells; k++) {
        ptrdiff_t at = 0;
        for (int i = 0; i < 3; i++) {
            ptrdiff_t n = k / stride[i] % size[i]; /* cells from here to the end, along the octant */
            ahead[i] = n > 0;
            at += (octant >> i & 1 ? n : size[i] - 1 - n) * stride[i];
        }
        uint8_t least = least_beside(to + at, step, ahead);
        to[at] = grid->cells[at] ? 0 : (uint8_t)(least < SURE_GRID_FAR ? least + 1 : SURE_GRID_FAR);
    }
}

void tia_sure_set_empty(uint8_t *to, const struct tia_grid *grid)
{
    for (unsigned octant = 0; octant < 8; octant++)
        set_octant(to + (size_t)octant * sure_grid_cells(grid), grid, octant);
}
