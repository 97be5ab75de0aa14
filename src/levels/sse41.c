/* sse41.c - 4 floats: SSE4.1. */
#include "sse41.h"

#include "kernel.h"
#include "level.h"

LEVEL(sse41, NULL);
