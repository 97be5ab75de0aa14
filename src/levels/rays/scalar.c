/* scalar.c - plain C. */
#include "one.h"

SURE(scalar);
