/* num_watched.h - num_q16.h for the build whose rays can be observed, see struct tia_observer. */
#ifndef TIA_NUM_NUM_WATCHED_H
#define TIA_NUM_NUM_WATCHED_H

#define NUM_NAME "q16"
#define NUM_PREFIX tia_watched_
#define NUM_CORE tia_core_watched
#define NUM_ESTIMATOR tia_estimator_watched
#define NUM_CHECK(condition) ((void)0)

#include "num_q16.h"

#endif
