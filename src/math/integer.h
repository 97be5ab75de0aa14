/* integer.h - integer kernels: shifts that round, reciprocal, square root and its inverse, wide products.
 *
 * The kernels have few branches or none, no state, and the same results, bit for bit, on every machine. They are built
 * from products of 32 x 32 bits in 64 bits and from the count of leading zeros, which take one instruction each on most
 * machines. "ulp" is the unit of the result's last bit.
 *
 * The error bounds stated here are proved (tests/proofs, make prove), tested with every 32-bit argument (make
 * check-exhaustive), and sampled by every make check.
 */
#ifndef TIA_MATH_INTEGER_H
#define TIA_MATH_INTEGER_H

#include <stdint.h>
#include <tia/vec.h>

#include "mul64.h"
#include "target.h"

/* Right shifts of negative numbers are implementation-defined in C, but arithmetic with every known compiler. */
_Static_assert((-5 >> 1) == -3, "signed right shift must be arithmetic");

/* Places tables in flash even where constants are copied to RAM, if the compiler has a keyword for it: avr-gcc, in GNU
 * C. Such tables may only be indexed: their addresses are in another address space. */
#if defined __FLASH && !defined __STRICT_ANSI__
#define TIA_FLASH __flash
#else
#define TIA_FLASH
#endif

/* First approximations for Newton's method, piecewise linear, see tools/generate/tables.py. */
extern const TIA_FLASH uint32_t tia_rsqrt_lines[384];
extern const TIA_FLASH uint32_t tia_reciprocal_lines[128];

extern const TIA_FLASH uint8_t tia_clz_places[32];

/* atan(2^-i)/(2 pi), Q1.62. */
extern const TIA_FLASH int64_t tia_turns[60];

/* sin(2 pi i/256), i = 0..64, Q1.62. */
extern const TIA_FLASH int64_t tia_sines[65];

/* Returns the number of leading zero bits of x, not 0, on machines without an instruction for it. Setting all bits
 * below the highest set bit makes x = 2^n - 1; the product with the constant (from Anderson's Bit Twiddling Hacks) has
 * different upper five bits for each n. */
SHARED unsigned tia_clz32_table(uint32_t x)
{
    x |= x >> 1;
    x |= x >> 2;
    x |= x >> 4;
    x |= x >> 8;
    x |= x >> 16;
    return tia_clz_places[x * UINT32_C(0x07c4acdd) >> 27];
}

/* Returns the number of leading zero bits of x, not 0. */
static inline unsigned tia_clz32(uint32_t x)
{
#if TIA_COUNTS_ZEROS && __SIZEOF_INT__ == 4
    return (unsigned)__builtin_clz(x);
#elif TIA_COUNTS_ZEROS && __SIZEOF_LONG__ == 4
    return (unsigned)__builtin_clzl(x);
#else
    return tia_clz32_table(x);
#endif
}

/* Returns the number of trailing zero bits of x, not 0. */
static inline unsigned tia_ctz32(uint32_t x)
{
    unsigned zeros = 0;

    if (TIA_COUNTS_ZEROS)
        return 31 - tia_clz32(x & (0 - x));
    while (!(x >> zeros & 1)) /* few, as a rule */
        zeros++;
    return zeros;
}

/* Returns the number of leading zero bits of x, not 0. */
static inline unsigned tia_clz64(uint64_t x)
{
#if defined(__GNUC__) && UINTPTR_MAX > UINT32_MAX
    return (unsigned)__builtin_clzll((unsigned long long)x);
#else
    uint32_t high = (uint32_t)(x >> 32);
    return high ? tia_clz32(high) : 32 + tia_clz32((uint32_t)x);
#endif
}

/* Returns a sum to which a difference of a and b is added, which is 0 if they are equal; at most 2^20 are added. */
static INLINED uint32_t tia_add_difference(uint32_t sum, uint32_t a, uint32_t b)
{
#if TIA_UPPER_PRODUCTS
    __asm__("usada8 %0, %1, %2, %0" : "+r"(sum) : "r"(a), "r"(b));
    return sum;
#else
    return sum | (a ^ b);
#endif
}

/* True on processors of 8 bits, which shift bit by bit, but for whole bytes. */
#define TIA_SHIFTS_BITS (sizeof(int) == 2)

/* Returns x >> s for s in 16..31. */
static inline uint32_t tia_top_bits(uint32_t x, unsigned s)
{
    return TIA_SHIFTS_BITS ? (uint32_t)((uint16_t)(x >> 16) >> (s - 16)) : x >> s;
}

/* Returns x / 2^s to nearest, ties up. s <= 63, |x| < 2^62. */
/*@ requires s <= 63 && -0x4000000000000000 < x < 0x4000000000000000;
    assigns \nothing;
    ensures s == 0 ==> \result == x;
    ensures s > 0 ==> \result == (x + (1 << (s - 1))) >> s; */
static inline int64_t tia_round_shift(int64_t x, unsigned s)
{
    int64_t half = (int64_t)((UINT64_C(1) << s) / 2);
    /*@ assert half <= 0x4000000000000000; */
    return (x + half) >> s;
}

/* Returns x, clamped to the range of 32 bits. */
static inline int32_t tia_saturate_s32(int64_t x)
{
    return (int32_t)(x < INT32_MIN ? INT32_MIN : x > INT32_MAX ? INT32_MAX : x);
}

/* True on 32-bit machines, where a 64-bit addition needs a carry. There tia_round_shift_words is used for s >= 1. */
#define TIA_SHIFTS_WORDS (UINTPTR_MAX == UINT32_MAX)

/* Returns the result of tia_round_shift, s >= 1, by adding the highest bit that is shifted out. */
static inline int64_t tia_round_shift_words(int64_t x, unsigned s)
{
    uint32_t low = (uint32_t)x;
    int32_t high = (int32_t)(x >> 32);
    if (s > 32 && !TIA_HALF_PRODUCTS) { /* on a Cortex-M0 this takes longer */
        int32_t twice = high >> (s - 33);
        return (twice >> 1) + (twice & 1);
    }
    if (s >= 32)
        return (high >> (s - 32)) + (int64_t)(s == 32 ? low >> 31 : (uint32_t)(high >> (s - 33)) & 1);
    uint64_t floor = (uint64_t)(uint32_t)(high >> s) << 32 | (low >> s | (uint32_t)high << (32 - s));
    return (int64_t)(floor + (low >> (s - 1) & 1));
}

/* Returns the lower 32 bits of tia_round_shift's result, for unsigned x. */
static inline uint32_t tia_round_shift_low(uint64_t x, unsigned s)
{
    uint32_t low = (uint32_t)x, high = (uint32_t)(x >> 32);
    if (s >= 32)
        return (high >> (s - 32)) + (s == 32 ? low >> 31 : high >> (s - 33) & 1);
    return (low >> s) + (high << (32 - s)) + (low >> (s - 1) & 1);
}

/* Returns x * 2^s; s <= 31. */
static inline uint64_t tia_shift_up(uint64_t x, unsigned s)
{
    uint32_t low = (uint32_t)x, high = (uint32_t)(x >> 32);
    if (!TIA_SHIFTS_WORDS)
        return x << s;
    return (uint64_t)(high << s | low >> 1 >> (31 - s)) << 32 | (uint32_t)(low << s);
}

/* Returns x * 2^s, s being the count of x's leading zero bits or one less. */
static inline uint64_t tia_shift_to_top(uint64_t x, unsigned s)
{
    return s < 32 ? tia_shift_up(x, s) : x << s;
}

/* Returns the value of a table entry's line at f / 2^16: Q1.31 in [2^31, 2^32). */
static inline uint32_t tia_seed(uint32_t line, uint32_t f)
{
    uint32_t c0 = UINT32_C(0x80000000) | ((line >> 1) & ~UINT32_C(0x7ff));
    return c0 - (((line & 0xfff) * f) >> 3);
}

/* Returns 2^31 / sqrt(a / 2^32) with a relative error below 3.2e-6. a >= 2^30. */
static inline uint32_t tia_rsqrt_seed(uint32_t a)
{
    return tia_seed(tia_rsqrt_lines[tia_top_bits(a, 23) - 128], (a >> 7) & 0xffff);
}

/* Returns 2^63 / d with a relative error below 7.9e-6. d >= 2^31. */
static inline uint32_t tia_reciprocal_seed(uint32_t d)
{
    return tia_seed(tia_reciprocal_lines[(d >> 24) - 128], (d >> 8) & 0xffff);
}

/* Returns 2^31 / sqrt(n / 2^64), Q1.31 in [2^31, 2^32), within 2 ulp. n >= 2^62.
 *
 * One Newton step y (1 + e/2), e = 1 - n y^2, on the upper word of n; the lower word is too small to matter.
 * Cutting a factor to 32 bits loses half a unit on average, so half a unit is added back: n counts as a + 1/2
 * and y^2 as q + 1/2. e is raised by 2^-32 to centre the final rounding down where y is near 2. y + step stays
 * below 2^32 for every n. */
static inline uint32_t tia_rsqrt(uint64_t n)
{
    uint32_t a = (uint32_t)(n >> 32);
    uint32_t y = tia_rsqrt_seed(a);
    uint32_t q = (uint32_t)(tia_mul_u32(y, y) >> 32);
    uint64_t product = tia_mul_u32(a, q) + ((a & q) + ((a ^ q) >> 1));
    int64_t e = (int64_t)((UINT64_C(1) << 62) + (UINT64_C(1) << 30) - product);
    return y + (uint32_t)(tia_mul_s32((int32_t)(y >> 1), (int32_t)(e >> 16)) >> 46);
}

/* Returns 2^63 / d, at most 2^32 - 1; the error is -1.02 to +0.25 ulp. d >= 2^31.
 *
 * One Newton step y (1 + e), e = 1 - d y, rounded down. The relative error of the step is -e^2, a quarter of an ulp at
 * d = 2^31. Raising e by 2^-34 corrects that; more would give 2^32 for d = 2^31, which does not fit. */
static inline uint32_t tia_reciprocal(uint32_t d)
{
    uint32_t y = tia_reciprocal_seed(d);
    int64_t e = (int64_t)((UINT64_C(1) << 63) + (UINT64_C(1) << 29) - tia_mul_u32(d, y));
    return y + (uint32_t)(tia_mul_s32((int32_t)(y >> 1), (int32_t)(e >> 16)) >> 46);
}

/* Returns the square root of n >= 2^62, rounded down, exact.
 *
 * r0 = n y with the seed y, then one Newton step with y for 1/r: r0 + (n - r0^2) y / 2. The error of the method is -3/2
 * e^2 r, less than 0.1 in size; rounding adds up to 2^-12 either way. Subtracting 2^12 from the remainder (1/32 to 1/16
 * in the root) makes sure that the result is never too large. After rounding down it is the root or one less; one
 * comparison decides which. */
static inline uint32_t tia_sqrt_normalised(uint64_t n)
{
    uint32_t a = (uint32_t)(n >> 32);
    uint32_t y = tia_rsqrt_seed(a);
    uint32_t half = (uint32_t)(tia_mul_u32(a, y) >> 32); /* half of r0, which may need 33 bits */
    int32_t rest = (int32_t)((int64_t)(n - (tia_mul_u32(half, half) << 2)) >> 16) - (1 << 12);
    uint32_t r = (half << 1) + (uint32_t)(tia_mul_s32(rest, (int32_t)(y >> 1)) >> 47);
    uint32_t more = r + 1; /* 0: 2^32, whose square less 1 is not below n */
    return tia_mul_u32(more, more) - 1 < n ? more : r;
}

/* Returns the square root of x, rounded down, exact. */
static inline uint32_t tia_sqrt64(uint64_t x)
{
    if (!x)
        return 0;
    unsigned s = tia_clz64(x) & ~1u;
    return tia_sqrt_normalised(tia_shift_to_top(x, s)) >> (s >> 1);
}

/* Returns the square root of x, rounded down, exact. It is computed bit by bit, with code that is small and easy to
 * prove, for uses where speed does not matter. */
/*@ assigns \nothing;
    ensures \result * (integer)\result <= x < (\result + 1) * (integer)(\result + 1); */
static inline uint32_t tia_sqrt32(uint32_t x)
{
    uint32_t r = 0;
    /*@ loop invariant bit == 0 || bit == 1 || bit == 2 || bit == 4 || bit == 8 || bit == 16 || bit == 32 ||
          bit == 64 || bit == 128 || bit == 256 || bit == 512 || bit == 1024 || bit == 2048 || bit == 4096 ||
          bit == 8192 || bit == 16384 || bit == 32768;
        loop invariant r + 2 * bit <= 65536 && r <= 65535;
        loop invariant r * (integer)r <= x;
        loop invariant bit > 0 ==> x < (r + 2 * (integer)bit) * (r + 2 * (integer)bit);
        loop invariant bit == 0 ==> x < (r + 1) * (integer)(r + 1);
        loop assigns r, bit;
        loop variant bit; */
    for (uint32_t bit = 32768; bit; bit /= 2) {
        uint32_t t = r + bit;
        /*@ assert t <= 65535; */
        /*@ ghost uint32_t r0 = r; */
        if (t * t <= x)
            r = t;
        /*@ assert r == r0 || r == r0 + bit; */
        /*@ assert x < (r + (integer)bit) * (r + (integer)bit); */
        /*@ assert bit == 1 ? bit / 2 == 0 : 2 * (bit / 2) == bit; */
    }
    return r;
}

/* Returns (x, y, z), in any unit, divided by its length, each component within 1.5 ulp; (0, 0, 0) for (0, 0, 0). */
struct tia_dir3 tia_normalise(int32_t x, int32_t y, int32_t z);

/* 1 if the compiler's 128-bit integers are used: if they exist and TIA_NO_INT128 is not defined. */
#if defined(__SIZEOF_INT128__) && !defined(TIA_NO_INT128)
#define TIA_INT128 1
#else
#define TIA_INT128 0
#endif

/* An unsigned 128-bit integer in two halves. */
struct tia_wide {
    uint64_t high, low;
};

/* Returns a b, exact, from 32-bit halves: for compilers without 128-bit integers. */
static inline struct tia_wide tia_wide_product_by_halves(uint64_t a, uint64_t b)
{
    uint32_t a0 = (uint32_t)a, a1 = (uint32_t)(a >> 32), b0 = (uint32_t)b, b1 = (uint32_t)(b >> 32);
    uint64_t low = tia_mul_u32(a0, b0), middle = tia_mul_u32(a1, b0) + (low >> 32);
    uint64_t cross = tia_mul_u32(a0, b1) + (uint32_t)middle;
    return (struct tia_wide){tia_mul_u32(a1, b1) + (middle >> 32) + (cross >> 32), cross << 32 | (uint32_t)low};
}

/* Returns a b, exact. */
static inline struct tia_wide tia_wide_product(uint64_t a, uint64_t b)
{
#if TIA_INT128
    __extension__ typedef unsigned __int128 wide;
    wide p = (wide)a * b;
    return (struct tia_wide){(uint64_t)(p >> 64), (uint64_t)p};
#else
    return tia_wide_product_by_halves(a, b);
#endif
}

/* Returns a b / 2^shift rounded to nearest, ties away from zero, so that negating a negates the result. shift in 1..63;
 * the result must fit. */
static inline int64_t tia_scaled_product(int64_t a, int64_t b, unsigned shift)
{
    struct tia_wide p = tia_wide_product((uint64_t)(a < 0 ? -a : a), (uint64_t)(b < 0 ? -b : b));
    int64_t size = (int64_t)((p.high << (64 - shift) | p.low >> shift) + (p.low >> (shift - 1) & 1));
    return (a < 0) != (b < 0) ? -size : size;
}

/* Returns the sign of a b - c d, exact: -1, 0 or 1. */
int tia_cmp_products(uint64_t a, uint64_t b, uint64_t c, uint64_t d);

#endif
