/* Quantising: plain and with Bayer's matrix, which is built here by its recursion. */
#include "check.h"
#include "random.h"
#include "render/core/dither.h"

static unsigned matrix[8][8]; /* index: row, column */

/* M(1) = [0], M(2n) = [4M, 4M + 2; 4M + 3, 4M + 1]. */
static void build_matrix(void)
{
    matrix[0][0] = 0;
    for (unsigned n = 1; n < 8; n *= 2)
        for (unsigned y = 0; y < n; y++)
            for (unsigned x = 0; x < n; x++) {
                unsigned entry = 4 * matrix[y][x];
                matrix[y][x] = entry;
                matrix[y][x + n] = entry + 2;
                matrix[y + n][x] = entry + 3;
                matrix[y + n][x + n] = entry + 1;
            }
}

TEST(matrix_by_its_recursion)
{
    static const unsigned known[4][4] = {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};
    unsigned seen[64] = {0};

    for (unsigned y = 0; y < 8; y++)
        for (unsigned x = 0; x < 8; x++) {
            seen[matrix[y][x]]++;
            if (x < 4 && y < 4) /* M(4) as textbooks print it */
                CHECK_EQ(matrix[y][x] / 4, known[y][x]);
        }
    for (unsigned i = 0; i < 64; i++)
        CHECK_EQ(seen[i], 1);
}

/* Thresholds are (n + 1/2)/64, in units of 2^-30: never 0 or 1, one half on average. */
TEST(thresholds)
{
    for (int y = 0; y < 20; y++) {
        num_u dithered[8], plain[8];
        dither_thresholds(true, y, dithered);
        dither_thresholds(false, y, plain);
        for (int x = 0; x < 8; x++) {
            CHECK_EQ(dithered[x], (2 * (int64_t)matrix[y % 8][x] + 1) * TIA_Q30_ONE / 128);
            CHECK_EQ(plain[x], TIA_Q30_ONE / 2);
        }
    }
}

#define W 24
#define H 17

static tia_rgb565 picture[H][W];

/* Draws only a background. */
static void draw_flat(struct tia_rgb colour, bool dither)
{
    static uint64_t view_memory[1000], hits_memory[1000];
    struct tia_scene scene = {.camera = {{0, 0, 0}, TIA_Q16(25)}, .background = colour};
    struct tia_surface surface = {.pixels = picture[0], .step = sizeof(tia_rgb565), .pitch = sizeof picture[0]};
    struct tia_options options = {.dither = dither};
    struct tia_tile tile = {0, 0, W, H};
    struct tia_view *view = NULL;
    struct tia_hits *hits = NULL;

    CHECK_EQ(tia_view_init(&view, view_memory, sizeof view_memory, &scene, 0, W, H, NULL), TIA_OK);
    CHECK_EQ(tia_hits_init(&hits, hits_memory, sizeof hits_memory, view, tile), TIA_OK);
    CHECK_EQ(tia_view_draw(view, hits, tile, &surface, &options), TIA_OK);
}

static unsigned channel(tia_rgb565 pixel, int c)
{
    return c == 0 ? pixel >> 11 : c == 1 ? pixel >> 5 & 63 : pixel & 31;
}

/* Returns floor(levels c + offset/128) for a colour with unit 2^-30, exactly. */
static unsigned quantised(tia_q30 c, int which, unsigned offset)
{
    uint64_t levels = which == 1 ? 63 : 31;
    return (unsigned)((levels * (uint64_t)c * 128 + ((uint64_t)offset << 30)) >> 37);
}

/* Checks each pixel by the matrix, and that the mean of a block is the colour to the nearest 64th of a level: by
 * Hermite's identity the 64 pixels add up to floor(64 levels c + 1/2). */
static void check_dithered(struct tia_rgb colour)
{
    const tia_q30 channels[3] = {colour.r, colour.g, colour.b};

    draw_flat(colour, true);
    for (int c = 0; c < 3; c++) {
        unsigned sum = 0;
        for (unsigned y = 0; y < H; y++)
            for (unsigned x = 0; x < W; x++) {
                unsigned offset = 2 * matrix[y % 8][x % 8] + 1;
                CHECK_EQ(channel(picture[y][x], c), quantised(channels[c], c, offset));
                sum += x >= 3 && x < 11 && y >= 6 && y < 14 ? channel(picture[y][x], c) : 0;
            }
        int64_t off = (int64_t)sum * TIA_Q30_ONE - (c == 1 ? 63 : 31) * (int64_t)channels[c] * 64;
        CHECK(off <= TIA_Q30_ONE / 2 && -off <= TIA_Q30_ONE / 2);
    }
}

TEST(a_dithered_colour_is_right_on_average)
{
    check_dithered((struct tia_rgb){0, 0, 0});
    check_dithered((struct tia_rgb){TIA_Q30_ONE, TIA_Q30_ONE, TIA_Q30_ONE});
    check_dithered((struct tia_rgb){TIA_Q30_ONE - 1, 1, TIA_Q30_ONE / 2});
    for (int i = 0; i < 300; i++) {
        tia_q30 c[3];
        for (int k = 0; k < 3; k++)
            c[k] = (tia_q30)(random_u32() >> 2);
        check_dithered((struct tia_rgb){c[0], i % 3 ? c[1] : c[0], i % 3 ? c[2] : c[0]}); /* one colour in three is
                                                                                             grey */
    }
}

/* The smallest Q2.30 colour whose level is k is the first not below (k - 1/2)/levels. */
TEST(plain_levels_change_where_they_should)
{
    for (unsigned k = 1; k < 64; k++) {
        tia_q30 green = (tia_q30)(((2 * k - 1) * (int64_t)TIA_Q30_ONE + 125) / 126), red = 0;
        if (k < 32)
            red = (tia_q30)(((2 * k - 1) * (int64_t)TIA_Q30_ONE + 61) / 62);
        draw_flat((struct tia_rgb){red, green, red}, false);
        CHECK_EQ(picture[3][5], (k < 32 ? k : 0) << 11 | k << 5 | (k < 32 ? k : 0));
        draw_flat((struct tia_rgb){red, green - 1, red ? red - 1 : 0}, false);
        CHECK_EQ(picture[H - 1][W - 1], (k < 32 ? k : 0) << 11 | (k - 1) << 5 | (k < 32 ? k - 1 : 0));
    }
}

int main(void)
{
    build_matrix();
    RUN(matrix_by_its_recursion);
    RUN(thresholds);
    RUN(a_dithered_colour_is_right_on_average);
    RUN(plain_levels_change_where_they_should);
    return check_status();
}
