/* divide.c - the division of 64 bits. A file of its own keeps compilers from computing both quotient and remainder, for
 * which 32-bit machines link a second long function. */
#include "divide.h"

uint64_t tia_quotient(uint64_t a, uint64_t b)
{
    return a / b;
}
