/* float_modes.h - floating-point environments in which a program may call SIMD kernels: rounding other than to nearest;
 * and, if the processor has them, flushing of subnormal numbers to 0, and traps.
 *
 * A program with this header runs in the mode that the environment variable SIMD_MODE names. tests/slow/simd runs tests
 * of the SIMD kernels in each mode. */
#ifndef TESTS_FLOAT_MODES_H
#define TESTS_FLOAT_MODES_H

#include <fenv.h>
#include <stdlib.h>
#include <string.h>

#include "simd/environment.h"

struct float_mode {
    const char *name;
    int rounding;
    uint64_t set, clear; /* bits of the control register */
};

#if defined __SSE__
#define FLOAT_FLUSH 0x8040
#define FLOAT_MASKS 0x1f80
#elif defined __aarch64__ || (defined __arm__ && defined __ARM_FP)
#define FLOAT_FLUSH (1 << 24)
#define FLOAT_MASKS 0
#else
#define FLOAT_FLUSH 0
#define FLOAT_MASKS 0
#endif

static const struct float_mode float_modes[] = {
    {"nearest", FE_TONEAREST, 0, 0},
#ifdef FE_UPWARD
    {"up", FE_UPWARD, 0, 0},
    {"down", FE_DOWNWARD, 0, 0},
    {"zero", FE_TOWARDZERO, 0, 0},
#endif
#if FLOAT_FLUSH
    {"flush", FE_TONEAREST, FLOAT_FLUSH, 0},
#endif
#if FLOAT_MASKS
    {"traps", FE_TONEAREST, 0, FLOAT_MASKS},
#endif
};
#define FLOAT_MODES (sizeof float_modes / sizeof *float_modes)

static inline void float_mode_set(const struct float_mode *mode)
{
    (void)fesetround(mode->rounding);
#ifndef ENVIRONMENT_FIXED
    struct environment e = {0, 0};
    environment_read(&e);
    e.control = (e.control | mode->set) & ~mode->clear;
    environment_write(&e);
#endif
}

/* Sets the environment that SIMD kernels set on entry, for tests that call their inner functions. */
static inline void float_mode_of_simd(void)
{
    struct environment caller;

    if (!environment_take(&caller))
        abort();
}

__attribute__((constructor)) static void float_mode_asked_for(void)
{
    const char *name = getenv("SIMD_MODE");

    for (size_t i = 0; name && i < FLOAT_MODES; i++)
        if (strcmp(float_modes[i].name, name) == 0)
            float_mode_set(&float_modes[i]);
}

#endif
