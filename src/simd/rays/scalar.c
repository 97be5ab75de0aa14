/* scalar.c - plain C. */
#include "one.h"
#include "pixels.h"
#include "walk_paths.h"

SURE(scalar);
