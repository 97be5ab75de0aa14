/* instance_cases.h in double precision: num.h provides another arithmetic for the same cases. */
#ifdef TIA_HAVE_F64
#define TIA_NUM_F64
#include "instance_cases.h"
#else
#include "without_f64.h"
#endif
