/* lanes_avx512.c - see float_lanes_loop.h. */
#include "simd/isa/avx512.h"

#define DRAW float_lanes_avx512
#include "float_lanes_loop.h"
