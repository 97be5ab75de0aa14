/* divide.c - 64-bit division, in a file of its own. Otherwise compilers may compute quotient and remainder together,
 * for which 32-bit machines link a second long function. */
#include "divide.h"

uint64_t tia_quotient(uint64_t a, uint64_t b)
{
    return a / b;
}
