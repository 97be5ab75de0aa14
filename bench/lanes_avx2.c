/* lanes_avx2.c - the float loop with AVX2. */
#include "simd/isa/avx2.h"

#define DRAW float_lanes_avx2
#include "float_lanes_loop.h"
