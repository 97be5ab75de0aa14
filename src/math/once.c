/* once.c - the copies of SHARED functions, see noinline.h. */
#include "integer.h"
#include "noinline.h"

#if FLASH_IS_SCARCE
#if TIA_HALF_PRODUCTS
extern inline uint64_t tia_mul_u32(uint32_t a, uint32_t b);
extern inline int64_t tia_mul_s32(int32_t a, int32_t b);
#endif
extern inline unsigned tia_clz32_table(uint32_t x);
#endif
