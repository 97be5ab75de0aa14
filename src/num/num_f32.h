/* num_f32.h - single precision, the usual choice, for comparing its speed and error with those of fixed point. */
#ifndef TIA_NUM_NUM_F32_H
#define TIA_NUM_NUM_F32_H

typedef float num_real;
typedef double num_double;

#define NUM_NAME "f32"
#define NUM_PREFIX tia_f32_
#define NUM_CORE tia_core_f32
#define NUM_ESTIMATOR tia_estimator_f32
#define NUM_TWO_PI 6.283185307179586476925286766559F
#define num_root(x) __builtin_sqrtf(x)
#define num_angle(y, x) __builtin_atan2f(y, x)

#include "num_real.h"

#endif
