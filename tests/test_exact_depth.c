/* K = height cot(fov/2) of src/exact against cotangents of 560 bits. */
#include "cotangents.h"
#include "exact_balls.h"

static void exact_of_digits(struct exact_number *r, const char *digits, int e)
{
    int length = (int)strlen(digits);

    *r = (struct exact_number){1, (length + 7) / 8, e, {0}};
    for (int i = 0; i < length; i++) {
        char c = digits[length - 1 - i];
        r->m[i / 8] |= (uint32_t)(c <= '9' ? c - '0' : c - 'a' + 10) << 4 * (i % 8);
    }
    exact_trim(r);
}

TEST(depths)
{
    static const uint32_t heights[] = {1, 2, 3, 480, 1080, 8192, 65535};

    EACH_PRECISION(words)
    for (size_t i = 0; i < sizeof cotangents / sizeof *cotangents; i++)
        for (size_t h = 0; h < sizeof heights / sizeof *heights; h++) {
            struct ball k;
            struct exact_number low, high, height, one;
            tia_ball_depth(words, &k, heights[h], cotangents[i].fov);
            exact_of_digits(&low, cotangents[i].digits, -560);
            exact_of(&one, 1, -560);
            exact_sum(&high, &low, &one, 1);
            exact_of(&height, heights[h], 0);
            exact_product(&low, &low, &height);
            exact_product(&high, &high, &height);
            CHECK_MSG(contains(words, &k, &low) && contains(words, &k, &high), "%d words: K for %d is wrong", words,
                      cotangents[i].fov);
            CHECK_MSG(is_normal(words, &k) && is_tight(&k, &nothing, 0, 20000),
                      "%d words: K for %d is off by %x 2^%d, last bit 2^%d", words, cotangents[i].fov, k.radius.m,
                      k.radius.e, k.e);
        }
}

TEST(the_depth_for_90_degrees_is_the_height)
{
    EACH_PRECISION(words)
    {
        struct ball k;
        struct exact_number height;
        tia_ball_depth(words, &k, 480, INT32_C(90) << 16);
        exact_of(&height, 480, 0);
        CHECK(!k.radius.m && contains(words, &k, &height));
    }
}

int main(void)
{
    RUN(depths);
    RUN(the_depth_for_90_degrees_is_the_height);
    return check_status();
}
