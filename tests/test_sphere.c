/* Spheres in integers. */
#include "sphere_cases.h"
