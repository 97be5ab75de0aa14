/* lanes_rvv.c - the float loop with V of RISC-V. */
#include "simd/isa/rvv.h"

#define DRAW float_lanes_rvv
#include "float_lanes_loop.h"
