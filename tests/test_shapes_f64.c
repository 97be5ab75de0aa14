/* Shapes as rays meet them, in double precision. */
#define TIA_NUM_F64
#include "shape_runs.h"
