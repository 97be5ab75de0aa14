/* lanes_avx512.c - the float loop with AVX-512. */
#include "simd/isa/avx512.h"

#define DRAW float_lanes_avx512
#include "float_lanes_loop.h"
