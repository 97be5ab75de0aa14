/* exhaustive.c - every argument of the integer kernels with 32-bit arguments, and for the 64-bit root r^2 - 1, r^2 and
 * r^2 + 2r for every 32-bit r. Ten minutes; `make check-exhaustive`. */
#include "check.h"
#include "sweeps.h"

static void report(const char *kernel, struct sweep_range range)
{
    printf("# %s: %.4g to %.4g\n", kernel, range.low, range.high);
}

TEST(square_root_at_all_squares)
{
    CHECK_MSG(sweep_sqrt64_squares(1, 1) == 0, "wrong near %" PRIu64 "^2", sweep_bad);
}

TEST(square_root_of_all_32_bit_numbers)
{
    CHECK_MSG(sweep_sqrt64_small(0, 1) == 0, "wrong for %" PRIu64, sweep_bad);
}

TEST(square_root_of_400_million_random_numbers)
{
    CHECK_MSG(sweep_sqrt64_random(1, 400000000) == 0, "wrong for %" PRIu64, sweep_bad);
}

TEST(small_square_root_of_all_numbers)
{
    CHECK_MSG(sweep_sqrt32(0, 1) == 0, "wrong for %" PRIu64, sweep_bad);
}

TEST(seeds_of_all_numbers)
{
    struct sweep_range relative = {0, 0};
    CHECK_MSG(sweep_rsqrt_seed(0, 1, &relative) == 0, "off at %" PRIu64, sweep_bad);
    report("1/sqrt seed, relative", relative);
    relative = (struct sweep_range){0, 0};
    CHECK_MSG(sweep_reciprocal_seed(0, 1, &relative) == 0, "off at %" PRIu64, sweep_bad);
    report("reciprocal seed, relative", relative);
}

TEST(one_over_square_root_of_all_numbers)
{
    struct sweep_range ulp = {0, 0};
    CHECK_MSG(sweep_rsqrt(0, 1, &ulp) == 0, "off at %" PRIu64, sweep_bad);
    report("1/sqrt, ulp of Q1.31", ulp);
}

TEST(reciprocal_of_all_numbers)
{
    struct sweep_range ulp = {0, 0};
    CHECK_MSG(sweep_reciprocal(0, 1, &ulp) == 0, "off at %" PRIu64, sweep_bad);
    report("reciprocal, ulp", ulp);
}

TEST(leading_zeros_of_all_numbers)
{
    CHECK_MSG(sweep_clz32(1, 1) == 0, "wrong for %" PRIu64, sweep_bad);
}

TEST(normalise_200_million_random_vectors)
{
    struct sweep_range ulp = {0, 0};
    CHECK_MSG(sweep_normalise(11, 200000000, &ulp) == 0, "off for %" PRIx64, sweep_bad);
    report("normalise, ulp of Q2.30", ulp);
}

int main(void)
{
    RUN(square_root_at_all_squares);
    RUN(square_root_of_all_32_bit_numbers);
    RUN(square_root_of_400_million_random_numbers);
    RUN(small_square_root_of_all_numbers);
    RUN(seeds_of_all_numbers);
    RUN(one_over_square_root_of_all_numbers);
    RUN(reciprocal_of_all_numbers);
    RUN(leading_zeros_of_all_numbers);
    RUN(normalise_200_million_random_vectors);
    return check_status();
}
