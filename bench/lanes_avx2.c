/* lanes_avx2.c - see float_lanes_loop.h. */
#include "simd/isa/avx2.h"

#define DRAW float_lanes_avx2
#include "float_lanes_loop.h"
