/* num_f128.h - 113 bits: the reference for the error of double precision. The type is long double where that has 113
 * bits, else __float128, whose functions the GNU C library has; probe.h asks for both. It needs no more alignment than
 * uint64_t, since callers' memory has that of uint64_t alone. */
#ifndef TIA_NUM_NUM_F128_H
#define TIA_NUM_NUM_F128_H

#if __LDBL_MANT_DIG__ == 113
typedef long double num_real __attribute__((aligned(8)));
#define num_root(x) __builtin_sqrtl(x)
#define num_angle(y, x) __builtin_atan2l(y, x)
#else
typedef __float128 num_real __attribute__((aligned(8)));
extern num_real sqrtf128(num_real x);
extern num_real atan2f128(num_real y, num_real x);
#define num_root(x) sqrtf128(x)
#define num_angle(y, x) atan2f128(y, x)
#endif

typedef num_real num_double;

#define NUM_NAME "f128"
#define NUM_PREFIX tia_f128_
#define NUM_CORE tia_core_f128
#define NUM_ESTIMATOR tia_estimator_f128

/* The first 128 bits of 2 pi, in two exact parts whose sum is rounded once: a literal of this type has no spelling that
 * all compilers accept. */
#define NUM_TWO_PI                                                                                                     \
    ((num_real)UINT64_C(0xc90fdaa22168c234) / (num_real)(UINT64_C(1) << 61) +                                          \
     (num_real)UINT64_C(0xc4c6628b80dc1cd1) / (num_real)(UINT64_C(1) << 61) / (num_real)18446744073709551616.0)

#include "num_real.h"

#endif
