/* lanes_neon.c - see float_lanes_loop.h. */
#include "simd/isa/neon.h"

#define DRAW float_lanes_neon
#include "float_lanes_loop.h"
