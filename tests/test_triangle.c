/* triangle_cases.h in integers: the cases know no arithmetic, num.h gives them its numbers. */
#include "triangle_cases.h"
