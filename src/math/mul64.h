/* mul64.h - products of 32 x 32 bits in 64 bits. */
#ifndef TIA_MATH_MUL64_H
#define TIA_MATH_MUL64_H

#include "noinline.h"
#include "target.h"

#include <stdint.h>

/* Hides from the compiler where a word comes from. Otherwise gcc for a 32-bit machine may widen a factor once for
 * several products, and then multiply 64 x 64 bits each time, or compute a word twice. */
#if defined(__GNUC__) && UINTPTR_MAX == UINT32_MAX
#define TIA_OPAQUE(x) __asm__("" : "+r"(x))
#else
#define TIA_OPAQUE(x) (void)(x)
#endif

#if TIA_HALF_PRODUCTS

/* The multiplier gives only the lower 32 bits.
 *
 * With a = a1 2^16 + a0 and b = b1 2^16 + b0 the product is a1 b1 2^32 + (a1 b0 + a0 b1) 2^16 + a0 b0: four products of
 * halves, each exact in 32 bits. Signed factors have signed upper halves, so the cross products are signed as well (at
 * least -2^31) and are shifted down with their sign. This takes 17 instructions. Compilers would call a function for 64
 * x 64 bits instead, of some 40 instructions.
 */

/* SHIFT extracts the upper half of a number: lsrs, or asrs for signed ones. */
#define TIA_MUL64_HALVES(a, b, low, high, SHIFT)                                                                       \
    do {                                                                                                               \
        uint32_t a0_, b1_, cross_;                                                                                     \
        low = b;                                                                                                       \
        high = a;                                                                                                      \
        __asm__(".syntax unified\n\t"                                                                                  \
                "uxth %[a0], %[high]\n\t" SHIFT " %[high], %[high], #16\n\t" SHIFT " %[b1], %[low], #16\n\t"           \
                "uxth %[low], %[low]\n\t"                                                                              \
                "movs %[cross], %[low]\n\t"                                                                            \
                "muls %[low], %[a0]\n\t"                                                                               \
                "muls %[cross], %[high]\n\t"                                                                           \
                "muls %[high], %[b1]\n\t"                                                                              \
                "muls %[b1], %[a0]\n\t"                                                                                \
                "lsls %[a0], %[cross], #16\n\t" SHIFT " %[cross], %[cross], #16\n\t"                                   \
                "adds %[low], %[a0]\n\t"                                                                               \
                "adcs %[high], %[cross]\n\t"                                                                           \
                "lsls %[a0], %[b1], #16\n\t" SHIFT " %[b1], %[b1], #16\n\t"                                            \
                "adds %[low], %[a0]\n\t"                                                                               \
                "adcs %[high], %[b1]"                                                                                  \
                : [low] "+l"(low), [high] "+l"(high), [a0] "=&l"(a0_), [b1] "=&l"(b1_), [cross] "=&l"(cross_)          \
                :                                                                                                      \
                : "cc");                                                                                               \
    } while (0)

SHARED uint64_t tia_mul_u32(uint32_t a, uint32_t b)
{
    uint32_t low, high;
    TIA_MUL64_HALVES(a, b, low, high, "lsrs");
    return (uint64_t)high << 32 | low;
}

SHARED int64_t tia_mul_s32(int32_t a, int32_t b)
{
    uint32_t low, high;
    TIA_MUL64_HALVES((uint32_t)a, (uint32_t)b, low, high, "asrs");
    return (int64_t)((uint64_t)high << 32 | low);
}

#else

static INLINED_IN_WORDS uint64_t tia_mul_u32(uint32_t a, uint32_t b)
{
    return (uint64_t)a * b;
}

static INLINED_IN_WORDS int64_t tia_mul_s32(int32_t a, int32_t b)
{
    TIA_OPAQUE(a);
    TIA_OPAQUE(b);
    return (int64_t)a * b;
}

#endif

/* Returns the product's upper word, rounded down. */
static INLINED_IN_WORDS int32_t tia_high_s32(int32_t a, int32_t b)
{
#if TIA_UPPER_PRODUCTS
    int32_t high;
    __asm__("smmul %0, %1, %2" : "=r"(high) : "r"(a), "r"(b));
    return high;
#else
    return (int32_t)(tia_mul_s32(a, b) >> 32);
#endif
}

/* Adds a b to a number of two words, of which `sum` is the upper one; `rest`, the lower one, may begin with any value.
 * Where the processor does not add products, `rest` is not used and the product is cut off. */
static INLINED_IN_WORDS void tia_add_high_s32(int32_t *sum, uint32_t *rest, int32_t a, int32_t b)
{
#if TIA_ADDS_PRODUCTS
    __asm__("smlal %0, %1, %2, %3" : "+r"(*rest), "+r"(*sum) : "r"(a), "r"(b));
#else
    (void)rest;
    *sum = (int32_t)((uint32_t)*sum + (uint32_t)tia_high_s32(a, b));
#endif
}

/* Returns the upper word of a b + c d, which is below 2^63; too small by less than 2. */
static INLINED_IN_WORDS int32_t tia_high_sum_s32(int32_t a, int32_t b, int32_t c, int32_t d)
{
#if TIA_ADDS_PRODUCTS
    int32_t low, high;
    __asm__("smull %0, %1, %2, %3\n\tsmlal %0, %1, %4, %5" : "=&r"(low), "=&r"(high) : "r"(a), "r"(b), "r"(c), "r"(d));
    return high;
#else
    return tia_high_s32(a, b) + tia_high_s32(c, d);
#endif
}
#endif
