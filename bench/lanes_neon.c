/* lanes_neon.c - see float_lanes_loop.h. */
#include "levels/neon64.h"

#define DRAW float_lanes_neon
#include "float_lanes_loop.h"
