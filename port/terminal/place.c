#include "place.h"

/* A process has one controlling terminal. */
static struct place now;

void place_set(const struct place *place)
{
    now = *place;
}

static int32_t part_of(unsigned at, unsigned from, uint32_t size)
{
    int64_t middle = ((int64_t)at - 1 - from) * PLACE_CELL + PLACE_CELL / 2,
            part = size ? middle * 65536 / size : 65535;

    return (int32_t)(part < 0 ? 0 : part > 65535 ? 65535 : part);
}

int32_t place_across(unsigned column, unsigned columns)
{
    return now.width ? part_of(column, now.left, now.width) : part_of(column, 0, columns * PLACE_CELL);
}

int32_t place_down(unsigned row, unsigned rows)
{
    return now.height ? part_of(row, now.top, now.height) : part_of(row, 0, rows * PLACE_CELL);
}
