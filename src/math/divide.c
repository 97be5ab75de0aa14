/* divide.c - the division of 64 bits. It stands alone so that compilers do not make a remainder, for which 32-bit
 * machines link a second long function, of a quotient and a product. */
#include "divide.h"

uint64_t tia_quotient(uint64_t a, uint64_t b)
{
    return a / b;
}
