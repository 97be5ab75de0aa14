/* neon.c - rays with NEON of AArch64: 2 doubles. */
#include "simd/isa/neon.h"

#include "lanes.h"

#include "pixels_tmpl.h"
#include "seen_tmpl.h"
#include "walk_paths_tmpl.h"

SURE(neon);
