/* rvv.c - rays with V of RISC-V: 4 doubles. */
#include "simd/isa/rvv.h"

#include "lanes.h"

#include "pixels_tmpl.h"
#include "seen_tmpl.h"
#include "walk_paths_tmpl.h"

SURE(rvv);
