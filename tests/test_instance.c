/* Placements in integers. */
#include "instance_cases.h"
