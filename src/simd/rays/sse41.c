/* sse41.c - rays with SSE4.1: 2 doubles. */
#include "simd/isa/sse41.h"

#include "lanes.h"

#include "pixels_tmpl.h"
#include "seen_tmpl.h"
#include "walk_paths_tmpl.h"

SURE(sse41);
