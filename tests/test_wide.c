/* wide_cases.h with the compiler's 128-bit integers, if it has them. */
#include "wide_cases.h"
