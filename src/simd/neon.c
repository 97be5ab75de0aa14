/* neon.c - 4 floats: NEON of AArch64. */
#include "neon64.h"

#include "kernel.h"
#include "simd.h"

SIMD(neon, NULL);
