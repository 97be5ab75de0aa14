#include "integer.h"

int tia_cmp_products(uint64_t a, uint64_t b, uint64_t c, uint64_t d)
{
    struct tia_wide p = tia_wide_product(a, b), q = tia_wide_product(c, d);
    if (p.high != q.high)
        return p.high < q.high ? -1 : 1;
    /* (p.low > q.low) - (p.low < q.low) would be enough, but gcc 12 for aarch64 miscompiles it to a signed comparison
     * at -O3 */
    if (p.low != q.low)
        return p.low < q.low ? -1 : 1;
    return 0;
}
