/* environment.h - the floating-point environment that the error bounds assume: rounding to nearest, subnormal numbers
 * not flushed to 0, no traps. A caller may have another environment: by fesetround or feenableexcept, by -ffast-math in
 * a library, or by a compiler option for the whole program. */
#ifndef TIA_SIMD_ENVIRONMENT_H
#define TIA_SIMD_ENVIRONMENT_H

#include <stdbool.h>
#include <stdint.h>

/* The caller's environment: control and flags. */
struct environment {
    uint64_t control, flags;
};

#if defined SIMD_ENVIRONMENT_FIXED /* a test defines this, for the code below #ifdef ENVIRONMENT_FIXED */
#define ENVIRONMENT_FIXED
#elif defined __SSE__
static inline void environment_read(struct environment *e)
{
    e->control = __builtin_ia32_stmxcsr();
}
static inline void environment_write(const struct environment *e)
{
    __builtin_ia32_ldmxcsr((unsigned)e->control);
}
#define ENVIRONMENT_DEFAULT 0x1f80 /* all exceptions masked */
#elif defined __aarch64__
static inline void environment_read(struct environment *e)
{
    __asm__ volatile("mrs %0, fpcr\n\tmrs %1, fpsr" : "=r"(e->control), "=r"(e->flags));
}
static inline void environment_write(const struct environment *e)
{
    __asm__ volatile("msr fpcr, %0\n\tmsr fpsr, %1" : : "r"(e->control), "r"(e->flags) : "memory");
}
#elif defined __arm__ && defined __ARM_FP
static inline void environment_read(struct environment *e)
{
    uint32_t fpscr;

    __asm__ volatile("vmrs %0, fpscr" : "=r"(fpscr));
    e->control = fpscr;
}
static inline void environment_write(const struct environment *e)
{
    __asm__ volatile("vmsr fpscr, %0" : : "r"((uint32_t)e->control) : "memory");
}
#elif defined __riscv_flen
static inline void environment_read(struct environment *e)
{
    unsigned long fcsr;

    __asm__ volatile("frcsr %0" : "=r"(fcsr));
    e->control = fcsr;
}
static inline void environment_write(const struct environment *e)
{
    __asm__ volatile("fscsr %0" : : "r"((unsigned long)e->control) : "memory");
}
#elif defined __powerpc__ && !defined __NO_FPRS__ && !defined _SOFT_FLOAT
static inline void environment_read(struct environment *e)
{
    double fpscr;

    __asm__ volatile("mffs %0" : "=d"(fpscr));
    __builtin_memcpy(&e->control, &fpscr, sizeof fpscr);
}
static inline void environment_write(const struct environment *e)
{
    double fpscr;

    __builtin_memcpy(&fpscr, &e->control, sizeof fpscr);
    __asm__ volatile("mtfsf 255, %0" : : "d"(fpscr) : "memory");
}
#elif defined __s390x__
static inline void environment_read(struct environment *e)
{
    uint32_t fpc;

    __asm__ volatile("efpc %0" : "=d"(fpc));
    e->control = fpc;
}
static inline void environment_write(const struct environment *e)
{
    __asm__ volatile("sfpc %0" : : "d"((uint32_t)e->control) : "memory");
}
#else
#define ENVIRONMENT_FIXED
#endif

#ifdef ENVIRONMENT_FIXED

/* True if sums are rounded to nearest and subnormal numbers are not flushed to 0. In doubles, 1 + 2^-53 is halfway
 * between 1 and the next double, and is rounded to 1; 1 + 3 2^-54 is rounded to the next double. Floats are tested
 * alike, with 2^-24 and 3 2^-25. */
static inline bool environment_is_default(void)
{
    volatile double one = 1, half_d = 0x1p-53, more_d = 0x3p-54, least_d = 0x1p-1022;
    volatile float half_f = 0x1p-24f, more_f = 0x3p-25f, least_f = 0x1p-126f, one_f = 1;
    volatile double sum_d = one + half_d, minus_d = -one - half_d, up_d = one + more_d, small_d = least_d / 4;
    volatile float sum_f = one_f + half_f, minus_f = -one_f - half_f, up_f = one_f + more_f, small_f = least_f / 4;

    return sum_d <= 1 && minus_d >= -1 && up_d > 1 && sum_f <= 1 && minus_f >= -1 && up_f > 1 && small_d * 4 > 0 &&
           small_f * 4 > 0;
}

/* Returns true if the environment is the default one already; for processors whose control register is unknown. */
static inline bool environment_take(struct environment *e)
{
    *e = (struct environment){0, 0};
    return environment_is_default();
}

static inline void environment_leave(const struct environment *e)
{
    (void)e;
}

#else
#ifndef ENVIRONMENT_DEFAULT
#define ENVIRONMENT_DEFAULT 0
#endif

/* Stores the caller's environment in *e and sets the kernels' own; returns false where that is impossible. */
static inline bool environment_take(struct environment *e)
{
    const struct environment own = {ENVIRONMENT_DEFAULT, 0};

    e->flags = 0;
    environment_read(e);
    environment_write(&own);
    return true;
}

/* Restores the caller's environment and flags, so that the kernels raise no flags for the caller. */
static inline void environment_leave(const struct environment *e)
{
    environment_write(e);
}
#endif

#endif
