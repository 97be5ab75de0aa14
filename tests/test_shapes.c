/* shape_runs.h in integers: the cases know no arithmetic, num.h gives them its numbers. */
#include "shape_runs.h"
