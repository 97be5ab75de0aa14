/* test_spi_panel.c - the port for SPI panels against a model of a panel. */
#include "spi_model.h"

static tia_rgb565 pattern(unsigned x, unsigned y)
{
    return (tia_rgb565)(x * 331 + y * 7919 + 5);
}

static int draw_tile(struct tia_spi_panel *panel, struct tia_tile tile)
{
    struct tia_surface surface;
    int status = tia_spi_panel_display.acquire(panel, tile, &surface);
    for (unsigned y = 0; y < tile.height && !status; y++)
        for (unsigned x = 0; x < tile.width; x++)
            put_pixel_into(&surface, x, y, pattern(tile.x + x, tile.y + y));
    return !status ? tia_spi_panel_display.submit(panel, tile) : status;
}

/* Draws the picture in tiles of at most the given size, from top to bottom. */
static int draw(struct tia_spi_panel *panel, unsigned tile_width, unsigned tile_height)
{
    int status = TIA_OK;
    for (unsigned y = 0; y < panel->height; y += tile_height)
        for (unsigned x = 0; x < panel->width && !status; x += tile_width) {
            unsigned w = panel->width - x, h = panel->height - y;
            struct tia_tile tile = {(uint16_t)x, (uint16_t)y, (uint16_t)(w < tile_width ? w : tile_width),
                                    (uint16_t)(h < tile_height ? h : tile_height)};
            status = draw_tile(panel, tile);
        }
    return !status ? tia_spi_panel_display.present(panel) : status;
}

static unsigned wrong_pixels(const struct tia_spi_panel *panel)
{
    unsigned wrong = 0;
    finish_dma();
    for (unsigned y = 0; y < panel->height; y++)
        for (unsigned x = 0; x < panel->width; x++)
            wrong += model.memory[(y + panel->top) * MEMORY_WIDTH + x + panel->left] != pattern(x, y);
    return wrong;
}

TEST(picture_reaches_the_glass)
{
    struct tia_spi_panel panel = make_panel(240, 320, TIA_SPI_PANEL_BGR);
    struct tia_mode mode;
    CHECK_EQ(tia_spi_panel_display.open(&panel, &mode), TIA_OK);
    CHECK_EQ(mode.width, 240);
    CHECK_EQ(mode.height, 320);
    CHECK_EQ(mode.tile_height, 13); /* 10 rows of 320 */
    CHECK(!model.on);
    CHECK_EQ(draw(&panel, mode.tile_width, mode.tile_height), TIA_OK);
    CHECK_EQ(wrong_pixels(&panel), 0);
    CHECK(model.on && !model.asleep && model.colmod == 0x55 && model.madctl == TIA_SPI_PANEL_BGR);
    CHECK_EQ(model.early, 0);
    tia_spi_panel_display.close(&panel);
    CHECK(!model.on && model.asleep);
}

TEST(tiles_of_any_size)
{
    static const struct {
        unsigned width, height;
    } tiles[] = {{240, 1}, {1, 13}, {7, 5}, {64, 13}, {239, 12}};
    for (size_t i = 0; i < sizeof tiles / sizeof *tiles; i++) {
        struct tia_spi_panel panel = make_panel(240, 320, 0);
        struct tia_mode mode;
        CHECK_EQ(tia_spi_panel_display.open(&panel, &mode), TIA_OK);
        CHECK_EQ(draw(&panel, tiles[i].width, tiles[i].height), TIA_OK);
        CHECK_EQ(wrong_pixels(&panel), 0);
    }
}

/* Each of the four orientations has its corners where the data sheet puts them; the glass is 240 x 320. */
TEST(orientations)
{
    static const struct {
        uint8_t orientation;
        uint16_t width, height;
        unsigned corner; /* position of pixel (0, 0) in the memory */
    } cases[] = {{0, 240, 320, 0},
                 {TIA_SPI_PANEL_FLIP_COLUMNS | TIA_SPI_PANEL_SWAP_AXES, 320, 240, 239},
                 {TIA_SPI_PANEL_FLIP_COLUMNS | TIA_SPI_PANEL_FLIP_ROWS, 240, 320, MEMORY - 1},
                 {TIA_SPI_PANEL_FLIP_ROWS | TIA_SPI_PANEL_SWAP_AXES, 320, 240, MEMORY - 240}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct tia_spi_panel panel = make_panel(cases[i].width, cases[i].height, cases[i].orientation);
        struct tia_mode mode;
        CHECK_EQ(tia_spi_panel_display.open(&panel, &mode), TIA_OK);
        CHECK_EQ(draw(&panel, mode.tile_width, mode.tile_height), TIA_OK);
        finish_dma();
        CHECK_EQ(model.memory[cases[i].corner], pattern(0, 0));
        CHECK_EQ(model.memory[MEMORY - 1 - cases[i].corner], pattern(panel.width - 1u, panel.height - 1u));
    }
}

TEST(small_glass_in_a_large_memory)
{
    struct tia_spi_panel panel = make_panel(80, 160, 0);
    struct tia_mode mode;
    panel.left = 26, panel.top = 1; /* as for the 0.96 inch ST7735 */
    CHECK_EQ(tia_spi_panel_display.open(&panel, &mode), TIA_OK);
    CHECK_EQ(draw(&panel, mode.tile_width, mode.tile_height), TIA_OK);
    CHECK_EQ(wrong_pixels(&panel), 0);
    CHECK_EQ(model.memory[0], 0);
    CHECK_EQ(model.memory[161 * MEMORY_WIDTH + 26], 0);
}

TEST(setup_table)
{
    static const uint8_t setup[] = {0x38, 0, 0xb1, 3, 1, 2, 0x2d};
    struct tia_spi_panel panel = make_panel(240, 320, 0);
    struct tia_mode mode;
    panel.setup = setup, panel.setup_size = sizeof setup, panel.inverted = true;
    CHECK_EQ(tia_spi_panel_display.open(&panel, &mode), TIA_OK);
    tia_spi_panel_display.close(&panel);
    CHECK(model.gamma[0] == 1 && model.gamma[1] == 2 && model.gamma[2] == 0x2d && model.inverted);

    panel = make_panel(240, 320, 0);
    panel.setup = setup, panel.setup_size = sizeof setup - 1;
    CHECK_EQ(tia_spi_panel_display.open(&panel, &mode), TIA_ERR_ARGUMENT);
    CHECK(strstr(panel.why, "setup table"));
}

TEST(bad_sizes_and_tiles)
{
    struct tia_spi_panel panel = make_panel(240, 320, 0);
    struct tia_mode mode;
    struct tia_surface surface;
    panel.strips_size = 2 * 2 * 240 - 1;
    CHECK_EQ(tia_spi_panel_display.open(&panel, &mode), TIA_ERR_ARGUMENT);
    CHECK(strstr(panel.why, "strips_size"));
    tia_spi_panel_display.close(&panel);
    CHECK_EQ(model.commands, 0);

    panel.strips_size++;
    CHECK_EQ(tia_spi_panel_display.open(&panel, &mode), TIA_OK);
    CHECK_EQ(mode.tile_height, 1);
    CHECK_EQ(tia_spi_panel_display.acquire(&panel, (struct tia_tile){0, 0, 240, 2}, &surface), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_spi_panel_display.acquire(&panel, (struct tia_tile){1, 0, 240, 1}, &surface), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_spi_panel_display.acquire(&panel, (struct tia_tile){0, 320, 240, 1}, &surface), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_spi_panel_display.acquire(&panel, (struct tia_tile){0, 0, 0, 1}, &surface), TIA_ERR_ARGUMENT);
}

/* At whichever call the bus fails, the port reports the failure, stops, and can be closed. */
TEST(bus_failures)
{
    int calls = 0;
    for (int status = TIA_ERR_DEVICE; status && calls < 1000; calls++) {
        struct tia_spi_panel panel = make_panel(240, 320, 0);
        struct tia_mode mode;
        model.fails_after = calls;
        status = tia_spi_panel_display.open(&panel, &mode);
        if (!status)
            status = draw(&panel, mode.tile_width, mode.tile_height);
        CHECK(!status || status == TIA_ERR_DEVICE);
        CHECK(!status || strstr(panel.why, "spi panel: the bus refused") == panel.why);
        tia_spi_panel_display.close(&panel);
        tia_spi_panel_display.close(&panel);
    }
    CHECK(calls > 100 && calls < 1000);
}

TEST(closing_an_unopened_panel)
{
    struct tia_spi_panel panel = make_panel(240, 320, 0);
    tia_spi_panel_display.close(&panel);
    CHECK_EQ(model.commands, 0);
}

static void *take_memory(void *ctx, size_t size)
{
    static uint64_t memory[16 * 1024];
    (void)ctx;
    return size <= sizeof memory ? memory : NULL;
}

/* The viewer has memory for the hits of one strip only; its picture is the same as that of a frame drawn in one piece.
 */
TEST(viewer_on_the_panel)
{
    static tia_rgb565 picture[240 * 320];
    static uint64_t view_memory[1024], hits_memory[240 * 320 + 64];
    const uint16_t keys[] = {'d'};
    const struct tia_tile all = {0, 0, 240, 320};
    const struct tia_surface surface = {.pixels = picture, .step = 2, .pitch = 2 * 240};
    struct tia_spi_panel panel = make_panel(240, 320, 0);
    struct tia_light light;
    struct tia_viewer viewer = {.scene = &tia_thesis_scene,
                                .lights = {.array = &light, .capacity = 1},
                                .pacing = {.frame_limit = 1},
                                .ports = {.display = &tia_spi_panel_display, .display_ctx = &panel},
                                .hooks = {.memory = take_memory},
                                .keys = keys,
                                .key_count = 1};
    struct tia_mode mode;
    struct tia_view *view;
    struct tia_hits *hits;
    CHECK_EQ(tia_spi_panel_display.open(&panel, &mode), TIA_OK);
    CHECK_EQ(tia_viewer_run(&viewer), TIA_OK);
    CHECK_EQ(tia_view_init(&view, view_memory, sizeof view_memory, &tia_thesis_scene, 1, 240, 320, NULL), TIA_OK);
    CHECK_EQ(tia_view_set_lights(view, &light, 1), TIA_OK);
    CHECK_EQ(tia_hits_init(&hits, hits_memory, sizeof hits_memory, view, all), TIA_OK);
    CHECK_EQ(tia_view_draw(view, hits, all, &surface, NULL), TIA_OK);
    finish_dma();
    CHECK(memcmp(picture, model.memory, sizeof picture) == 0);
    CHECK(picture[0] != picture[300 * 240 + 120]);
}

int main(void)
{
    RUN(picture_reaches_the_glass);
    RUN(tiles_of_any_size);
    RUN(orientations);
    RUN(small_glass_in_a_large_memory);
    RUN(setup_table);
    RUN(bad_sizes_and_tiles);
    RUN(bus_failures);
    RUN(viewer_on_the_panel);
    RUN(closing_an_unopened_panel);
    return check_status();
}
