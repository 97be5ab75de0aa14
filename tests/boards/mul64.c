/* mul64.c - for a processor whose products are made from halves (src/math/mul64.h): tests both functions against the
 * compiler's product, for all pairs of numbers whose halves are edge cases, and for random ones. */
#include "boards/board.h"

#include "math/integer.h"

_Static_assert(TIA_HALF_PRODUCTS, "the functions are the compiler's own");

static uint32_t wrong, tried;

static void try_pair(uint32_t a, uint32_t b)
{
    volatile uint64_t wide = b; /* hides from the compiler that the upper half is zero */
    uint64_t product = a * wide;
    /* -2^32 where a factor is negative: a = ua - 2^32 if its top bit is set */
    uint64_t minus_b = (a >> 31) ? (uint64_t)b << 32 : 0, minus_a = (b >> 31) ? (uint64_t)a << 32 : 0;
    tried++;
    wrong += tia_mul_u32(a, b) != product;
    wrong += (uint64_t)tia_mul_s32((int32_t)a, (int32_t)b) != product - minus_b - minus_a;
}

static uint32_t edge(unsigned i)
{
    static const uint16_t halves[] = {0,      1,      2,      3,      0x00ff, 0x0100, 0x5555,
                                      0x7ffe, 0x7fff, 0x8000, 0x8001, 0xaaaa, 0xfffe, 0xffff};
    enum { HALVES = sizeof halves / sizeof *halves };
    return (uint32_t)halves[i / HALVES % HALVES] << 16 | halves[i % HALVES];
}

int main(void)
{
    uint32_t random = 1;
    for (unsigned i = 0; i < 14 * 14; i++)
        for (unsigned j = 0; j < 14 * 14; j++)
            try_pair(edge(i), edge(j));
    for (unsigned i = 0; i < 200000; i++) {
        uint32_t a = random = random * 1664525u + 1013904223u;
        uint32_t b = random = random * 1664525u + 1013904223u;
        try_pair(a ^ a >> 15, b ^ b >> 13);
    }
    board_print("pairs ");
    board_print_number(tried);
    board_print(" wrong ");
    board_print_number(wrong);
    board_print("\n");
    return wrong != 0;
}
