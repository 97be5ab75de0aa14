/* rays.c - draws a compiled scene, SCENE, by rays, and prints the picture's checksum. Instructions between the marks
 * are counted, see count.py. */
#include <tia/debug.h>
#include <tia/tia.h>

#include "boards/board.h"
#include "marks.h"

enum { WIDTH = 64, HEIGHT = 48, MEMORY = 12 << 20 };

extern const struct tia_scene SCENE;

static uint64_t memory[MEMORY / sizeof(uint64_t)];
static tia_rgb565 picture[WIDTH * HEIGHT];

int main(void)
{
    const struct tia_tile whole = {0, 0, WIDTH, HEIGHT};
    const struct tia_surface surface = {.pixels = picture, .step = 2, .pitch = 2 * WIDTH};
    size_t view_size = tia_view_size(&SCENE, SCENE.light_count), hits_size = tia_hits_size(&SCENE, whole);
    size_t room = (view_size + 7) / 8 * 8;
    struct tia_view *view;
    struct tia_hits *hits;

    if (room > sizeof memory || hits_size > sizeof memory - room)
        return -TIA_ERR_MEMORY;
    int status = tia_view_init(&view, memory, view_size, &SCENE, SCENE.light_count, WIDTH, HEIGHT, NULL);
    status = status ? status : tia_hits_init(&hits, (char *)memory + room, hits_size, view, whole);
    count_begin();
    status = status ? status : tia_view_draw(view, hits, whole, &surface, NULL);
    count_end();
    board_print(!status ? "full " : "failed ");
    board_print_hex(tia_crc32(0, picture, WIDTH * HEIGHT));
    board_print("\n");
    return -status;
}
