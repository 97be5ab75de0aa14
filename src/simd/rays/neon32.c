/* neon32.c - rays with 32-bit ARM: its NEON has no doubles, its floating-point unit has. */
#include "simd/isa/neon32.h"

#include "lanes.h"

#include "tracer_tmpl.h"

#include "pixels_tmpl.h"
#include "walk_paths_tmpl.h"

SURE(neon);
