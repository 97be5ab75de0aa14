/* client.c - a program that uses the installed library, in C and in C++: the built-in scene with key a's light, row by
 * row. Prints the library's version and the picture's CRC-32, as `tia -k a -s 320x240 --checksum` does. */
#include <stdio.h>
#include <tia/debug.h>
#include <tia/tia.h>

#ifndef CLIENT_CORE
#define CLIENT_CORE tia_core_q16
#endif

static uint64_t view_memory[320], hits_memory[320 + 8];
static tia_rgb565 row[320];

int main(void)
{
    const struct tia_core *core = &CLIENT_CORE;
    struct tia_surface surface;
    struct tia_view *view;
    struct tia_hits *hits;
    struct tia_tile tile = {0, 0, 320, 1};
    uint32_t crc = 0;
    surface.pixels = row;
    surface.step = sizeof *row;
    surface.pitch = sizeof row;
    if (core->view_init(core, &view, view_memory, sizeof view_memory, &tia_thesis_scene, 1, 320, 240, NULL) ||
        tia_view_set_lights(view, &tia_thesis_scene.bindings[0].state, 1))
        return 1;
    for (; tile.y < 240; tile.y++) {
        if (tia_hits_init(&hits, hits_memory, sizeof hits_memory, view, tile) ||
            tia_view_draw(view, hits, tile, &surface, NULL))
            return 1;
        crc = tia_crc32(crc, row, 320);
    }
    printf("%s %08x\n", TIA_VERSION, (unsigned)crc);
    return 0;
}
