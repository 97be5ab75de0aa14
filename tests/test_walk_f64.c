/* walk_cases.h in double precision: num.h gives the same cases other numbers. */
#ifdef TIA_HAVE_F64
#define TIA_NUM_F64
#include "walk_cases.h"
#else
#include "without_f64.h"
#endif
