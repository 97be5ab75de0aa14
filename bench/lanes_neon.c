/* lanes_neon.c - the float loop with NEON on AArch64. */
#include "simd/isa/neon.h"

#define DRAW float_lanes_neon
#include "float_lanes_loop.h"
