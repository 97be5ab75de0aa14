/* The levels of pictures: sizes and means against sums in double precision, computed here. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "random.h"

#include <tia/mip.h>

#define GUARD 0xa5

/* Returns the mean of a channel over a part of a picture, in texels, of any size. */
static double mean(const uint8_t *texels, int width, int channels, int channel, const double x[2], const double y[2])
{
    double sum = 0;

    for (int j = (int)y[0]; j < y[1]; j++)
        for (int i = (int)x[0]; i < x[1]; i++)
            sum += (fmin(i + 1, x[1]) - fmax(i, x[0])) * (fmin(j + 1, y[1]) - fmax(j, y[0])) *
                   texels[channels * (j * width + i) + channel];
    return sum / ((x[1] - x[0]) * (y[1] - y[0]));
}

static void check_level(const struct tia_texture *t, const uint8_t *from, int width, int height, const uint8_t *to,
                        int half_width, int half_height)
{
    const int channels = t->kind == TIA_OPACITY ? 1 : 3;

    for (int y = 0; y < half_height; y++) {
        for (int x = 0; x < half_width; x++) {
            const double across[2] = {(double)x * width / half_width, (double)(x + 1) * width / half_width};
            const double down[2] = {(double)y * height / half_height, (double)(y + 1) * height / half_height};
            for (int c = 0; c < channels; c++) {
                double want = mean(from, width, channels, c, across, down);
                int got = to[channels * (y * half_width + x) + c];
                CHECK_MSG(fabs(got - want) < 0.5 + 1e-6, "%dx%d of %dx%d, %d %d: %d, not %g", half_width, half_height,
                          t->width, t->height, x, y, got, want);
            }
        }
    }
}

static void check_levels(enum tia_texture_kind kind, int width, int height)
{
    const int channels = kind == TIA_OPACITY ? 1 : 3;
    uint8_t *texels = malloc((size_t)(channels * width * height));
    struct tia_texture t = {.kind = kind, .width = (uint16_t)width, .height = (uint16_t)height, .texels = texels};
    size_t size = tia_mip_size(&t), used = 0;
    uint8_t *levels = malloc(size + 1);

    if (!texels || !levels)
        abort();
    for (int i = 0; i < channels * width * height; i++)
        texels[i] = (uint8_t)(random_double() * 128 + 128);
    levels[size] = GUARD;
    tia_mip_build(&t, levels);
    CHECK_EQ(levels[size], GUARD);
    for (const uint8_t *from = texels; width > 1 || height > 1;) {
        int half_width = width > 1 ? width / 2 : 1, half_height = height > 1 ? height / 2 : 1;
        check_level(&t, from, width, height, levels + used, half_width, half_height);
        from = levels + used;
        used += (size_t)(channels * half_width * half_height);
        width = half_width;
        height = half_height;
    }
    CHECK_EQ(used, size);
    free(texels);
    free(levels);
}

TEST(levels_are_means)
{
    static const int sizes[][2] = {{1, 1}, {2, 2}, {16, 16}, {1, 9}, {7, 1}, {3, 5}, {31, 17}, {100, 64}};

    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        check_levels(TIA_IMAGE, sizes[i][0], sizes[i][1]);
        check_levels(TIA_OPACITY, sizes[i][0], sizes[i][1]);
    }
}

/* 1 + 4 + 16 + ... = (4^n - 1)/3. */
TEST(sizes)
{
    struct tia_texture t = {.kind = TIA_OPACITY, .width = 16384, .height = 16384};

    CHECK_EQ(tia_mip_size(&t), ((UINT32_C(1) << 28) - 1) / 3);
    t.kind = TIA_IMAGE;
    CHECK_EQ(tia_mip_size(&t), (UINT32_C(1) << 28) - 1);
    t.width = t.height = 1;
    CHECK_EQ(tia_mip_size(&t), 0);
}

int main(void)
{
    RUN(levels_are_means);
    RUN(sizes);
    return check_status();
}
