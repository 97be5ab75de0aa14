/* integer.c - src/math/integer.h for Frama-C: in standard C99, without static assertions. */
#undef __GNUC__
#undef __SIZEOF_INT128__
#define _Static_assert(condition, message) struct tia_asserted
#include "math/integer.h"
