/* shape_runs.h in integers: the cases are independent of the arithmetic, which num.h provides. */
#include "shape_runs.h"
