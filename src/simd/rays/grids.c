/* grids.c - the distance of each cell of a grid to the nearest cell that is not empty, as the largest of the distances
 * along the three axes: a ray may pass over as many cells. */
#include "grids.h"

/* Rows of cells along x in the order of a sweep: forward, or `back` from the last row to the first. */
struct sweep {
    uint8_t *row;
    int count, x; /* x: 1 or -1 */
    const uint8_t *before[4];
    int rows;
};

static uint8_t least(uint8_t a, uint8_t b)
{
    return a < b ? a : b;
}

/* Lowers the distances of a row's cells to one more than those of their neighbours in the rows before, and of the cell
 * before in the row itself. */
static void sweep_row(const struct sweep *s, uint8_t *near)
{
    for (int x = 0; x < s->count; x++) {
        near[x + 1] = SURE_GRID_FAR;
        for (int i = 0; i < s->rows; i++)
            near[x + 1] = least(near[x + 1], s->before[i][x]);
    }
    near[0] = near[s->count + 1] = SURE_GRID_FAR;
    for (int i = 0, x = s->x > 0 ? 0 : s->count - 1; i < s->count; i++, x += s->x) {
        uint8_t nearest = least(least(near[x], near[x + 1]), near[x + 2]);
        if (i > 0)
            nearest = least(nearest, s->row[x - s->x]);
        s->row[x] = least(s->row[x], (uint8_t)(nearest + 1));
    }
}

/* Two sweeps give exact distances, as each cell at the distance n has a neighbour at n - 1 that is nearer along all
 * axes along which the cell is n away. */
void tia_sure_set_empty(uint8_t *to, const struct tia_grid *grid)
{
    const int across = grid->size[0], high = grid->size[1], deep = grid->size[2];
    const size_t layer = (size_t)across * (size_t)high;
    uint8_t near[TIA_GRID_MAX + 2];

    for (size_t i = 0; i < layer * (size_t)deep; i++)
        to[i] = grid->cells[i] ? 0 : SURE_GRID_FAR;
    for (int back = 0; back < 2; back++)
        for (int k = 0; k < high * deep; k++) {
            int row = back ? high * deep - 1 - k : k, y = row % high, z = row / high, step = back ? 1 : -1;
            struct sweep s = {.row = to + (size_t)row * (size_t)across, .count = across, .x = -step};
            if (y + step >= 0 && y + step < high)
                s.before[s.rows++] = s.row + step * across;
            for (int i = -1; i <= 1 && z + step >= 0 && z + step < deep; i++)
                if (y + i >= 0 && y + i < high)
                    s.before[s.rows++] = s.row + (step * high + i) * across;
            sweep_row(&s, near);
        }
}
