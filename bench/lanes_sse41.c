/* lanes_sse41.c - see float_lanes_loop.h. */
#include "simd/isa/sse41.h"

#define DRAW float_lanes_sse41
#include "float_lanes_loop.h"
