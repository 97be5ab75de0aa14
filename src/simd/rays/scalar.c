/* scalar.c - rays in plain C, one at a time. */
#include "simd/isa/one.h"

#include "lanes.h"

#include "seen_tmpl.h"

#include "pixels_tmpl.h"
#include "walk_paths_tmpl.h"

SURE(scalar);
