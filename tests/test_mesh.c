/* mesh_cases.h in integers: the cases know no arithmetic, num.h gives them its numbers. */
#include "mesh_cases.h"
