/* mul64.h - products of 32 x 32 bits in 64. A processor whose multiplier gives 32 bits may have a
 * file of the same content in its own folder: TIA_MUL64 names it. */
#ifndef TIA_SRC_MUL64_H
#define TIA_SRC_MUL64_H

#include <stdint.h>

/* A compiler for a machine of 32 bits that sees how a factor came about extends it to 64 bits where
 * it can share that, and then multiplies 64 x 64. */
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
