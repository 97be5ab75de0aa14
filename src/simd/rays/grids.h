/* grids.h - the distances of a grid's cells to what is not empty, see struct sure_grid. */
#ifndef TIA_SIMD_RAYS_GRIDS_H
#define TIA_SIMD_RAYS_GRIDS_H

#include <tia/scene.h>

/* Most cells of grids with distances, which are set for each frame, and the largest distance. */
#define SURE_GRID_CELLS (UINT32_C(1) << 20)
#define SURE_GRID_FAR 64

/* Sets the distances of a grid's cells. */
void tia_sure_set_empty(uint8_t *to, const struct tia_grid *grid);

/* Returns the number of cells of a grid if it has distances, else 0. */
static inline uint32_t sure_grid_cells(const struct tia_grid *g)
{
    uint64_t cells = (uint64_t)g->size[0] * g->size[1] * g->size[2];

    return cells <= SURE_GRID_CELLS ? (uint32_t)cells : 0;
}

#endif
