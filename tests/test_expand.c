/* Every RGB565 value into every format, against the rule written in a different form: a number of w bits written k
 * times is the number times (2^(wk) - 1) / (2^w - 1). */
#include "check.h"
#include "pixels/expand.h"

/* Returns the upper `length` bits of `value` (w bits) repeated without end. */
static uint32_t rule(uint32_t value, unsigned w, unsigned length)
{
    uint64_t ones = ((UINT64_C(1) << 6 * w) - 1) / ((UINT64_C(1) << w) - 1);

    return (uint32_t)(value * ones >> (6 * w - length));
}

static uint32_t expected(const struct pixel_format *f, uint32_t p)
{
    uint64_t alpha = ((UINT64_C(1) << f->alpha.length) - 1) << f->alpha.offset;

    return rule(p / 2048, 5, f->red.length) << f->red.offset |
           rule(p / 32 % 64, 6, f->green.length) << f->green.offset |
           rule(p % 32, 5, f->blue.length) << f->blue.offset | (uint32_t)alpha;
}

static uint8_t out[65536 * 4 + 16];
static tia_rgb565 all[65536];

/* Returns one pixel as a number, its lowest byte first in memory (`little`) or last. */
static uint32_t pixel_at(const uint8_t *at, unsigned bytes, bool little)
{
    uint32_t p = 0;

    for (unsigned i = 0; i < bytes; i++)
        p |= (uint32_t)at[little ? i : bytes - 1 - i] << 8 * i;
    return p;
}

static bool host_is_little(void)
{
    const uint16_t one = 1;

    return *(const uint8_t *)&one == 1;
}

static void check_format(const struct pixel_format *f)
{
    struct expander e;
    unsigned bytes = pixel_bytes(f), wrong = 0;
    char name[PIXEL_NAME];

    CHECK_MSG(!pixel_fault(f), "%s: %s", pixel_name(f, name), pixel_fault(f));
    memset(out, 0xa5, sizeof out);
    expander_init(&e, f);
    expand_row(&e, out, all, 65536);
    for (uint32_t p = 0; p < 65536; p++)
        wrong += pixel_at(out + p * bytes, bytes, host_is_little() != f->swapped) != expected(f, p);
    CHECK_MSG(wrong == 0, "%s: %u values are wrong", pixel_name(f, name), wrong);
    for (unsigned i = 0; i < 16; i++)
        CHECK_EQ(out[65536 * bytes + i], 0xa5);
}

TEST(every_value_in_every_format)
{
    static const struct pixel_format formats[] = {
        {16, false, {11, 5}, {5, 6}, {0, 5}, {0, 0}},      {16, false, {0, 5}, {5, 6}, {11, 5}, {0, 0}},
        {15, false, {10, 5}, {5, 5}, {0, 5}, {15, 1}},     {16, false, {10, 5}, {5, 5}, {0, 5}, {0, 0}},
        {16, false, {8, 4}, {4, 4}, {0, 4}, {12, 4}},      {24, false, {16, 8}, {8, 8}, {0, 8}, {0, 0}},
        {24, false, {0, 8}, {8, 8}, {16, 8}, {0, 0}},      {32, false, {16, 8}, {8, 8}, {0, 8}, {0, 0}},
        {32, false, {16, 8}, {8, 8}, {0, 8}, {24, 8}},     {32, false, {24, 8}, {16, 8}, {8, 8}, {0, 8}},
        {32, false, {20, 10}, {10, 10}, {0, 10}, {30, 2}}, {32, false, {21, 11}, {10, 11}, {0, 10}, {0, 0}},
    };

    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++) {
        struct pixel_format swapped = formats[i];
        swapped.swapped = true;
        check_format(&formats[i]);
        check_format(&swapped);
    }
}

/* Full, black and the lowest bit of each channel, as in the documentation of the VGA and of the DRM formats. */
TEST(known_values)
{
    static const tia_rgb565 in[] = {0xffff, 0x0000, 0xf800, 0x07e0, 0x001f, 0x0800, 0x0020, 0x0001, 0x8410};
    static const uint32_t want[] = {0xffffff, 0x000000, 0xff0000, 0x00ff00, 0x0000ff,
                                    0x080000, 0x000400, 0x000008, 0x848284};
    struct expander e;
    uint32_t got[9];

    expander_init(&e, &pixel_xrgb8888);
    expand_row(&e, got, in, 9);
    for (int i = 0; i < 9; i++)
        CHECK_EQ(got[i], want[i]);
}

TEST(names)
{
    const struct pixel_format odd = {32, false, {0, 10}, {10, 10}, {20, 10}, {0, 0}};
    char t[PIXEL_NAME];

    CHECK(strcmp(pixel_name(&pixel_rgb565, t), "RGB565") == 0);
    CHECK(strcmp(pixel_name(&pixel_bgr565, t), "BGR565") == 0);
    CHECK(strcmp(pixel_name(&pixel_xrgb8888, t), "XRGB8888") == 0);
    CHECK(strcmp(pixel_name(&pixel_xbgr8888, t), "XBGR8888") == 0);
    CHECK(strcmp(pixel_name(&odd, t), "32 bit r10@0 g10@10 b10@20") == 0);
}

TEST(impossible_formats_are_refused)
{
    static const struct pixel_format bad[] = {
        {8, false, {5, 3}, {2, 3}, {0, 2}, {0, 0}},    {16, false, {12, 5}, {5, 6}, {0, 5}, {0, 0}},
        {16, false, {11, 5}, {5, 6}, {0, 6}, {0, 0}},  {32, false, {16, 8}, {8, 8}, {0, 0}, {0, 0}},
        {32, false, {16, 8}, {8, 8}, {0, 8}, {25, 8}}, {0, false, {0, 0}, {0, 0}, {0, 0}, {0, 0}},
    };

    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        CHECK_MSG(pixel_fault(&bad[i]), "format %zu is accepted", i);
}

int main(void)
{
    for (uint32_t p = 0; p < 65536; p++)
        all[p] = (tia_rgb565)p;
    RUN(every_value_in_every_format);
    RUN(known_values);
    RUN(names);
    RUN(impossible_formats_are_refused);
    return check_status();
}
