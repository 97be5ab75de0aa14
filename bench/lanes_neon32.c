/* lanes_neon32.c - the float loop with NEON on 32-bit Arm. */
#include "simd/isa/neon32.h"

#define DRAW float_lanes_neon
#include "float_lanes_loop.h"
