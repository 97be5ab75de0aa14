/* mul64.h - products of 32 x 32 bits in 64 bits. For a processor whose multiplier gives only 32 bits, TIA_MUL64 can be
 * defined as the name of a replacement of this file. */
#ifndef TIA_MATH_MUL64_H
#define TIA_MATH_MUL64_H

#include <stdint.h>

/* Hides from the compiler that a factor was widened from 32 bits elsewhere. Otherwise gcc for a 32-bit machine may
 * widen a factor once for several products, and then multiply 64 x 64 bits each time. */
#if defined(__GNUC__) && UINTPTR_MAX == UINT32_MAX
#define TIA_OPAQUE(x) __asm__("" : "+r"(x))
#else
#define TIA_OPAQUE(x) (void)(x)
#endif

static inline uint64_t tia_mul_u32(uint32_t a, uint32_t b)
{
    return (uint64_t)a * b;
}

static inline int64_t tia_mul_s32(int32_t a, int32_t b)
{
    TIA_OPAQUE(a);
    TIA_OPAQUE(b);
    return (int64_t)a * b;
}

#endif
