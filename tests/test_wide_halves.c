/* wide_cases.h with products made of halves, as on 32-bit machines. */
#define TIA_NO_INT128
#include "wide_cases.h"

_Static_assert(!TIA_INT128, "128-bit integers are used all the same");
