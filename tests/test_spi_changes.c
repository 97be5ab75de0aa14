/* test_spi_changes.c - SPI panels that receive only what has changed, and the time that the bus takes: bytes and times
 * are computed here from whole pictures. */
#include "spi_picture.h"

static void compare(unsigned columns, unsigned rows, unsigned block)
{
    struct tia_spi_panel panel = make_changing(columns, rows, block);
    struct tia_mode mode;

    CHECK_EQ(tia_spi_panel_changes.open(&panel, &mode), TIA_OK);
    CHECK_EQ(mode.tile_width, columns);
    CHECK_EQ(mode.tile_height, rows);
    draw_picture(NULL);
    CHECK_EQ(bytes_sent(&panel), 2 * PIXELS + 11 * (W / columns * (H / rows)) + 1); /* all of it, and DISPON */
    for (unsigned i = 0; i < 12; i++) {
        show_key(i / 3, (int)(i % 3));
        size_t want = bytes_of_change(columns, rows, block), sent = bytes_sent(&panel);
        CHECK_MSG(sent == want, "%u x %u, blocks of %u, step %u: %zu bytes, not %zu", columns, rows, block, i, sent,
                  want);
    }
    show_key(3, 2);
    CHECK_EQ(bytes_sent(&panel), bytes_of_change(columns, rows, block));
    CHECK(block > 1 || bytes_of_change(columns, rows, block) == 0);
    CHECK_EQ(model.disturbed, 0);
    tia_spi_panel_changes.close(&panel);
}

TEST(only_changes_are_sent)
{
    static const unsigned strip[][2] = {{W, 1}, {W, 10}, {160, 4}, {64, 20}};

    for (int i = 0; i < 4; i++)
        for (unsigned block = 1; block <= 64; block = block < 16 ? 16 : 2 * block)
            compare(strip[i][0], strip[i][1], block <= strip[i][0] && strip[i][0] % block == 0 ? block : 32);
}

/* ---- time ---- */

/* Draws strips that take draw_ns[i % 3] each while the bus sends, and returns the time until all are on the panel. */
static uint64_t time_of(const struct tia_display *display, unsigned rows, const uint64_t draw_ns[3])
{
    struct tia_spi_panel panel = make_changing(W, rows, 1);
    struct tia_mode mode;

    CHECK_EQ(display->open(&panel, &mode), TIA_OK);
    finish_dma();
    model.byte_ns = 200; /* 40 MHz */
    uint64_t start = model.bus_ns;
    for (unsigned y = 0, i = 0; y < H; y += rows, i++) {
        struct tia_surface surface;
        const struct tia_tile tile = {0, (uint16_t)y, W, (uint16_t)rows};
        CHECK_EQ(display->acquire(&panel, tile, &surface), TIA_OK);
        for (unsigned k = 0; k < W * rows; k++)
            surface.pixels[k] = (tia_rgb565)(y + k);
        model.bus_ns += draw_ns[i % 3];
        CHECK_EQ(display->submit(&panel, tile), TIA_OK);
    }
    finish_dma();
    CHECK_EQ(model.disturbed, 0);
    return model.bus_ns - start;
}

/* While a strip is sent the next one is drawn: a strip takes the longer of the two times, and the eleven bytes of its
 * place, for which the processor waits. */
TEST(drawing_and_sending_overlap)
{
    static const uint64_t draw_ns[][3] = {{0, 0, 0}, {1000000, 1000000, 1000000}, {300000, 900000, 20000}};

    for (unsigned rows = 1; rows <= 4; rows += 3)
        for (int i = 0; i < 3; i++) {
            uint64_t place = 11 * 200, sends = (uint64_t)W * rows * 2 * 200, time = 0, end = 0, one_after_other = 0;
            for (unsigned n = 0; n < H / rows; n++) {
                time += draw_ns[i][n % 3];
                time = (time > end ? time : end) + place;
                end = time + sends;
                one_after_other += draw_ns[i][n % 3] + place + sends;
            }
            CHECK_EQ(time_of(&tia_spi_panel_display, rows, draw_ns[i]), end);
            CHECK_EQ(time_of(&tia_spi_panel_changes, rows, draw_ns[i]), end);
            CHECK(i == 0 || one_after_other > end + (H / rows - 2) * sends / 2);
        }
}

/* The model notices a strip that is changed while it is sent. */
TEST(writing_into_a_strip_being_sent_is_noticed)
{
    struct tia_spi_panel panel = make_changing(W, 4, 1);
    struct tia_mode mode;
    struct tia_surface surface;
    const struct tia_tile tile = {0, 0, W, 4};

    CHECK_EQ(tia_spi_panel_changes.open(&panel, &mode), TIA_OK);
    CHECK_EQ(tia_spi_panel_changes.acquire(&panel, tile, &surface), TIA_OK);
    memset(surface.pixels, 0, sizeof(tia_rgb565) * W * 4);
    CHECK_EQ(tia_spi_panel_changes.submit(&panel, tile), TIA_OK);
    surface.pixels[5] ^= 1;
    finish_dma();
    CHECK_EQ(model.disturbed, 1);
}

/* ---- failures ---- */

/* Wherever the bus fails, the frame after the next one is right: what was not sent is sent again. */
TEST(after_a_failure_all_is_sent)
{
    for (int calls = 1; calls < 60; calls += 7) {
        struct tia_spi_panel panel = make_changing(W, 10, 1);
        struct tia_mode mode;
        int status = TIA_OK;
        CHECK_EQ(tia_spi_panel_changes.open(&panel, &mode), TIA_OK);
        show_key(0, 0);
        (void)bytes_sent(&panel);
        show_key(1, 0);
        model.fails_after = calls;
        for (unsigned y = 0; y < H; y += panel.rows) /* goes on after the failure, as a careless program would */
            status = send_tile(&panel, (struct tia_tile){0, (uint16_t)y, W, panel.rows}) ? TIA_ERR_DEVICE : status;
        CHECK_EQ(status, TIA_ERR_DEVICE);
        CHECK_EQ(tia_spi_panel_changes.present(&panel), TIA_OK);
        CHECK_EQ(bytes_sent(&panel), 2 * PIXELS + 11 * H / 10);
        CHECK_EQ(bytes_sent(&panel), 0);
        CHECK_EQ(model.disturbed, 0);
    }
}

TEST(memory_for_what_is_shown)
{
    struct tia_spi_panel panel = make_changing(W, 4, 1);
    struct tia_mode mode;

    panel.shown_memory = NULL;
    CHECK_EQ(tia_spi_panel_changes.open(&panel, &mode), TIA_ERR_ARGUMENT);
    CHECK(strstr(panel.why, "shown_size"));
    panel = make_changing(W, 4, 1);
    panel.shown_size = 100;
    CHECK_EQ(tia_spi_panel_changes.open(&panel, &mode), TIA_ERR_ARGUMENT);
    CHECK_EQ(model.commands, 0);
    tia_spi_panel_changes.close(&panel);
    CHECK_EQ(model.commands, 0);
}

/* ---- the viewer ---- */

static struct {
    unsigned next, frames;
    struct tia_light lights[1];
} user;

static int poll_key(void *ctx, struct tia_event *event)
{
    static const uint16_t keys[] = {'a', TIA_KEY_LEFT, 'd', TIA_KEY_UP, TIA_KEY_PAGE_DOWN, 's', 'w', 'x'};

    (void)ctx;
    if (user.next >= user.frames || user.next >= sizeof keys / sizeof *keys)
        return 0;
    *event = (struct tia_event){.kind = TIA_EVENT_TAP, .key = keys[user.next++]};
    return 1;
}

static int wait_for_key(void *ctx, int timeout_ms)
{
    (void)ctx, (void)timeout_ms;
    return TIA_OK;
}

static int check_frame(void *ctx, const struct tia_frame *frame)
{
    (void)ctx;
    draw_picture(frame->number ? user.lights : NULL);
    CHECK_EQ(wrong_pixels(), 0);
    user.frames++;
    return TIA_OK;
}

static void *take_memory(void *ctx, size_t size)
{
    static uint64_t memory[16 * 1024];

    (void)ctx;
    return size <= sizeof memory ? memory : NULL;
}

TEST(viewer_with_keys)
{
    static const struct tia_input input = {.poll = poll_key, .wait = wait_for_key};
    struct tia_spi_panel panel = make_changing(160, 4, 32);
    struct tia_viewer viewer = {.scene = &tia_thesis_scene,
                                .lights = {.array = user.lights, .capacity = 1},
                                .ports = {.display = &tia_spi_panel_changes, .display_ctx = &panel, .input = &input},
                                .hooks = {.memory = take_memory, .frame_done = check_frame}};
    struct tia_mode mode;

    CHECK_EQ(tia_spi_panel_changes.open(&panel, &mode), TIA_OK);
    CHECK_EQ(tia_viewer_run(&viewer), TIA_OK);
    CHECK_EQ(user.frames, 8);
    CHECK(model.sent < 6 * (size_t)2 * PIXELS);
    CHECK_EQ(model.disturbed, 0);
}

int main(void)
{
    RUN(only_changes_are_sent);
    RUN(drawing_and_sending_overlap);
    RUN(writing_into_a_strip_being_sent_is_noticed);
    RUN(after_a_failure_all_is_sent);
    RUN(memory_for_what_is_shown);
    RUN(viewer_with_keys);
    return check_status();
}
