#include "level.h"

const struct tia_raster_runs *tia_level_raster(const struct tia_level *level)
{
    return level ? level->raster : NULL;
}
