/* avx512.c - rays with AVX-512 F, BW, DQ and VL: vectors of 8 doubles. */
#include "simd/isa/avx512.h"

#include "lanes.h"

#include "pixels_tmpl.h"
#include "seen_tmpl.h"
#include "walk_paths_tmpl.h"

SURE(avx512);
