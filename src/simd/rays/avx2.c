/* avx2.c - rays with AVX2 and FMA: vectors of 4 doubles. */
#include "simd/isa/avx2.h"

#include "lanes.h"

#include "pixels_tmpl.h"
#include "seen_tmpl.h"
#include "walk_paths_tmpl.h"

SURE(avx2);
