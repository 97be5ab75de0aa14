/* neon32.c - 32-bit ARM: its NEON has no doubles, its floating-point unit has. */
#include "one.h"
#include "pixels.h"
#include "walk_paths.h"

SURE(neon);
