/* neon32.c - rays on 32-bit ARM, one at a time: its NEON has no doubles, its floating-point unit has. */
#include "simd/isa/neon32.h"

#include "lanes.h"

#include "seen_tmpl.h"

#include "pixels_tmpl.h"
#include "walk_paths_tmpl.h"

SURE(neon);
