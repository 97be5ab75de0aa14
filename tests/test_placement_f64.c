/* Placements in double precision. */
#ifdef TIA_HAVE_F64
#define TIA_NUM_F64
#include "placement_cases.h"
#else
int main(void)
{
    return 0;
}
#endif
