/* lanes_neon32.c - see float_lanes_loop.h. */
#include "simd/isa/neon32.h"

#define DRAW float_lanes_neon
#include "float_lanes_loop.h"
