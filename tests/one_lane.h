/* one_lane.h - the templates of src/simd/rays with one lane, for tests of their steps. */
#ifndef TESTS_ONE_LANE_H
#define TESTS_ONE_LANE_H

#include "simd/isa/one.h"

#include "simd/rays/lanes.h"

#include "simd/rays/tracer_tmpl.h"

#endif
