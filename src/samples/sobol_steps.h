/* sobol_steps.h - template: steps of sobol.h, for one number or a vector of numbers. Parameters: SOBOL_WORD, uint32_t
 * or a vector of them, and SOBOL_STEP(name), the functions' names. No include guard. */

static inline SOBOL_WORD SOBOL_STEP(hash)(SOBOL_WORD x)
{
    x = (x ^ x >> 16) * UINT32_C(0x21f0aaad);
    x = (x ^ x >> 15) * UINT32_C(0xd35a2d97);
    return x ^ x >> 15;
}

static inline SOBOL_WORD SOBOL_STEP(hash2)(SOBOL_WORD a, SOBOL_WORD b)
{
    return SOBOL_STEP(hash)(a ^ SOBOL_STEP(hash)(b + UINT32_C(0x9e3779b9)));
}

static inline SOBOL_WORD SOBOL_STEP(reverse)(SOBOL_WORD x)
{
    x = x >> 16 | x << 16;
    x = (x >> 8 & UINT32_C(0x00ff00ff)) | (x & UINT32_C(0x00ff00ff)) << 8;
    x = (x >> 4 & UINT32_C(0x0f0f0f0f)) | (x & UINT32_C(0x0f0f0f0f)) << 4;
    x = (x >> 2 & UINT32_C(0x33333333)) | (x & UINT32_C(0x33333333)) << 2;
    return (x >> 1 & UINT32_C(0x55555555)) | (x & UINT32_C(0x55555555)) << 1;
}

/* Scrambles a bit-reversed number by Owen's method: no bit of the result depends on a higher bit of x. */
static inline SOBOL_WORD SOBOL_STEP(scramble)(SOBOL_WORD x, SOBOL_WORD seed)
{
    x ^= x * UINT32_C(0x3d20adea);
    x += seed;
    x *= seed >> 16 | UINT32_C(1);
    x ^= x * UINT32_C(0x05526c56);
    x ^= x * UINT32_C(0x53a22864);
    return x;
}

/* Returns point `index` of the second dimension, whose matrix is Pascal's triangle modulo 2, a fivefold tensor product.
 */
static inline SOBOL_WORD SOBOL_STEP(pascal)(SOBOL_WORD index)
{
    index ^= index >> 1 & UINT32_C(0x55555555);
    index ^= index >> 2 & UINT32_C(0x33333333);
    index ^= index >> 4 & UINT32_C(0x0f0f0f0f);
    index ^= index >> 8 & UINT32_C(0x00ff00ff);
    return index ^ index >> 16;
}
