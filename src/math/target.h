/* target.h - what the processor has, by the compiler's macros: so every build system gets the same code. Beside
 * src/simd, only this file and fast.h ask which processor the core is compiled for. */
#ifndef TIA_MATH_TARGET_H
#define TIA_MATH_TARGET_H

#include <stdint.h>

/* 1 if the multiplier gives only the lower 32 bits of a product: ARMv6-M and ARMv8-M Baseline, such as Cortex-M0, M0+,
 * M1 and M23. */
#if defined(__GNUC__) && (defined(__ARM_ARCH_6M__) || defined(__ARM_ARCH_8M_BASE__))
#define TIA_HALF_PRODUCTS 1
#else
#define TIA_HALF_PRODUCTS 0
#endif

/* 1 if there are instructions for the upper word of a product, smmul, and for sums of differences of bytes, usada8,
 * which gcc does not use: ARMv6 and later, in Thumb ARMv7E-M and ARMv7-A, such as Cortex-M4 and M7. */
#if defined(__GNUC__) && defined(__ARM_FEATURE_DSP) && __ARM_ARCH >= 6 && (__ARM_ARCH >= 7 || !defined(__thumb__))
#define TIA_UPPER_PRODUCTS 1
#else
#define TIA_UPPER_PRODUCTS 0
#endif

/* 1 if there is an instruction, smlal, that adds a product to a sum, before which gcc copies registers: ARMv7 of 32
 * bits and Thumb-2, such as Cortex-M3. */
#if defined(__GNUC__) && defined(__arm__) && (defined(__thumb2__) || (defined(__ARM_ARCH) && __ARM_ARCH >= 7))
#define TIA_ADDS_PRODUCTS 1
#else
#define TIA_ADDS_PRODUCTS 0
#endif

/* 1 if numbers of two words have code of their own beside that for any number of words: 64-bit processors, and those
 * with Thumb-2, such as Cortex-M3. It takes 2.4 KB of flash, for which others have no room in 64 KiB. */
#if UINTPTR_MAX > UINT32_MAX || defined(__thumb2__)
#define TIA_WORD_PAIRS 1
#else
#define TIA_WORD_PAIRS 0
#endif

/* 1 if __builtin_clz is an instruction, or at least better than a table of 32 bytes. */
#if !defined(__GNUC__) || (defined(__arm__) && !defined(__ARM_FEATURE_CLZ)) ||                                         \
    (defined(__riscv) && !defined(__riscv_zbb))
#define TIA_COUNTS_ZEROS 0
#else
#define TIA_COUNTS_ZEROS 1
#endif

#endif
