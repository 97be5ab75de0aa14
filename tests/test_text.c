/* tia_text_draw: letters against drawings by hand, in any tiles and sizes. */
#include <string.h>
#include <tia/text.h>

#include "check.h"

enum { WIDTH = 80, HEIGHT = 40 };

static tia_rgb565 pixels[HEIGHT][WIDTH];

static void draw(const struct tia_text *text, unsigned tile_width, unsigned tile_height)
{
    for (unsigned i = 0; i < WIDTH * HEIGHT; i++)
        pixels[i / WIDTH][i % WIDTH] = 7;
    for (unsigned y = 0; y < HEIGHT; y += tile_height)
        for (unsigned x = 0; x < WIDTH; x += tile_width) {
            struct tia_tile tile = {(uint16_t)x, (uint16_t)y, (uint16_t)tile_width, (uint16_t)tile_height};
            struct tia_surface surface = {.pixels = &pixels[y][x], .step = 2, .pitch = 2 * WIDTH};
            tia_text_draw(text, tile, &surface);
        }
}

/* "A g" above "-_", with the border: # is ink, . paper. */
static const char *const paper[17] = {
    "...................", "..###..............", ".#...#.............", ".#...#........####.", ".#####.......#...#.",
    ".#...#.......#...#.", ".#...#........####.", ".#...#...........#.", "..............###..", "...................",
    "...................", "...................", ".#####.............", "...................", "...................",
    "...................", ".......#####.......",
};

static void check_paper(const struct tia_text *text)
{
    for (unsigned y = 0; y < HEIGHT; y++)
        for (unsigned x = 0; x < WIDTH; x++) {
            unsigned column = (x - text->x) / text->scale, row = (y - text->y) / text->scale;
            bool covered = x >= text->x && y >= text->y && column < 19 && row < 17;
            tia_rgb565 want = !covered ? 7 : paper[row][column] == '#' ? 0xffff : 0;
            CHECK_MSG(pixels[y][x] == want, "scale %u, pixel %u, %u is %04x", text->scale, x, y, pixels[y][x]);
        }
}

TEST(lines_tiles_and_sizes)
{
    struct tia_text text = {"A g\n-_", 3, 2, 1, 0xffff, 0};

    draw(&text, WIDTH, HEIGHT);
    check_paper(&text);
    draw(&text, 5, 4);
    check_paper(&text);
    text.scale = 2;
    draw(&text, 16, 8);
    check_paper(&text);
}

TEST(what_it_covers)
{
    struct tia_text text = {"A g\n-_", 3, 2, 2, 0xffff, 0};
    struct tia_tile all = tia_text_area(&text, 1000, 1000), cut = tia_text_area(&text, 10, 20);

    CHECK(all.x == 3 && all.y == 2 && all.width == 38 && all.height == 34);
    CHECK(cut.x == 3 && cut.y == 2 && cut.width == 7 && cut.height == 18);
    CHECK_EQ(tia_text_area(&text, 3, 20).width, 0);
}

/* Printable characters differ and stay within five columns; other characters are blank. */
TEST(all_of_ascii)
{
    static tia_rgb565 seen[95][8][6];
    char letter[2] = "?";

    for (unsigned i = 0; i < 95; i++) {
        struct tia_text text = {letter, 0, 0, 1, 1, 0};
        letter[0] = (char)(' ' + i);
        draw(&text, WIDTH, HEIGHT);
        unsigned ink = 0;
        for (unsigned y = 0; y < 9; y++)
            for (unsigned x = 0; x < 7; x++) {
                CHECK(pixels[y][x] == 0 || (x > 0 && x < 6 && y > 0));
                ink += pixels[y][x];
                if (x > 0 && y > 0)
                    seen[i][y - 1][x - 1] = pixels[y][x];
            }
        CHECK_MSG((ink > 0) == (i > 0), "letter %s", letter);
        for (unsigned j = 0; j < i; j++)
            CHECK_MSG(memcmp(seen[i], seen[j], sizeof seen[i]) != 0, "letter %s is that of number %u", letter, j);
    }
    letter[0] = '\x80';
    draw(&(struct tia_text){letter, 0, 0, 1, 1, 0}, WIDTH, HEIGHT);
    for (unsigned y = 0; y < 9; y++)
        for (unsigned x = 0; x < 7; x++)
            CHECK_EQ(pixels[y][x], 0);
}

int main(void)
{
    RUN(lines_tiles_and_sizes);
    RUN(what_it_covers);
    RUN(all_of_ascii);
    return check_status();
}
