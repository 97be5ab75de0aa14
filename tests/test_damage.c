/* test_damage.c - tia/damage.h: a display that receives only what has changed always shows the picture, and of single
 * pixels and whole blocks it receives no more than the rectangle around what differs, found in whole pictures. */
#include <limits.h>

#include <tia/damage.h>

#include "check.h"
#include "random.h"

enum { W = 83, H = 31, MARGIN = 8, PICTURE = W * H };

static tia_rgb565 picture[PICTURE], before[PICTURE], display[PICTURE], spread[3 * PICTURE];
static uint16_t memory[PICTURE + MARGIN];
static struct tia_damage damage;

static unsigned below(unsigned n)
{
    return (unsigned)(random_bits() % n);
}

/* Changes the picture: up to four rectangles of one colour, or of two. */
static void change(void)
{
    memcpy(before, picture, sizeof before);
    for (unsigned n = below(5); n > 0; n--) {
        unsigned x0 = below(W), y0 = below(H), x1 = x0 + 1 + below(W - x0), y1 = y0 + 1 + below(H - y0);
        unsigned colours = 1 + below(2), colour = below(3) * 0x1234;
        for (unsigned y = y0; y < y1; y++)
            for (unsigned x = x0; x < x1; x++)
                picture[y * W + x] = (tia_rgb565)(colour + below(colours));
    }
}

/* Copies a tile's pixels into memory of one of three layouts. */
static struct tia_surface surface_of(struct tia_tile tile, unsigned way)
{
    const ptrdiff_t step = way == 1 ? 6 : 2, line = step * tile.width, pitch = way == 2 ? -line : line;
    char *first = (char *)spread + (way == 2 ? (tile.height - 1) * line : 0);

    for (unsigned y = 0; y < tile.height; y++)
        for (unsigned x = 0; x < tile.width; x++)
            *(tia_rgb565 *)(void *)(first + (ptrdiff_t)y * pitch + (ptrdiff_t)x * step) =
                picture[(tile.y + y) * W + tile.x + x];
    return (struct tia_surface){.pixels = (tia_rgb565 *)(void *)first, .step = step, .pitch = pitch};
}

/* True if the block's pixels in a row of both pictures all have one and the same colour. */
static bool is_still(unsigned y, unsigned first, unsigned end)
{
    tia_rgb565 colour = picture[y * W + first];

    for (unsigned x = first; x < end; x++)
        if (picture[y * W + x] != colour || before[y * W + x] != colour)
            return false;
    return true;
}

/* Returns the rectangle around what is to be sent of a tile that begins and ends with whole blocks; empty if nothing.
 */
static struct tia_tile expected(struct tia_tile tile, unsigned block)
{
    unsigned left = W, right = 0, top = H, bottom = 0;

    for (unsigned y = tile.y; y < (unsigned)tile.y + tile.height; y++)
        for (unsigned x = tile.x; x < (unsigned)tile.x + tile.width; x += block) {
            unsigned end = x + block < W ? x + block : W;
            if (is_still(y, x, end))
                continue;
            left = x < left ? x : left;
            right = end > right ? end : right;
            top = y < top ? y : top;
            bottom = y + 1;
        }
    if (bottom == 0)
        return (struct tia_tile){0, 0, 0, 0};
    return (struct tia_tile){(uint16_t)left, (uint16_t)top, (uint16_t)(right - left), (uint16_t)(bottom - top)};
}

static bool is_inside(struct tia_tile part, struct tia_tile tile)
{
    return part.width && part.height && part.x >= tile.x && part.y >= tile.y &&
           part.x + part.width <= tile.x + tile.width && part.y + part.height <= tile.y + tile.height;
}

/* Sends what has changed in a tile. If `whole` blocks make it up, compares that with what is expected. */
static void send_tile(struct tia_tile tile, unsigned way, unsigned block, bool whole, bool first)
{
    struct tia_surface surface = surface_of(tile, way);
    struct tia_tile part = {0, 0, 0, 0}, want = first ? tile : expected(tile, block);
    bool any = tia_damage_update(&damage, tile, &surface, &part);

    if (whole || first)
        CHECK_MSG(any == (want.width > 0) && !memcmp(&part, &want, sizeof want),
                  "blocks of %u: %u,%u %ux%u, not %u,%u %ux%u", block, part.x, part.y, part.width, part.height, want.x,
                  want.y, want.width, want.height);
    if (!any)
        return;
    CHECK(is_inside(part, tile));
    for (unsigned y = part.y; y < (unsigned)part.y + part.height; y++)
        memcpy(display + y * W + part.x, picture + y * W + part.x, part.width * sizeof *display);
}

static void send_frame(unsigned width, unsigned height, unsigned way, unsigned block, bool first)
{
    bool whole = width % block == 0 || width == W;

    for (unsigned y = 0; y < H; y += height)
        for (unsigned x = 0; x < W; x += width) {
            const struct tia_tile tile = {(uint16_t)x, (uint16_t)y, (uint16_t)(W - x < width ? W - x : width),
                                          (uint16_t)(H - y < height ? H - y : height)};
            send_tile(tile, way, block, whole, first);
        }
}

static void shows_all(unsigned block, unsigned width, unsigned height)
{
    size_t size = tia_damage_size(W, H, block);

    CHECK(size <= sizeof memory - MARGIN);
    memset(memory, 0xa5, sizeof memory);
    memset(display, 0x11, sizeof display);
    CHECK_EQ(tia_damage_init(&damage, memory, size, W, H), TIA_OK);
    for (unsigned frame = 0, known = 0; frame < 60; frame++, known++) {
        change();
        if (frame % 23 == 22) { /* the display has lost its picture */
            tia_damage_forget(&damage);
            memset(display, 0x11, sizeof display);
            known = 0;
        }
        send_frame(width, height, frame % 3, block, !known);
        tia_damage_complete(&damage);
        CHECK_MSG(!memcmp(display, picture, sizeof picture), "blocks of %u, tiles of %ux%u", block, width, height);
    }
    for (size_t i = size; i < size + MARGIN; i++)
        CHECK(((const uint8_t *)memory)[i] == 0xa5);
}

TEST(every_change_is_sent)
{
    static const unsigned tiles[][2] = {{W, 1}, {W, 4}, {W, H}, {16, 8}, {32, 1}, {1, 1}, {7, 3}, {50, 31}};

    for (unsigned block = 1; block <= 128; block *= 2)
        for (size_t i = 0; i < sizeof tiles / sizeof *tiles; i++)
            shows_all(block, tiles[i][0], tiles[i][1]);
}

/* A frame that ends early leaves what was sent known: once a whole frame was shown, nothing is lost or sent twice. */
TEST(frames_that_end_early)
{
    const struct tia_tile upper = {0, 0, W, 10}, all = {0, 0, W, H};
    struct tia_tile part;

    for (unsigned block = 1; block <= 32; block *= 32) {
        CHECK_EQ(tia_damage_init(&damage, memory, tia_damage_size(W, H, block), W, H), TIA_OK);
        change();
        send_tile(upper, 0, block, true, true);
        send_tile(all, 0, block, true, true);
        tia_damage_complete(&damage);
        for (int i = 0; i < W * H; i++)
            picture[i] = 0x4321;
        send_tile(upper, 0, block, false, false);
        struct tia_surface surface = surface_of(all, 0);
        CHECK(tia_damage_update(&damage, all, &surface, &part));
        CHECK_EQ(part.y, 10);
        CHECK(!tia_damage_update(&damage, all, &surface, &part));
    }
}

TEST(sizes)
{
    CHECK_EQ(tia_damage_size(320, 240, 1), 153600);
    CHECK_EQ(tia_damage_size(320, 240, 2), 240 * (160 * 2 + 20));
    CHECK_EQ(tia_damage_size(320, 240, 32), 240 * (10 * 2 + 2));
    CHECK_EQ(tia_damage_size(321, 240, 64), 240 * (6 * 2 + 1));
    CHECK_EQ(tia_damage_size(8192, 1, 8192), 3);
    CHECK_EQ(tia_damage_size(8192, 8192, 1), (size_t)2 * 8192 * 8192);
    CHECK_EQ(tia_damage_size(0, 240, 1), SIZE_MAX);
    CHECK_EQ(tia_damage_size(320, 0, 1), SIZE_MAX);
    CHECK_EQ(tia_damage_size(8193, 240, 1), SIZE_MAX);
    CHECK_EQ(tia_damage_size(320, 8193, 1), SIZE_MAX);
    CHECK_EQ(tia_damage_size(320, 240, 0), SIZE_MAX);
    CHECK_EQ(tia_damage_size(320, 240, 3), SIZE_MAX);
    CHECK_EQ(tia_damage_size(320, 240, 16384), SIZE_MAX);
    CHECK_EQ(tia_damage_size(320, 240, UINT_MAX), SIZE_MAX);
}

/* The memory that is given decides how much is sent of a row in which one pixel changes. */
TEST(blocks_fit_into_the_memory)
{
    for (unsigned block = 1; block <= 64; block *= 2)
        for (size_t more = 0; more <= 2; more += 2) {
            const struct tia_tile row = {0, 5, W, 1};
            size_t size = tia_damage_size(W, H, block);
            size_t larger = block > 1 ? tia_damage_size(W, H, block / 2) : size + 3;
            struct tia_tile part;
            CHECK_EQ(tia_damage_init(&damage, memory, size + more < larger ? size + more : larger - 1, W, H), TIA_OK);
            for (int i = 0; i < PICTURE; i++)
                picture[i] = 0x0123;
            send_frame(W, H, 0, block, true);
            tia_damage_complete(&damage);
            picture[5 * W + 64] = 0x0124;
            struct tia_surface surface = surface_of(row, 0);
            CHECK(tia_damage_update(&damage, row, &surface, &part));
            CHECK_EQ(part.x, 64);
            CHECK_EQ(part.width, block < W - 64 ? block : W - 64);
        }
    CHECK_EQ(tia_damage_init(&damage, memory, tia_damage_size(W, H, 128) - 1, W, H), TIA_ERR_MEMORY);
    CHECK_EQ(tia_damage_init(&damage, memory, 0, W, H), TIA_ERR_MEMORY);
}

/* The display's own frame is the memory. */
TEST(a_frame_of_the_display)
{
    const struct tia_tile all = {0, 0, W, H};
    struct tia_tile part;

    for (int i = 0; i < PICTURE; i++)
        display[i] = picture[i] = (tia_rgb565)i;
    CHECK_EQ(tia_damage_init(&damage, display, sizeof display, W, H), TIA_OK);
    tia_damage_complete(&damage);
    struct tia_surface surface = surface_of(all, 1);
    CHECK(!tia_damage_update(&damage, all, &surface, &part));
    picture[3 * W + 4] = picture[7 * W + 2] = 0xffff;
    surface = surface_of(all, 1);
    CHECK(tia_damage_update(&damage, all, &surface, &part));
    CHECK(part.x == 2 && part.y == 3 && part.width == 3 && part.height == 5);
    CHECK(!memcmp(display, picture, sizeof picture));
}

TEST(misuse)
{
    const struct tia_tile all = {0, 0, W, H};
    struct tia_surface surface = surface_of(all, 0);
    struct tia_tile part = {1, 2, 3, 4}, kept = part;

    CHECK_EQ(tia_damage_init(NULL, memory, sizeof memory, W, H), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_damage_init(&damage, NULL, sizeof memory, W, H), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_damage_init(&damage, (char *)memory + 1, sizeof memory - 1, W, H), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_damage_init(&damage, memory, sizeof memory, 0, H), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_damage_init(&damage, memory, sizeof memory, W, 8193), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_damage_init(&damage, memory, sizeof memory, W, H), TIA_OK);
    CHECK(!tia_damage_update(NULL, all, &surface, &part));
    CHECK(!tia_damage_update(&damage, all, NULL, &part));
    CHECK(!tia_damage_update(&damage, all, &surface, NULL));
    CHECK(!tia_damage_update(&damage, (struct tia_tile){0, 0, 0, H}, &surface, &part));
    CHECK(!tia_damage_update(&damage, (struct tia_tile){1, 0, W, H}, &surface, &part));
    CHECK(!tia_damage_update(&damage, (struct tia_tile){0, 1, W, H}, &surface, &part));
    surface.pixels = NULL;
    CHECK(!tia_damage_update(&damage, all, &surface, &part));
    surface = surface_of(all, 0);
    surface.step = 3;
    CHECK(!tia_damage_update(&damage, all, &surface, &part));
    CHECK(!memcmp(&part, &kept, sizeof part));
    tia_damage_complete(NULL);
    tia_damage_forget(NULL);
}

int main(void)
{
    RUN(every_change_is_sent);
    RUN(frames_that_end_early);
    RUN(sizes);
    RUN(blocks_fit_into_the_memory);
    RUN(a_frame_of_the_display);
    RUN(misuse);
    return check_status();
}
