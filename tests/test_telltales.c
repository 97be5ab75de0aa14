/* Telltales that tia-compile computed, on frames that arrive strip by strip, and on wrong ones. tests/quick/telltales
 * compares the CRCs themselves with zlib's. */
#include <tia/tia.h>
#include <tia/trust.h>

#include "check.h"

enum { WIDTH = 128, HEIGHT = 96 };

/* From scenes/thesis.tia, see the Makefile: "ball", "horizon", "corner". */
extern const struct tia_telltales compiled_telltales;

static uint64_t view_memory[320], hits_memory[WIDTH * HEIGHT + 64];
static tia_rgb565 pixels[WIDTH * HEIGHT];
static struct tia_telltale_sum sums[3];
static const struct tia_telltales *const all = &compiled_telltales;

static void draw(uint32_t state)
{
    const struct tia_tile frame = {0, 0, WIDTH, HEIGHT};
    const struct tia_surface surface = {.pixels = pixels, .step = 2, .pitch = 2 * WIDTH};
    struct tia_light light;
    uint32_t count = 0;
    struct tia_view *view;
    struct tia_hits *hits;

    if (state)
        CHECK_EQ(tia_viewer_press(&tia_thesis_scene, &light, &count, 1, all->keys[state - 1]), 1);
    CHECK_EQ(tia_view_init(&view, view_memory, sizeof view_memory, &tia_thesis_scene, 1, WIDTH, HEIGHT, NULL), TIA_OK);
    CHECK_EQ(tia_view_set_lights(view, &light, count), TIA_OK);
    CHECK_EQ(tia_hits_init(&hits, hits_memory, sizeof hits_memory, view, frame), TIA_OK);
    CHECK_EQ(tia_view_draw(view, hits, frame, &surface, NULL), TIA_OK);
}

static int add(struct tia_tile tile)
{
    const struct tia_surface surface = {.pixels = pixels + tile.y * WIDTH + tile.x, .step = 2, .pitch = 2 * WIDTH};

    return tia_telltales_add(all, sums, tile, &surface);
}

/* Adds the frame in strips, the last of which may have fewer rows. */
static int add_strips(unsigned rows)
{
    int status = TIA_OK;

    for (unsigned y = 0; y < HEIGHT && !status; y += rows)
        status = add((struct tia_tile){0, (uint16_t)y, WIDTH, (uint16_t)(HEIGHT - y < rows ? HEIGHT - y : rows)});
    return status;
}

TEST(frames_in_strips)
{
    CHECK_EQ(all->telltale_count, 3);
    CHECK_EQ(all->key_count, 4);
    for (uint32_t state = 0; state <= all->key_count; state++) {
        draw(state);
        for (unsigned rows = 1; rows <= HEIGHT; rows = rows * 2 + 1) {
            CHECK_EQ(add_strips(rows), TIA_OK);
            CHECK_EQ(tia_telltales_check(all, sums, state, NULL), TIA_OK);
        }
        for (uint32_t other = 0; other <= all->key_count; other++) {
            CHECK_EQ(add_strips(7), TIA_OK);
            CHECK_EQ(tia_telltales_check(all, sums, other, NULL), other == state ? TIA_OK : TIA_ERR_DAMAGED);
        }
    }
}

/* One wrong bit of any pixel of the first telltale is noticed, and others in no telltale are not. */
TEST(each_wrong_pixel)
{
    draw(1);
    for (unsigned y = 0; y < HEIGHT; y++)
        for (unsigned x = 0; x < WIDTH; x += 3) {
            uint32_t wrong = 99, want = 99;
            for (uint32_t i = all->telltale_count; i-- > 0;) {
                const struct tia_tile a = all->telltales[i].area;
                if (x >= a.x && x < (unsigned)a.x + a.width && y >= a.y && y < (unsigned)a.y + a.height)
                    want = i;
            }
            pixels[y * WIDTH + x] ^= (tia_rgb565)(1 << (x + y) % 16);
            CHECK_EQ(add_strips(16), TIA_OK);
            CHECK_EQ(tia_telltales_check(all, sums, 1, &wrong), want == 99 ? TIA_OK : TIA_ERR_DAMAGED);
            CHECK_MSG(wrong == want, "(%u, %u): telltale %u, not %u", x, y, wrong, want);
            pixels[y * WIDTH + x] ^= (tia_rgb565)(1 << (x + y) % 16);
        }
}

/* A frame of which nothing is new is not right again. */
TEST(frames_that_do_not_come)
{
    uint32_t wrong = 99;

    draw(0);
    CHECK_EQ(add_strips(8), TIA_OK);
    CHECK_EQ(tia_telltales_check(all, sums, 0, &wrong), TIA_OK);
    CHECK_EQ(tia_telltales_check(all, sums, 0, &wrong), TIA_ERR_DAMAGED);
    CHECK_EQ(wrong, 0);
    CHECK_EQ(add((struct tia_tile){0, 0, WIDTH, HEIGHT / 2}), TIA_OK);
    CHECK_EQ(tia_telltales_check(all, sums, 0, &wrong), TIA_ERR_DAMAGED);
}

TEST(strips_out_of_order)
{
    const struct tia_tile upper = {0, 0, WIDTH, HEIGHT / 2}, lower = {0, HEIGHT / 2, WIDTH, HEIGHT / 2};
    const struct tia_tile left = {0, 0, WIDTH / 2, HEIGHT}, right = {WIDTH / 2, 0, WIDTH / 2, HEIGHT};

    draw(0);
    CHECK_EQ(add(lower), TIA_ERR_ARGUMENT);
    CHECK_EQ(add(upper), TIA_OK);
    CHECK_EQ(add(lower), TIA_OK);
    CHECK_EQ(add(lower), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_telltales_check(all, sums, 0, NULL), TIA_ERR_DAMAGED);
    CHECK_EQ(add(left), TIA_ERR_ARGUMENT);
    CHECK_EQ(add(right), TIA_ERR_ARGUMENT);
    CHECK_EQ(add(upper), TIA_OK);
    CHECK_EQ(add(upper), TIA_OK); /* the frame has begun again */
    CHECK_EQ(add(lower), TIA_OK);
    CHECK_EQ(tia_telltales_check(all, sums, 0, NULL), TIA_OK);
}

/* A panel that is rotated by 180 degrees. */
TEST(pixels_with_strides)
{
    static tia_rgb565 turned[2 * WIDTH * HEIGHT];
    tia_rgb565 *last = turned + 2 * WIDTH * HEIGHT - 2;
    const struct tia_surface surface = {.pixels = last, .step = -4, .pitch = -4 * WIDTH};

    draw(2);
    for (unsigned i = 0; i < WIDTH * HEIGHT; i++)
        last[-2 * (int)i] = pixels[i];
    CHECK_EQ(tia_telltales_add(all, sums, (struct tia_tile){0, 0, WIDTH, HEIGHT}, &surface), TIA_OK);
    CHECK_EQ(tia_telltales_check(all, sums, 2, NULL), TIA_OK);
}

int main(void)
{
    RUN(frames_in_strips);
    RUN(each_wrong_pixel);
    RUN(frames_that_do_not_come);
    RUN(strips_out_of_order);
    RUN(pixels_with_strides);
    return check_status();
}
