/* Placements in integers. */
#include "placement_cases.h"
