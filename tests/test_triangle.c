/* triangle_cases.h in integers: the cases are independent of the arithmetic, which num.h provides. */
#include "triangle_cases.h"
