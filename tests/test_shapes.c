/* Shapes as rays meet them, in integers. */
#include "shape_runs.h"
