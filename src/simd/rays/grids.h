/* grids.h - the empty cubes of a grid's cells, see struct sure_grid. */
#ifndef TIA_SIMD_RAYS_GRIDS_H
#define TIA_SIMD_RAYS_GRIDS_H

#include <stddef.h>

#include <tia/scene.h>

/* Most cells of grids with cubes, which are set for each frame, and the longest edge of a cube. */
#define SURE_GRID_CELLS (UINT32_C(1) << 18)
#define SURE_GRID_FAR 64

/* Sets the cubes of a grid that has them: those of octant 0, whose axes all point up, then of octants 1 .. 7; bit i of
 * an octant's number is set if axis i points down. */
void tia_sure_set_empty(uint8_t *to, const struct tia_grid *grid);

/* Returns the number of cells of a grid if it has cubes, else 0. */
static inline uint32_t sure_grid_cells(const struct tia_grid *g)
{
    uint64_t cells = (uint64_t)g->size[0] * g->size[1] * g->size[2];

    return cells <= SURE_GRID_CELLS ? (uint32_t)cells : 0;
}

#endif
