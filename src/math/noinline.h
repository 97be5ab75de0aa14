/* noinline.h - NOINLINE marks functions that are not inlined: so their arrays stay off the stack during other calls, or
 * flash has them once. ONCE_IN_FLASH marks those that only processors of up to 32 bits have once. */
#ifndef TIA_MATH_NOINLINE_H
#define TIA_MATH_NOINLINE_H

#include <stdint.h>

#if defined(__GNUC__)
#define NOINLINE __attribute__((noinline))
#else
#define NOINLINE
#endif

#define FLASH_IS_SCARCE (UINTPTR_MAX <= UINT32_MAX)
#if FLASH_IS_SCARCE
#define ONCE_IN_FLASH NOINLINE
#else
#define ONCE_IN_FLASH inline
#endif

#endif
