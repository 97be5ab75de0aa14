/* tia_view_compare: what a display shows against what is drawn again. */
#include <tia/tia.h>
#include <tia/trust.h>

#include "check.h"

enum { WIDTH = 64, HEIGHT = 48 };

static uint64_t view_memory[320], hits_memory[WIDTH + 16];
static struct tia_seal seal;
static const struct tia_sealed sealed = {.view = view_memory,
                                         .view_size = sizeof view_memory,
                                         .hits = hits_memory,
                                         .hits_size = sizeof hits_memory,
                                         .seal = &seal};
static tia_rgb565 rows[2 * WIDTH];

/* A display's own memory. */
struct shown {
    tia_rgb565 memory[HEIGHT][WIDTH];
    int fails_at, breaks_at; /* rows: reading fails, or changes the view */
    unsigned rows;
};

static struct shown shown;

static int read_row(void *ctx, struct tia_tile tile, tia_rgb565 *pixels)
{
    struct shown *display = ctx;

    if (tile.height != 1 || tile.y == display->fails_at)
        return TIA_ERR_DEVICE;
    display->rows++;
    if (tile.y == display->breaks_at)
        ((unsigned char *)view_memory)[sizeof view_memory - 1] ^= 1;
    memcpy(pixels, &display->memory[tile.y][tile.x], 2 * (size_t)tile.width);
    return TIA_OK;
}

static const struct tia_readback readback = {read_row, &shown};

static void show(bool dither)
{
    const struct tia_options options = {.dither = dither};
    struct tia_view *view;

    shown.fails_at = shown.breaks_at = -1;
    CHECK_EQ(tia_view_init(&view, view_memory, sizeof view_memory, &tia_thesis_scene, 1, WIDTH, HEIGHT, NULL), TIA_OK);
    CHECK_EQ(tia_view_set_lights(view, &tia_thesis_scene.bindings[0].state, 1), TIA_OK);
    CHECK_EQ(tia_view_seal(&sealed), TIA_OK);
    for (uint16_t y = 0; y < HEIGHT; y++) {
        const struct tia_surface surface = {.pixels = shown.memory[y], .step = 2, .pitch = 2 * WIDTH};
        CHECK_EQ(tia_view_draw_checked(&sealed, (struct tia_tile){0, y, WIDTH, 1}, &surface, &options), TIA_OK);
    }
    shown.rows = 0;
}

static int compare(struct tia_tile tile, bool dither, struct tia_difference *difference)
{
    return tia_view_compare(&sealed, tile, dither, &readback, rows, 2 * WIDTH, difference);
}

static const struct tia_tile whole = {0, 0, WIDTH, HEIGHT};

TEST(what_is_right)
{
    struct tia_difference difference = {.count = 9};

    for (int dither = 0; dither < 2; dither++) {
        show(dither);
        CHECK_EQ(compare(whole, dither, &difference), TIA_OK);
        CHECK_EQ(difference.count, 0);
        CHECK_EQ(shown.rows, HEIGHT);
        CHECK_EQ(compare(whole, !dither, NULL), TIA_ERR_DAMAGED);
        CHECK_EQ(compare((struct tia_tile){5, 7, 20, 3}, dither, NULL), TIA_OK);
    }
}

TEST(pixels_that_differ)
{
    struct tia_difference difference;
    const struct tia_tile tile = {10, 20, 30, 20};

    show(false);
    for (unsigned y = 0; y < HEIGHT; y++)
        for (unsigned x = 0; x < WIDTH; x++) {
            bool inside = x >= 10 && x < 40 && y >= 20 && y < 40;
            tia_rgb565 drawn = shown.memory[y][x];
            shown.memory[y][x] ^= (tia_rgb565)(1 << (x + y) % 16);
            CHECK_EQ(compare(tile, false, &difference), inside ? TIA_ERR_DAMAGED : TIA_OK);
            CHECK_EQ(difference.count, inside);
            CHECK(!inside || (difference.x == x && difference.y == y && difference.drawn == drawn &&
                              difference.read == shown.memory[y][x]));
            shown.memory[y][x] = drawn;
        }
    shown.memory[30][12] ^= 1;
    shown.memory[30][39] ^= 1;
    shown.memory[25][39] ^= 4;
    CHECK_EQ(compare(tile, false, &difference), TIA_ERR_DAMAGED);
    CHECK(difference.count == 3 && difference.x == 39 && difference.y == 25);
}

TEST(what_cannot_be_compared)
{
    struct tia_difference difference = {.count = 9};

    show(false);
    shown.fails_at = 3;
    CHECK_EQ(compare(whole, false, &difference), TIA_ERR_DEVICE);
    CHECK_EQ(shown.rows, 3);
    shown.fails_at = -1;
    CHECK_EQ(compare((struct tia_tile){0, 0, WIDTH, HEIGHT + 1}, false, &difference), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_view_compare(&sealed, whole, false, &readback, rows, 2 * WIDTH - 1, NULL), TIA_ERR_MEMORY);
    shown.memory[0][0] ^= 1;
    shown.breaks_at = 5;
    CHECK_EQ(compare(whole, false, &difference), TIA_ERR_DAMAGED);
    CHECK(difference.count == 0 && shown.rows > 6);
    show(false);
    shown.memory[0][0] ^= 1;
    view_memory[30] ^= 1;
    CHECK_EQ(compare(whole, false, &difference), TIA_ERR_DAMAGED);
    CHECK(difference.count == 0 && shown.rows == 0);
}

int main(void)
{
    RUN(what_is_right);
    RUN(pixels_that_differ);
    RUN(what_cannot_be_compared);
    return check_status();
}
