/* Meshes in integers. */
#include "mesh_cases.h"
