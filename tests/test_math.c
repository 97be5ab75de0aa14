/* The integer kernels of src/math/integer.h and src/math/trig.h, thinned; exhaustive.c has the full sweeps. */
#include "check.h"
#include "sweeps.h"

#include "math/divide.h"
#include "math/trig.h"

/* Step of thinned sweeps; coprime to every power of two, so that they cover all residues. */
#define THIN 4099

TEST(leading_zeros)
{
    for (unsigned i = 0; i < 32; i++) {
        CHECK_EQ(tia_clz32(UINT32_C(1) << i), 31 - i);
        CHECK_EQ(tia_clz32(UINT32_MAX >> i), i);
        CHECK_EQ(tia_clz32_table(UINT32_C(1) << i), 31 - i);
        CHECK_EQ(tia_clz32_table(UINT32_MAX >> i), i);
    }
    CHECK_EQ(sweep_clz32(1, THIN), 0);
}

TEST(round_shift_to_nearest_ties_up)
{
    uint64_t state = 1;
    CHECK_EQ(tia_round_shift(3, 1), 2);
    CHECK_EQ(tia_round_shift(-3, 1), -1);
    CHECK_EQ(tia_round_shift(-5, 0), -5);
    CHECK_EQ(tia_round_shift((INT64_C(1) << 62) - 1, 62), 1);
    CHECK_EQ(tia_round_shift(1 - (INT64_C(1) << 62), 63), 0);
    for (int i = 0; i < 200000; i++) {
        unsigned s = 1 + (unsigned)(dice_next(&state) % 62);
        int64_t unit = INT64_C(1) << s, x = (int64_t)dice_next(&state);
        x >>= 2 + dice_next(&state) % 60;
        x -= i & 1 ? 0 : x % unit;                /* half of them are integers ... */
        x += i % 4 == 2 && s < 62 ? unit / 2 : 0; /* ... or halves */
        int64_t whole = x / unit, rest = x % unit;
        whole -= rest < 0;
        rest += rest < 0 ? unit : 0;
        CHECK_EQ(tia_round_shift(x, s), whole + (rest >= unit / 2));
        CHECK_EQ(tia_round_shift_words(x, s), tia_round_shift(x, s));
        x = x < 0 ? -x : x;
        CHECK_EQ(tia_round_shift_low((uint64_t)x, s), (uint32_t)tia_round_shift(x, s));
    }
}

TEST(square_root_of_64_bits)
{
    CHECK_EQ(tia_sqrt64(0), 0);
    CHECK_EQ(tia_sqrt64(UINT64_MAX), UINT32_MAX);
    CHECK_EQ(sweep_sqrt64_squares(1, THIN), 0);
    CHECK_EQ(sweep_sqrt64_squares(TWO_TO_32 - 100000, 1), 0);
    CHECK_EQ(sweep_sqrt64_squares(1, 1 << 16), 0);
    CHECK_EQ(sweep_sqrt64_small(TWO_TO_32 - 1000000, 1), 0);
    CHECK_EQ(sweep_sqrt64_random(7, 5000000), 0);
    for (uint64_t x = 0; x < 100000; x++)
        CHECK(sweep_is_root(x, tia_sqrt64(x)));
}

TEST(square_root_of_32_bits)
{
    CHECK_EQ(tia_sqrt32(0), 0);
    CHECK_EQ(sweep_sqrt32(TWO_TO_32 - 200000, 1), 0);
    for (uint64_t r = 1; r < 65536; r++) {
        CHECK_EQ(tia_sqrt32((uint32_t)(r * r)), r);
        CHECK_EQ(tia_sqrt32((uint32_t)(r * r - 1)), r - 1);
    }
}

TEST(seed_lines)
{
    struct sweep_range relative = {0, 0};
    CHECK_EQ(sweep_rsqrt_seed(0, THIN, &relative), 0);
    printf("# 1/sqrt seed: %.3g to %.3g\n", relative.low, relative.high);
    relative = (struct sweep_range){0, 0};
    CHECK_EQ(sweep_reciprocal_seed(0, THIN, &relative), 0);
    printf("# reciprocal seed: %.3g to %.3g\n", relative.low, relative.high);
}

TEST(one_over_square_root)
{
    struct sweep_range ulp = {0, 0};
    CHECK_EQ(sweep_rsqrt(0, THIN, &ulp), 0);
    CHECK_EQ(sweep_rsqrt((UINT64_C(3) << 30) - 100000, 1, &ulp), 0);
    /* from 2^62 on, where the result is nearest to 2^32 and a wrap would show */
    for (uint64_t a = UINT64_C(1) << 30; a < (UINT64_C(1) << 30) + 3000000; a++)
        CHECK(tia_rsqrt(a << 32) > UINT32_C(0xff000000));
    printf("# 1/sqrt: %.4f to %.4f ulp of Q1.31\n", ulp.low, ulp.high);
}

TEST(reciprocal)
{
    struct sweep_range ulp = {0, 0};
    CHECK_EQ(tia_reciprocal(UINT32_C(1) << 31), UINT32_MAX);
    CHECK_EQ(tia_reciprocal(UINT32_MAX), UINT32_C(1) << 31);
    CHECK_EQ(sweep_reciprocal(0, THIN, &ulp), 0);
    CHECK_EQ(sweep_reciprocal((UINT64_C(1) << 31) - 300000, 1, &ulp), 0);
    for (uint64_t d = UINT64_C(1) << 31; d < (UINT64_C(1) << 31) + 300000; d++)
        CHECK(tia_reciprocal((uint32_t)d) > UINT32_C(0xff000000));
    printf("# reciprocal: %.4f to %.4f ulp\n", ulp.low, ulp.high);
}

TEST(normalise)
{
    struct sweep_range ulp = {0, 0};
    CHECK_EQ(sweep_normalise(3, 500000, &ulp), 0);
    printf("# normalise: %.4f to %.4f ulp of Q2.30\n", ulp.low, ulp.high);
    static const int32_t lengths[] = {1, 2, 3, 65536, INT32_MAX, INT32_MIN};
    for (size_t i = 0; i < sizeof lengths / sizeof *lengths; i++) {
        int32_t one = lengths[i] < 0 ? -TIA_Q30_ONE : TIA_Q30_ONE;
        CHECK(tia_normalise(lengths[i], 0, 0).x == one && tia_normalise(lengths[i], 0, 0).y == 0);
        CHECK_EQ(tia_normalise(0, lengths[i], 0).y, one);
        CHECK_EQ(tia_normalise(0, 0, lengths[i]).z, one);
    }
    struct tia_dir3 corner = tia_normalise(INT32_MIN, INT32_MIN, INT32_MAX);
    CHECK(fabs(corner.x + 0x1p30 / sqrt(3)) <= 1.5 && fabs(corner.z - 0x1p30 / sqrt(3)) <= 1.5);
}

/* Multiplies a and b digit by digit, with digits of 16 bits. */
static void paper_product(uint64_t a, uint64_t b, uint64_t *high, uint64_t *low)
{
    uint32_t digits[8] = {0};
    for (int i = 0; i < 4; i++) {
        uint32_t carry = 0;
        for (int j = 0; j < 4; j++) {
            uint32_t t = (uint32_t)(a >> (16 * i) & 0xffff) * (uint32_t)(b >> (16 * j) & 0xffff);
            uint64_t sum = (uint64_t)t + digits[i + j] + carry;
            digits[i + j] = (uint32_t)(sum & 0xffff);
            carry = (uint32_t)(sum >> 16);
        }
        digits[i + 4] += carry;
    }
    *low = *high = 0;
    for (int i = 3; i >= 0; i--) {
        *low = *low << 16 | digits[i];
        *high = *high << 16 | digits[i + 4];
    }
}

TEST(wide_products)
{
    static const uint64_t edges[] = {0,
                                     1,
                                     2,
                                     0x7fffffff,
                                     0x80000000,
                                     UINT32_MAX,
                                     0x100000000,
                                     INT64_MAX - 1,
                                     INT64_MAX,
                                     (uint64_t)1 << 63,
                                     UINT64_MAX - 1,
                                     UINT64_MAX};
    const size_t count = sizeof edges / sizeof *edges;
    uint64_t state = 5, high, low;
    for (size_t i = 0; i < 100000; i++) {
        uint64_t a = i < count * count ? edges[i / count] : dice_next(&state) >> (state & 63);
        uint64_t b = i < count * count ? edges[i % count] : dice_next(&state) >> (state & 63);
        struct tia_wide p = tia_wide_product(a, b), halves = tia_wide_product_by_halves(a, b);
        paper_product(a, b, &high, &low);
        CHECK(p.high == high && p.low == low);
        CHECK(halves.high == high && halves.low == low);
    }
}

/* Against the processor's own division. */
TEST(quotients_bit_by_bit)
{
    uint64_t state = 7;
    CHECK_EQ(divide_by_bits(UINT64_MAX, 1), UINT64_MAX);
    CHECK_EQ(divide_by_bits(UINT64_MAX, UINT64_MAX), 1);
    CHECK_EQ(divide_by_bits(0, UINT64_MAX), 0);
    for (int i = 0; i < 100000; i++) {
        uint64_t a = dice_next(&state) >> (state & 63), b = (dice_next(&state) >> (state & 63)) | 1;
        CHECK_EQ(divide_by_bits(a, b), a / b);
        CHECK_EQ(divide_by_bits(a, b | UINT64_C(1) << 63), a / (b | UINT64_C(1) << 63));
        CHECK_EQ(divide_by_bits(b, a | 1), b / (a | 1));
    }
}

TEST(products_compared)
{
    uint64_t state = 6;
    CHECK_EQ(tia_cmp_products(UINT64_MAX, UINT64_MAX, UINT64_MAX, UINT64_MAX), 0);
    CHECK_EQ(tia_cmp_products(UINT64_MAX, UINT64_MAX, UINT64_MAX, UINT64_MAX - 1), 1);
    CHECK_EQ(tia_cmp_products(UINT64_MAX - 1, UINT64_MAX, UINT64_MAX, UINT64_MAX), -1);
    CHECK_EQ(tia_cmp_products(0, UINT64_MAX, 0, 1), 0);
    for (int i = 0; i < 100000; i++) {
        /* (n - 1)(n + 1) < n^2, (n - 2)(n + 3) > n^2 for n > 6: apart by 1 in 128 bits */
        uint64_t n = (dice_next(&state) >> (state & 31)) | 8, m = n < UINT64_MAX - 3 ? n : n - 3;
        CHECK_EQ(tia_cmp_products(m - 1, m + 1, m, m), -1);
        CHECK_EQ(tia_cmp_products(m, m, m - 1, m + 1), 1);
        CHECK_EQ(tia_cmp_products(m - 2, m + 3, m, m), 1);
        CHECK_EQ(tia_cmp_products(m, 2 * (m >> 2), m >> 2, m), 1);
        CHECK_EQ(tia_cmp_products(m >> 1, 6, (m >> 1) * 2, 3), 0);
    }
}

/* Expected values are exact to 2^-57, from 70-digit decimal series. */
TEST(cotangent_to_50_bits)
{
    static const struct {
        tia_q16 fov;
        uint64_t cotangent;
    } table[] = {
        {65536, UINT64_C(8256982432371950234)},                                           /* 1 degree */
        {65537, UINT64_C(8256856436344455595)},  {688128, UINT64_C(784197135092244546)},  /* 10.5 */
        {1638400, UINT64_C(325030802180309890)},                                          /* 25 */
        {2184532, UINT64_C(240689281377349826)}, {2949120, UINT64_C(173962420798340297)}, /* 45 */
        {3932160, UINT64_C(124807413944863399)},                                          /* 60 */
        {5898239, UINT64_C(72057613228028560)},  {5898240, UINT64_C(72057594037927936)},  /* 90 */
        {5898241, UINT64_C(72057574847832423)},  {7864320, UINT64_C(41602471314954466)},  /* 120 */
        {8847360, UINT64_C(29847232722484425)},                                           /* 135 */
        {11141119, UINT64_C(6304232267764112)},  {11141120, UINT64_C(6304222599271905)},  /* 170 */
    };
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        double error = (double)(int64_t)(tia_cotangent(table[i].fov) - table[i].cotangent);
        CHECK_MSG(fabs(error) <= (double)table[i].cotangent * 0x1p-50, "fov %d: off by %.0f 2^-56", table[i].fov,
                  error);
    }
    /* Double's own rounding of the angle, 17 times larger in its tangent at 85 degrees, sets the bound here. */
    for (tia_q16 fov = TIA_FOV_MIN; fov <= TIA_FOV_MAX; fov += 97) {
        double want = 1 / tan(fov * (3.14159265358979323846 / (360.0 * 65536)));
        CHECK_MSG(fabs((double)tia_cotangent(fov) * 0x1p-56 / want - 1) < 0x1p-47, "fov %d", fov);
    }
}

int main(void)
{
    RUN(leading_zeros);
    RUN(round_shift_to_nearest_ties_up);
    RUN(square_root_of_64_bits);
    RUN(square_root_of_32_bits);
    RUN(seed_lines);
    RUN(one_over_square_root);
    RUN(reciprocal);
    RUN(normalise);
    RUN(wide_products);
    RUN(quotients_bit_by_bit);
    RUN(products_compared);
    RUN(cotangent_to_50_bits);
    return check_status();
}
