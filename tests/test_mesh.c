/* mesh_cases.h in integers: the cases are independent of the arithmetic, which num.h provides. */
#include "mesh_cases.h"
