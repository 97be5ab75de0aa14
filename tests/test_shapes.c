/* shape_runs.h in fixed point: the cases are independent of the arithmetic, which num.h provides. */
#include "shape_runs.h"
