/* instance_cases.h in integers: the cases are independent of the arithmetic, which num.h provides. */
#include "instance_cases.h"
