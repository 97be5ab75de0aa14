/* noinline.h - NOINLINE marks functions that are not inlined: so their arrays stay off the stack during other calls, or
 * flash has them once. ONCE_IN_FLASH marks those that only processors of up to 32 bits have once. INLINED marks those
 * that are less code than a call, for builds by -fno-inline, or run so often that flash is spent on them;
 * INLINED_IN_WORDS those that are INLINED but where pointers have 16 bits, as flash is full there. LIKELY and UNLIKELY
 * say how a condition goes, so that code that runs rarely does not take a loop's registers. */
#ifndef TIA_MATH_NOINLINE_H
#define TIA_MATH_NOINLINE_H

#include <stdint.h>

#if defined(__GNUC__)
#define NOINLINE __attribute__((noinline))
#define INLINED inline __attribute__((always_inline))
#define LIKELY(condition) __builtin_expect((condition), 1)
#define UNLIKELY(condition) __builtin_expect((condition), 0)
#else
#define NOINLINE
#define INLINED inline
#define LIKELY(condition) (condition)
#define UNLIKELY(condition) (condition)
#endif

#if UINTPTR_MAX > UINT16_MAX
#define INLINED_IN_WORDS INLINED
#else
#define INLINED_IN_WORDS inline
#endif

#define FLASH_IS_SCARCE (UINTPTR_MAX <= UINT32_MAX)
#if FLASH_IS_SCARCE
#define ONCE_IN_FLASH NOINLINE
#else
#define ONCE_IN_FLASH inline
#endif

/* SHARED marks inline functions of headers: where flash is scarce and the compiler does not inline them, once.c has the
 * one copy. */
#if FLASH_IS_SCARCE
#define SHARED inline
#else
#define SHARED static inline
#endif

#endif
