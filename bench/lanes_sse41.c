/* lanes_sse41.c - the float loop with SSE4.1. */
#include "simd/isa/sse41.h"

#define DRAW float_lanes_sse41
#include "float_lanes_loop.h"
