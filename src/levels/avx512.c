/* avx512.c - 16 floats: AVX-512 F, BW, DQ and VL. */
#include "avx512.h"

#include "kernel.h"
#include "level.h"

LEVEL(avx512);
