/* Triangles in integers. */
#include "triangle_cases.h"
