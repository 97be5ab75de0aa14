/* test_halfblocks.c - the text that shows pixels in a terminal, interpreted by a model of a terminal. */
#include <stdlib.h>

#include "check.h"
#include "random.h"
#include "terminal/encode.h"
#include "terminal/terminal_colour.h"
#include "terminal_model.h"

/* ---- colours ---- */

/* Finds the nearest colour by brute force, in a palette that the test's terminal defines. */
static unsigned nearest_of_all(uint32_t c)
{
    unsigned best = 0, best_distance = UINT32_MAX;

    for (unsigned i = 16; i < 256; i++) {
        uint32_t p = model_palette(i);
        int r = (int)(p >> 16) - (int)(c >> 16), g = (int)(p >> 8 & 255) - (int)(c >> 8 & 255);
        int b = (int)(p & 255) - (int)(c & 255);
        unsigned distance = (unsigned)(r * r + g * g + b * b);
        if (distance < best_distance) {
            best_distance = distance;
            best = i;
        }
    }
    return best;
}

static uint32_t expanded(unsigned pixel)
{
    struct rgb8 c = colour_expand((tia_rgb565)pixel);

    return (uint32_t)c.r << 16 | (uint32_t)c.g << 8 | c.b;
}

TEST(colours_expand_by_bit_replication)
{
    CHECK_EQ(expanded(0x0000), 0x000000);
    CHECK_EQ(expanded(0xffff), 0xffffff);
    CHECK_EQ(expanded(0x8410), 0x848284); /* 10000 100000 10000 */
    CHECK_EQ(expanded(0x0841), 0x080808); /* 00001 000010 00001 */
}

TEST(the_nearest_colour_of_256)
{
    for (unsigned p = 0; p < 65536; p++) {
        uint32_t c = expanded(p);
        struct rgb8 rgb = colour_expand((tia_rgb565)p);
        CHECK_MSG(colour_nearest(rgb) == nearest_of_all(c), "%06x: %u, not %u", c, colour_nearest(rgb),
                  nearest_of_all(c));
    }
}

TEST(who_takes_24_bit_colours)
{
    CHECK(colour_is_direct("xterm-256color", "truecolor"));
    CHECK(colour_is_direct(NULL, "24bit"));
    CHECK(colour_is_direct("xterm-direct", NULL));
    CHECK(colour_is_direct("xterm-kitty", ""));
    CHECK(!colour_is_direct("xterm-256color", NULL));
    CHECK(!colour_is_direct("xterm-direct2", NULL));
    CHECK(!colour_is_direct("linux", "yes"));
    CHECK(!colour_is_direct(NULL, NULL));
}

/* ---- pictures ---- */

struct picture {
    unsigned width, height, columns, rows; /* size in pixels, and size of the window in cells */
    tia_rgb565 *pixels;
    struct grid grid;
    struct model model;
};

static struct picture picture_new(unsigned width, unsigned height, unsigned columns, unsigned rows, bool direct)
{
    struct picture p = {width, height, columns, rows, calloc((size_t)width * height, sizeof(tia_rgb565)), {0}, {0}};

    p.grid.direct = direct;
    CHECK_EQ(grid_resize(&p.grid, width, height, columns, rows), TIA_OK);
    p.model = model_new(columns, rows);
    p.model.wrap = false;
    return p;
}

static void picture_free(struct picture *p)
{
    free(p->pixels);
    grid_free(&p->grid);
    model_free(&p->model);
}

/* Draws a frame; returns the number of its bytes. */
static size_t show(struct picture *p)
{
    struct text text = {0};

    grid_draw(&p->grid, p->pixels, p->height, &text);
    CHECK(!text.failed);
    model_feed(&p->model, text.bytes, text.count);
    CHECK_EQ(p->model.unknown, 0);
    CHECK(!p->model.synchronised);
    size_t count = text.count;
    text_free(&text);
    return count;
}

static uint32_t wanted(const struct picture *p, unsigned x, unsigned y)
{
    unsigned left = (p->columns - p->width) / 2, top = (p->rows - (p->height + 1) / 2) / 2 * 2;

    if (x < left || x >= left + p->width || y < top || y >= top + p->height)
        return 0;
    uint32_t c = expanded(p->pixels[(size_t)(y - top) * p->width + x - left]);
    return p->grid.direct ? c : model_palette(nearest_of_all(c));
}

static void check_shown(const struct picture *p)
{
    for (unsigned y = 0; y < 2 * p->rows; y++)
        for (unsigned x = 0; x < p->columns; x++)
            CHECK_MSG(model_pixel(&p->model, x, y) == wanted(p, x, y), "pixel %u,%u is %06x, not %06x", x, y,
                      model_pixel(&p->model, x, y), wanted(p, x, y));
}

/* Changes random pixels, some of them to their present colour. */
static void scribble(struct picture *p, unsigned count)
{
    static const tia_rgb565 few[] = {0xffff, 0x0000, 0xf800, 0x07e0, 0x001f};

    while (count-- > 0) {
        unsigned r = random_u32();
        tia_rgb565 colour = r % 3 == 0 ? (tia_rgb565)random_u32() : few[random_u32() % 5];
        p->pixels[random_u32() % (p->width * p->height)] = colour;
    }
}

static void check_pictures(bool direct)
{
    static const unsigned sizes[][4] = {{1, 1, 1, 1},   {1, 2, 1, 1},   {80, 48, 80, 24}, {79, 47, 80, 24},
                                        {3, 7, 80, 24}, {5, 4, 6, 100}, {300, 10, 300, 5}};

    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        struct picture p = picture_new(sizes[i][0], sizes[i][1], sizes[i][2], sizes[i][3], direct);
        for (unsigned frame = 0; frame < 30; frame++) {
            (void)show(&p);
            check_shown(&p);
            scribble(&p, random_u32() % (p.width * p.height / (1 + frame) + 2));
        }
        picture_free(&p);
    }
}

TEST(pictures_in_24_bit)
{
    check_pictures(true);
}
TEST(pictures_in_256_colours)
{
    check_pictures(false);
}

TEST(a_white_picture_is_drawn_at_first)
{
    struct picture p = picture_new(4, 4, 4, 2, true);

    memset(p.pixels, 0xff, 4 * 4 * sizeof *p.pixels);
    CHECK(show(&p) > 0);
    check_shown(&p);
    picture_free(&p);
}

TEST(only_changes_are_written)
{
    struct picture p = picture_new(80, 48, 80, 24, true);

    (void)show(&p);
    CHECK_EQ(show(&p), 0);
    p.model.printed = 0;
    p.pixels[5 * 80 + 7] = 0xf800;
    p.pixels[30 * 80 + 79] = 0x07e0;
    p.pixels[32 * 80 + 0] = 0x001f;
    (void)show(&p);
    CHECK_EQ(p.model.printed, 3);
    check_shown(&p);
    grid_forget(&p.grid);
    (void)show(&p);
    CHECK_EQ(p.model.printed, 3 + 80 * 24);
    picture_free(&p);
}

/* One colour takes 80 spaces a row, one movement of at most 6 bytes a row, one colour, two brackets. */
TEST(a_plain_picture_is_short)
{
    struct picture p = picture_new(80, 48, 80, 24, true);
    size_t count = show(&p);

    CHECK_MSG(count <= 24 * (80 + 6) + 30, "%zu bytes", count);
    picture_free(&p);
}

int main(void)
{
    RUN(colours_expand_by_bit_replication);
    RUN(the_nearest_colour_of_256);
    RUN(who_takes_24_bit_colours);
    RUN(pictures_in_24_bit);
    RUN(pictures_in_256_colours);
    RUN(a_white_picture_is_drawn_at_first);
    RUN(only_changes_are_written);
    RUN(a_plain_picture_is_short);
    return check_status();
}
