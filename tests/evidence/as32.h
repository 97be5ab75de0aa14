/* as32.h - lets a compiler for 64 bits take the code for processors of 32 bits, so that tests of 64 bits execute it. */
#include <stdint.h>

#undef UINTPTR_MAX
#define UINTPTR_MAX UINT32_MAX
