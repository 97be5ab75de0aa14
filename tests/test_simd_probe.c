/* The test of the floating-point environment on processors whose control register is unknown. */
#define SIMD_ENVIRONMENT_FIXED
#include "simd/environment.h"

#include <fenv.h>

#include "check.h"

TEST(rounding)
{
    struct environment caller;

    (void)fesetenv(FE_DFL_ENV);
    CHECK(environment_take(&caller));
#ifdef FE_UPWARD
    const int others[] = {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
    for (int i = 0; i < 3; i++) {
        (void)fesetround(others[i]);
        bool taken = environment_take(&caller);
        (void)fesetround(FE_TONEAREST);
        CHECK_MSG(!taken, "mode %d", others[i]);
    }
#endif
}

TEST(subnormal_numbers)
{
#ifdef __SSE__
    const unsigned bits[] = {0x8000, 0x0040}; /* flush results to zero; treat operands as zero */
    struct environment caller;

    for (int i = 0; i < 2; i++) {
        __builtin_ia32_ldmxcsr(0x1f80 | bits[i]);
        bool taken = environment_take(&caller);
        __builtin_ia32_ldmxcsr(0x1f80);
        CHECK_MSG(!taken, "bit %x", bits[i]);
    }
#else
    SKIP("only for x86");
#endif
}

int main(void)
{
    RUN(rounding);
    RUN(subnormal_numbers);
    return check_status();
}
