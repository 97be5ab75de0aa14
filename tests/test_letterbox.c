/* The command's letterbox around the strict memory display: position, border, rotation, tiles, checksum; and its
 * statistics. The command is a program: its files are in no library, and are included here. */

#include "common/crc_join.h"
#include "tia/label.c"
#include "tia/letterbox.c"
#include "tia/rotate.c"
#include "tia/stats.c"

#include <signal.h>
#include <tia/debug.h>

#include "check.h"
#include "memory/memory.h"
#include "random.h"

enum { WIDTH = 23, HEIGHT = 17, EDGE = 1, TALL = 8192 };

/* The screen, and around it a border of pixels that must not change. */
static tia_rgb565 pixels[HEIGHT + 2 * EDGE][WIDTH + 2 * EDGE];
static struct port_memory screen;
static struct letterbox letterbox;
static struct tia_mode mode;
static char why[PORT_WHY];

static const tia_rgb565 UNTOUCHED = 0xdead;

static void clear(void)
{
    for (unsigned y = 0; y < HEIGHT + 2 * EDGE; y++)
        for (unsigned x = 0; x < WIDTH + 2 * EDGE; x++)
            pixels[y][x] = UNTOUCHED;
}

static int open_stage(uint16_t width, uint16_t height, unsigned degrees, bool checksum)
{
    clear();
    why[0] = '\0';
    screen = (struct port_memory){.surface = {&pixels[EDGE][EDGE], 2, sizeof pixels[0]},
                                  .width = WIDTH,
                                  .height = HEIGHT,
                                  .tile_width = screen.tile_width,
                                  .tile_height = screen.tile_height,
                                  .concurrent = true};
    letterbox = (struct letterbox){.screen = &port_memory_display,
                                   .screen_ctx = &screen,
                                   .name = "memory",
                                   .width = width,
                                   .height = height,
                                   .degrees = degrees,
                                   .checksum = checksum,
                                   .why = why};
    return letterbox_display.open(&letterbox, &mode);
}

/* Returns a pixel that encodes its position in the picture; never black. */
static tia_rgb565 pixel_at(unsigned x, unsigned y)
{
    return (tia_rgb565)(0x8000u | x << 7 | y);
}

static int draw_tile(struct tia_tile tile)
{
    struct tia_surface surface;
    int status = letterbox_display.acquire(&letterbox, tile, &surface);
    for (unsigned y = 0; y < tile.height && !status; y++) {
        for (unsigned x = 0; x < tile.width; x++) {
            char *at = (char *)surface.pixels + (ptrdiff_t)y * surface.pitch + (ptrdiff_t)x * surface.step;
            *(tia_rgb565 *)(void *)at = pixel_at(tile.x + x, tile.y + y);
        }
    }
    return !status ? letterbox_display.submit(&letterbox, tile) : status;
}

/* Draws a frame in the largest tiles that the mode allows. */
static int draw_picture(void)
{
    int status = letterbox_display.mode(&letterbox, &mode);
    uint16_t width = mode.tile_width != 0 ? mode.tile_width : mode.width;
    uint16_t height = mode.tile_height != 0 ? mode.tile_height : mode.height;
    for (unsigned y = 0; y < mode.height; y += height) {
        for (unsigned x = 0; x < mode.width && !status; x += width) {
            struct tia_tile tile = {(uint16_t)x, (uint16_t)y, width, height};
            tile.width = (uint16_t)(mode.width - x < width ? mode.width - x : width);
            tile.height = (uint16_t)(mode.height - y < height ? mode.height - y : height);
            status = draw_tile(tile);
        }
    }
    return !status ? letterbox_display.present(&letterbox) : status;
}

/* Returns the screen's pixel at (x, y), by definition: the picture, rotated clockwise, in the middle, an odd pixel more
 * on the right and below. */
static tia_rgb565 expected_at(int x, int y, int width, int height, unsigned degrees)
{
    int turned_width = degrees % 180 ? height : width, turned_height = degrees % 180 ? width : height;
    int u = x - (WIDTH - turned_width) / 2, v = y - (HEIGHT - turned_height) / 2;
    if (u < 0 || v < 0 || u >= turned_width || v >= turned_height)
        return 0;
    switch (degrees) {
    case 90:
        return pixel_at((unsigned)v, (unsigned)(height - 1 - u));
    case 180:
        return pixel_at((unsigned)(width - 1 - u), (unsigned)(height - 1 - v));
    case 270:
        return pixel_at((unsigned)(width - 1 - v), (unsigned)u);
    default:
        return pixel_at((unsigned)u, (unsigned)v);
    }
}

/* The label "7-z": dots of a pixel, and a black border. */
static const char *const label[9] = {"...................", ".#####.............", ".....#.............",
                                     "....#........#####.", "...#...#####....#..", "..#............#...",
                                     "..#...........#....", "..#..........#####.", "..................."};

/* Returns the colour that is shown where pixel_at returns `pixel`: the label's if the label covers it. */
static tia_rgb565 with_label(tia_rgb565 pixel)
{
    unsigned x = pixel >> 7 & 127, y = pixel & 127;
    if (letterbox.label[0] == '\0' || pixel == 0 || x >= 19 || y >= 9)
        return pixel;
    return label[y][x] == '#' ? 0xffff : 0;
}

static void check_screen(int width, int height, unsigned degrees)
{
    for (int y = -EDGE; y < HEIGHT + EDGE; y++) {
        for (int x = -EDGE; x < WIDTH + EDGE; x++) {
            bool inside = x >= 0 && y >= 0 && x < WIDTH && y < HEIGHT;
            tia_rgb565 want = inside ? with_label(expected_at(x, y, width, height, degrees)) : UNTOUCHED;
            tia_rgb565 got = pixels[y + EDGE][x + EDGE];
            CHECK_MSG(got == want, "%dx%d turned by %u: pixel (%d, %d) is %04x, not %04x", width, height, degrees, x, y,
                      got, want);
        }
    }
}

/* Computes a CRC bit by bit, from the polynomial alone. */
static uint32_t slow_crc(uint32_t crc, const unsigned char *bytes, size_t count)
{
    crc = ~crc;
    for (size_t i = 0; i < count * 8; i++) {
        uint32_t bit = (crc ^ (uint32_t)bytes[i / 8] >> i % 8) & 1u;
        crc = crc >> 1 ^ (bit ? 0xedb88320u : 0u);
    }
    return ~crc;
}

static uint32_t crc_of_picture(int width, int height, unsigned degrees)
{
    int turned_width = degrees % 180 ? height : width, turned_height = degrees % 180 ? width : height;
    uint32_t crc = 0;
    for (int y = 0; y < turned_height; y++) {
        for (int x = 0; x < turned_width; x++) {
            tia_rgb565 pixel =
                expected_at(x + (WIDTH - turned_width) / 2, y + (HEIGHT - turned_height) / 2, width, height, degrees);
            unsigned char bytes[2] = {(unsigned char)(pixel & 255u), (unsigned char)(pixel >> 8)};
            crc = slow_crc(crc, bytes, 2);
        }
    }
    return crc;
}

static void every_turn(uint16_t width, uint16_t height)
{
    for (unsigned degrees = 0; degrees < 360; degrees += 90) {
        for (int checksum = 0; checksum < 2; checksum++) {
            CHECK_EQ(open_stage(width, height, degrees, checksum != 0), TIA_OK);
            CHECK_EQ(mode.width, width);
            CHECK_EQ(mode.height, height);
            for (unsigned frame = 0; frame < 2; frame++) {
                clear();
                CHECK_EQ(draw_picture(), TIA_OK);
                check_screen(width, height, degrees);
                CHECK_EQ(screen.frames, frame + 1);
            }
            CHECK(checksum == 0 || letterbox.crc == crc_of_picture(width, height, degrees));
            letterbox_display.close(&letterbox);
        }
    }
}

TEST(a_smaller_picture_is_centred_on_black)
{
    screen.tile_width = screen.tile_height = 0;
    every_turn(8, 6);
    every_turn(17, 17);
    every_turn(1, 1);
}

TEST(tiles_keep_the_screens_limits)
{
    screen.tile_width = 5;
    screen.tile_height = 3;
    every_turn(16, 7);
    CHECK_EQ(open_stage(8, 6, 90, false), TIA_OK);
    CHECK_EQ(mode.tile_width, 3);
    CHECK_EQ(mode.tile_height, 5);
    letterbox_display.close(&letterbox);
    screen.tile_width = screen.tile_height = 0;
}

/* A label is drawn at the picture's own corner, cut off where it does not fit, and is not in the checksum. */
TEST(labels)
{
    for (unsigned degrees = 0; degrees < 360; degrees += 90)
        for (unsigned i = 0; i < 8; i++) {
            const bool small = i & 1, limited = i & 2;
            screen.tile_width = limited ? 5 : 0;
            screen.tile_height = limited ? 3 : 0;
            CHECK_EQ(open_stage(small ? 8 : 16, small ? 6 : 15, degrees, i & 4), TIA_OK);
            (void)strcpy(letterbox.label, "7-z");
            CHECK_EQ(draw_picture(), TIA_OK);
            check_screen(small ? 8 : 16, small ? 6 : 15, degrees);
            CHECK(!(i & 4) || letterbox.crc == crc_of_picture(small ? 8 : 16, small ? 6 : 15, degrees));
            letterbox_display.close(&letterbox);
        }
    screen.tile_width = screen.tile_height = 0;
}

/* From 640 rows on letters grow with the picture. */
TEST(large_labels)
{
    for (unsigned scale = 1; scale < 8; scale++)
        CHECK_EQ(label_text("7-z", 320 * scale + 7).scale, scale);
}

TEST(the_default_is_the_whole_screen)
{
    for (unsigned degrees = 0; degrees < 360; degrees += 90) {
        bool swaps = degrees % 180 != 0;
        CHECK_EQ(open_stage(0, 0, degrees, true), TIA_OK);
        CHECK_EQ(mode.width, swaps ? HEIGHT : WIDTH);
        CHECK_EQ(mode.height, swaps ? WIDTH : HEIGHT);
        CHECK(mode.concurrent);
        CHECK_EQ(draw_picture(), TIA_OK);
        check_screen(mode.width, mode.height, degrees);
        letterbox_display.close(&letterbox);
        CHECK(!screen.is_open);
    }
}

TEST(a_larger_picture_is_refused)
{
    CHECK_EQ(open_stage(WIDTH + 1, HEIGHT, 0, false), TIA_ERR_UNSUPPORTED);
    CHECK_MSG(strstr(why, "24x17") && strstr(why, "23x17"), "said '%s'", why);
    CHECK(!screen.is_open && letterbox.opened);
    letterbox_display.close(&letterbox);
    CHECK_EQ(open_stage(WIDTH, HEIGHT, 90, false), TIA_ERR_UNSUPPORTED);
    letterbox_display.close(&letterbox);
}

TEST(a_failed_open_is_passed_on)
{
    CHECK_EQ(open_stage(0, 0, 0, true), TIA_OK);
    letterbox_display.close(&letterbox);
    screen.fail_open = TIA_ERR_DEVICE;
    letterbox = (struct letterbox){.screen = &port_memory_display, .screen_ctx = &screen, .name = "memory", .why = why};
    CHECK_EQ(letterbox_display.open(&letterbox, &mode), TIA_ERR_DEVICE);
    CHECK(!letterbox.opened);
    letterbox_display.close(&letterbox);
    letterbox_display.close(&letterbox);
    screen.fail_open = 0;
}

TEST(a_screen_may_change_its_size)
{
    CHECK_EQ(open_stage(8, 6, 0, true), TIA_OK);
    screen.width = 7;
    CHECK_EQ(letterbox_display.mode(&letterbox, &mode), TIA_HIDDEN);
    CHECK_EQ(letterbox_display.mode(&letterbox, &mode), TIA_HIDDEN);
    screen.width = WIDTH;
    CHECK_EQ(draw_picture(), TIA_OK);
    check_screen(8, 6, 0);
    screen.hidden = true;
    CHECK_EQ(letterbox_display.mode(&letterbox, &mode), TIA_HIDDEN);
    letterbox_display.close(&letterbox);

    CHECK_EQ(open_stage(0, 0, 90, true), TIA_OK);
    screen.width = 9;
    screen.height = 5;
    CHECK_EQ(letterbox_display.mode(&letterbox, &mode), TIA_OK);
    CHECK_EQ(mode.width, 5);
    CHECK_EQ(mode.height, 9);
    CHECK_EQ(draw_picture(), TIA_OK);
    letterbox_display.close(&letterbox);
}

TEST(checksums_join)
{
    unsigned char bytes[3000];
    for (size_t i = 0; i < sizeof bytes; i++)
        bytes[i] = (unsigned char)random_bits();
    CHECK_EQ(slow_crc(0, (const unsigned char *)"123456789", 9), 0xcbf43926u);
    uint32_t whole = slow_crc(0, bytes, sizeof bytes);
    for (size_t cut = 0; cut <= sizeof bytes; cut += 125) {
        uint32_t first = slow_crc(0, bytes, cut), second = slow_crc(0, bytes + cut, sizeof bytes - cut);
        CHECK_EQ(crc_join(first, second, sizeof bytes - cut), whole);
    }
}

/* A signal ends the checksum of a tall picture, which the screen then does not show. */
TEST(a_signal_ends_a_checksum)
{
    static tia_rgb565 column[TALL];
    struct port_memory tall = {.surface = {column, 2, 2}, .width = 1, .height = TALL};

    letterbox = (struct letterbox){
        .screen = &port_memory_display, .screen_ctx = &tall, .name = "memory", .checksum = true, .why = why};
    CHECK_EQ(letterbox_display.open(&letterbox, &mode), TIA_OK);
    CHECK_EQ(draw_picture(), TIA_OK);
    const uint32_t crc = letterbox.crc;
    CHECK_EQ(crc, tia_crc32(0, letterbox.frame, TALL));
    (void)signal(SIGTERM, SIG_DFL); /* if the signal is ignored, it must stay so */
    signals_prepare();
    signals_catch_waiting();
    (void)raise(SIGTERM);
    CHECK_EQ(letterbox_display.present(&letterbox), TIA_STOPPED);
    CHECK_EQ(letterbox.crc, crc);
    letterbox_display.close(&letterbox);
}

/* A percentile is the nearest rank: the smallest sample that p % of them do not exceed. */
TEST(percentiles)
{
    static struct samples samples;
    CHECK_EQ(stats_percentile(&samples, 50), 0);
    stats_add(&samples, 7);
    CHECK_EQ(stats_percentile(&samples, 50), 7);
    CHECK_EQ(stats_percentile(&samples, 95), 7);
    samples.count = 0;
    for (uint64_t i = 100; i > 0; i--)
        stats_add(&samples, i);
    CHECK_EQ(stats_percentile(&samples, 50), 50);
    CHECK_EQ(stats_percentile(&samples, 95), 95);
    stats_add(&samples, UINT64_MAX);
    CHECK_EQ(stats_percentile(&samples, 50), 51);
    CHECK_EQ(stats_percentile(&samples, 95), 96);
    CHECK_EQ(stats_percentile(&samples, 100), UINT32_MAX);
    for (unsigned i = 0; i < STATS_SAMPLES; i++)
        stats_add(&samples, 9);
    CHECK_EQ(stats_percentile(&samples, 100), 9);
}

int main(void)
{
    RUN(a_smaller_picture_is_centred_on_black);
    RUN(tiles_keep_the_screens_limits);
    RUN(labels);
    RUN(large_labels);
    RUN(the_default_is_the_whole_screen);
    RUN(a_larger_picture_is_refused);
    RUN(a_failed_open_is_passed_on);
    RUN(a_screen_may_change_its_size);
    RUN(checksums_join);
    RUN(percentiles);
    RUN(a_signal_ends_a_checksum);
    return check_status();
}
