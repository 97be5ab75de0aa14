/* best.c - the instruction sets that this library supports, and the choice of the best one for this processor. */
#include <string.h>

#include <tia/simd.h>

#if (defined __arm__ && defined TIA_HAVE_NEON32) || defined TIA_HAVE_RVV
#include <sys/auxv.h>
#endif
#if defined __x86_64__ || defined __i386__
#include <cpuid.h>
#endif

struct entry {
    const char *name;
    const struct tia_simd *simd; /* NULL: not in this library */
    bool (*there)(void);
};

/* Defines a test for an instruction set; gcc's cpu model also checks that the system saves the wide registers. */
#define THERE(name, question)                                                                                          \
    static bool name(void)                                                                                             \
    {                                                                                                                  \
        return (question);                                                                                             \
    }

#ifdef TIA_HAVE_SCALAR
extern const struct tia_simd tia_simd_scalar;
THERE(has_scalar, true)
#define SCALAR &tia_simd_scalar, has_scalar
#else
#define SCALAR NULL, NULL
#endif
#ifdef TIA_HAVE_SSE41
extern const struct tia_simd tia_simd_sse41;
THERE(has_sse41, __builtin_cpu_supports("sse4.1") != 0)
#define SSE41 &tia_simd_sse41, has_sse41
#else
#define SSE41 NULL, NULL
#endif
#ifdef TIA_HAVE_AVX2
extern const struct tia_simd tia_simd_avx2;
THERE(has_avx2, __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0)
#define AVX2 &tia_simd_avx2, has_avx2
#else
#define AVX2 NULL, NULL
#endif
#ifdef TIA_HAVE_AVX512
extern const struct tia_simd tia_simd_avx512;
THERE(has_avx512, __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512bw") != 0 &&
                      __builtin_cpu_supports("avx512dq") != 0 && __builtin_cpu_supports("avx512vl") != 0)
#define AVX512 &tia_simd_avx512, has_avx512
#else
#define AVX512 NULL, NULL
#endif
#if defined TIA_HAVE_NEON32
extern const struct tia_simd tia_simd_neon;
THERE(has_neon, (getauxval(AT_HWCAP) & 1 << 12) != 0) /* HWCAP_NEON */
#define NEON &tia_simd_neon, has_neon
#elif defined TIA_HAVE_NEON
extern const struct tia_simd tia_simd_neon;
THERE(has_neon, true) /* every AArch64 processor has NEON */
#define NEON &tia_simd_neon, has_neon
#else
#define NEON NULL, NULL
#endif
#ifdef TIA_HAVE_RVV
extern const struct tia_simd tia_simd_rvv;

/* Kernels of processors with V of version 0.7 report it with the same bit. `vsetvli t0, zero, e32, m1, ta, ma` returns
 * the number of elements of a vector, and 0 by that version, which has neither ta nor ma. */
static bool has_rvv(void)
{
    unsigned long elements;

    if (!(getauxval(AT_HWCAP) & 1 << ('v' - 'a')))
        return false;
    __asm__ volatile(".4byte 0x0d0072d7\n\tmv %0, t0" : "=r"(elements) : : "t0");
    return elements >= 4;
}
#define RVV &tia_simd_rvv, has_rvv
#else
#define RVV NULL, NULL
#endif
#ifdef TIA_HAVE_WASM
extern const struct tia_simd tia_simd_wasm;
THERE(has_wasm, true) /* a module with these instructions does not start without them */
#define WASM &tia_simd_wasm, has_wasm
#else
#define WASM NULL, NULL
#endif

/* Instruction sets from the narrowest to the widest; those of one processor family are adjacent. */
static const struct entry entries[] = {{"scalar", SCALAR}, {"sse41", SSE41}, {"avx2", AVX2}, {"avx512", AVX512},
                                       {"neon", NEON},     {"rvv", RVV},     {"wasm", WASM}};
#define ENTRIES (sizeof entries / sizeof *entries)

const struct tia_simd *tia_simd_at(unsigned index)
{
    for (size_t i = 0; i < ENTRIES; i++)
        if (entries[i].simd && entries[i].there() && index-- == 0)
            return entries[i].simd;
    return NULL;
}

/* True under QEMU without KVM, which emulates vector and floating-point instructions far more slowly than integer
 * ones. */
static bool is_emulated(void)
{
#if defined __x86_64__ || defined __i386__
    unsigned a, b, c, d;
    const unsigned hypervisor = 1u << 31;

    if (!__get_cpuid(1, &a, &b, &c, &d) || !(c & hypervisor))
        return false;
    __cpuid(0x40000000, a, b, c, d);
    return b == 0x54474354 && c == 0x43544743 && d == 0x47435447; /* TCGTCGTCGTCG */
#else
    return false;
#endif
}

const struct tia_simd *tia_simd_best(void)
{
    const struct tia_simd *best = NULL;

    if (is_emulated())
        return NULL;
    for (unsigned i = 0; tia_simd_at(i); i++)
        best = tia_simd_at(i);
    return best;
}

int tia_simd_named(const char *name, const struct tia_simd **simd)
{
    const struct tia_simd *found = NULL;

    if (!name || !simd)
        return TIA_ERR_ARGUMENT;
    *simd = NULL;
    if (strcmp(name, "plain") == 0)
        return TIA_OK;
    for (size_t i = 0; i < ENTRIES; i++) {
        if (entries[i].simd && entries[i].there())
            found = entries[i].simd;
        if (strcmp(name, entries[i].name) == 0) {
            /* neon, rvv and wasm, if they are not built in, have no narrower substitute */
            *simd = i < 4 || entries[i].simd ? found : NULL;
            return TIA_OK;
        }
    }
    return TIA_ERR_ARGUMENT;
}
