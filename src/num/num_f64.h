/* num_f64.h - double precision: the reference for the error of fixed point. */
#ifndef TIA_NUM_NUM_F64_H
#define TIA_NUM_NUM_F64_H

typedef double num_real;
typedef double num_double;

#define NUM_NAME "f64"
#define NUM_PREFIX tia_f64_
#define NUM_CORE tia_core_f64
#define NUM_ESTIMATOR tia_estimator_f64
#define NUM_TWO_PI 6.283185307179586476925286766559
#define num_root(x) __builtin_sqrt(x)
#define num_angle(y, x) __builtin_atan2(y, x)

#include "num_real.h"

#endif
