/* avx2.c - 8 floats: AVX2 and FMA. */
#include "avx2.h"

#include "kernel.h"
#include "level.h"

LEVEL(avx2);
