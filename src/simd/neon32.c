/* neon32.c - 4 floats: NEON of ARMv7. */
#include "neon32.h"

#include "kernel.h"
#include "simd.h"

SIMD(neon, NULL);
