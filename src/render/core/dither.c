#include "dither.h"

/* Returns the entry of Bayer's matrix M(8), where M(2n) = [4 M(n), 4 M(n) + 2; 4 M(n) + 3, 4 M(n) + 1]: bit i of x and
 * bit i of y determine two bits of the entry; bits 0 determine its highest two. */
static unsigned bayer(unsigned x, unsigned y)
{
    unsigned entry = 0;

    for (unsigned bit = 0; bit < 3; bit++) {
        unsigned right = x >> bit & 1, low = y >> bit & 1;
        entry = entry << 2 | ((right ^ low) << 1 | low);
    }
    return entry;
}

void dither_thresholds(bool dither, int y, num_u threshold[8])
{
    for (unsigned x = 0; x < 8; x++)
        threshold[x] = dither ? num_threshold(bayer(x, (unsigned)y & 7)) : NUM_ROUND;
}
