/* triangle_cases.h in fixed point: the cases are independent of the arithmetic, which num.h provides. */
#include "triangle_cases.h"
