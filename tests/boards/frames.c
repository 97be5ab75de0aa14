/* frames.c - draws the thesis scene on a microcontroller, in each of its light states and at two sizes, strip by strip
 * in little memory, and prints the CRC-32 of each frame. */
#include "boards/board.h"
#include <tia/debug.h>
#include <tia/tia.h>

/* Number of rows of a strip. The hits of a strip take eight bytes a pixel, the prepared scene the rest of the arena. */
#ifndef ROWS
#define ROWS 2
#endif
#ifndef CORE
#define CORE tia_core_spheres
#endif
#ifndef LARGE
#define LARGE 1 /* 0: only the small size, for emulators that take minutes */
#endif
enum { WIDTH = 320, HEIGHT = 240, SMALL_WIDTH = 128, SMALL_HEIGHT = 160, ARENA = WIDTH * ROWS * 8 + 2304 };

static uint64_t arena[ARENA / sizeof(uint64_t)];

/* A display that stores only a strip and the checksum of all strips so far. */
struct checksum {
    uint16_t width, height;
    uint16_t next_row; /* least row of the next strip: strips must come from top to bottom */
    uint32_t crc;
    tia_rgb565 strip[WIDTH * ROWS];
};

static int strip_mode(void *ctx, struct tia_mode *mode)
{
    const struct checksum *sum = ctx;
    *mode = (struct tia_mode){
        .width = sum->width, .height = sum->height, .tile_width = sum->width, .tile_height = ROWS, .format = "RGB565"};
    return TIA_OK;
}

static int strip_acquire(void *ctx, struct tia_tile tile, struct tia_surface *surface)
{
    struct checksum *sum = ctx;
    if (tile.x || tile.width != sum->width || tile.height > ROWS || tile.y != sum->next_row)
        return TIA_ERR_ARGUMENT;
    *surface = (struct tia_surface){.pixels = sum->strip, .step = 2, .pitch = 2 * (ptrdiff_t)tile.width};
    return TIA_OK;
}

static int strip_submit(void *ctx, struct tia_tile tile)
{
    struct checksum *sum = ctx;
    sum->crc = tia_crc32(sum->crc, sum->strip, (size_t)tile.width * tile.height);
    sum->next_row = (uint16_t)(tile.y + tile.height);
    return TIA_OK;
}

static int strip_present(void *ctx)
{
    const struct checksum *sum = ctx;
    return sum->next_row == sum->height ? TIA_OK : TIA_ERR_DEVICE;
}

static void strip_close(void *ctx)
{
    (void)ctx;
}

static const struct tia_display strips = {strip_mode,    strip_mode,  strip_acquire, strip_submit,
                                          strip_present, strip_close, NULL};

static size_t arena_used;

static void *take_arena(void *ctx, size_t size)
{
    (void)ctx;
    if (size > ARENA)
        return NULL;
    if (size > arena_used)
        arena_used = size;
    return arena;
}

static void tell(const struct checksum *sum, char key, int status)
{
    static char name[] = "? ";
    name[0] = key;
    board_print(!status ? "frame " : "failed ");
    board_print_number(sum->width);
    board_print("x");
    board_print_number(sum->height);
    board_print(" ");
    board_print(name);
    board_print_hex(sum->crc);
    board_print("\n");
}

static int draw(uint16_t width, uint16_t height, char key)
{
    static struct checksum sum;
    const uint16_t keys[] = {(uint16_t)key};
    struct tia_light light;
    sum.width = width, sum.height = height, sum.next_row = 0, sum.crc = 0;
    struct tia_viewer viewer = {
        .core = &CORE,
        .scene = &tia_thesis_scene,
        .lights = {.array = &light, .capacity = 1},
        .pacing = {.frame_limit = 1},
        .ports = {.display = &strips, .display_ctx = &sum},
        .hooks = {.memory = take_arena},
        .keys = keys,
        .key_count = key == '-' ? 0 : 1,
    };
    int status = tia_viewer_run_spheres(&viewer);
    tell(&sum, key, status);
    return status;
}

int main(void)
{
    static const char states[] = "-adsw"; /* no light, then the four keys */
    int failed = 0;
    for (const char *key = states; *key; key++) {
        failed |= LARGE ? draw(WIDTH, HEIGHT, *key) : 0;
        failed |= draw(SMALL_WIDTH, SMALL_HEIGHT, *key);
    }
    board_print("arena ");
    board_print_number((uint32_t)arena_used);
    board_print(" of ");
    board_print_number(ARENA);
    board_print("\nstack ");
    board_print_number(board_stack_used());
    board_print("\nend\n");
    return failed ? 1 : 0;
}
