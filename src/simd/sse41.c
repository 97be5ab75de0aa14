/* sse41.c - 4 floats: SSE4.1. */
#include "sse41.h"
#include "stream_x86.h"

#include "kernel.h"
#include "simd.h"

SIMD(sse41, NULL);
