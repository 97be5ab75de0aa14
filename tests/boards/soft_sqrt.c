/* soft_sqrt.c - square roots of float and double, for builds whose instructions are counted: the compiler's soft float
 * has none. Digit by digit, as in fdlibm and the C libraries of small processors; rounded to nearest. For finite
 * numbers that are not negative. */
#include <stdint.h>

float sqrtf(float x);
double sqrt(double x);

/* DIGITS bits of mantissa with the leading one. The radicand, below 4, is shifted up by a digit a step. The root has
 * one digit more than a mantissa, by which it is rounded; a tie is impossible. */
#define DEFINE_SQRT(NAME, REAL, WORD, DIGITS, BIAS)                                                                    \
    REAL NAME(REAL x)                                                                                                  \
    {                                                                                                                  \
        const WORD one = (WORD)1 << (DIGITS - 1);                                                                      \
        WORD bits, rest, root = 0, twice = 0;                                                                          \
        __builtin_memcpy(&bits, &x, sizeof bits);                                                                      \
        if (bits < one)                                                                                                \
            return 0; /* zero, and values too small to matter */                                                       \
        int exponent = (int)(bits >> (DIGITS - 1)) - BIAS;                                                             \
        rest = ((bits & (one - 1)) | one) << (1 + (exponent & 1));                                                     \
        for (WORD digit = one << 1; digit; digit >>= 1) {                                                              \
            WORD next = twice + digit;                                                                                 \
            if (next <= rest) {                                                                                        \
                twice = next + digit;                                                                                  \
                rest -= next;                                                                                          \
                root += digit;                                                                                         \
            }                                                                                                          \
            rest <<= 1;                                                                                                \
        }                                                                                                              \
        root = (root >> 1) + (root & 1);                                                                               \
        bits = root - one + ((WORD)(((exponent - (exponent & 1)) / 2) + BIAS) << (DIGITS - 1));                        \
        __builtin_memcpy(&x, &bits, sizeof x);                                                                         \
        return x;                                                                                                      \
    }

DEFINE_SQRT(sqrtf, float, uint32_t, 24, 127)
DEFINE_SQRT(sqrt, double, uint64_t, 53, 1023)
