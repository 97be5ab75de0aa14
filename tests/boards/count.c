/* count.c - draws a frame of the thesis scene with the light of key a, to count instructions, see count.py: all from
 * the first ray to the last pixel are between two marks.
 *
 *   CORE     the core: tia_core_spheres, tia_f32_core_spheres or tia_f64_core_spheres, or one of these with _small
 *   ROWS     rows of a strip
 *   WHOLE    1: the hits of a whole frame are stored, and the frame is lit once more from them, between
 *            the same marks; 0: the hits of one strip are stored
 *   TIA_SWAP 1: the pixels have the other byte order */
#include "boards/board.h"
#include "marks.h"
#include <tia/debug.h>
#include <tia/tia.h>

enum { WIDTH = 320, HEIGHT = 240, HITS_ROWS = WHOLE ? HEIGHT : ROWS, VIEW_SIZE = sizeof(void *) == 2 ? 2176 : 2304 };

/* Size of the hits in bytes: in the widest arithmetic a distance takes eight bytes, on an AVR four, and an object four.
 */
enum { HITS_SIZE = 64 + WIDTH * HITS_ROWS * (sizeof(void *) == 2 ? 8 : 12) };

extern const struct tia_core CORE;

static uint64_t view_memory[VIEW_SIZE / sizeof(uint64_t)];
static uint64_t hits_memory[HITS_SIZE / sizeof(uint64_t)];
static tia_rgb565 strip[WIDTH * ROWS];

static int draw(const struct tia_view *view, struct tia_hits *hits, bool trace, uint32_t *crc)
{
    const struct tia_surface surface = {
        .pixels = strip,
        .step = 2,
#if TIA_SWAP
        .swap = true,
#endif
        .pitch = 2 * WIDTH
    };
    int status = TIA_OK;
    for (uint16_t y = 0; y < HEIGHT && !status; y += ROWS) {
        const struct tia_tile tile = {0, y, WIDTH, (uint16_t)(HEIGHT - y < ROWS ? HEIGHT - y : ROWS)};
        count_begin();
        if (!WHOLE)
            status = tia_hits_init(&hits, hits_memory, sizeof hits_memory, view, tile);
        if (trace && !status)
            status = tia_view_trace(view, hits, tile);
        if (!status)
            status = tia_view_light(view, hits, tile, &surface, NULL);
        count_end();
        *crc = tia_crc32(*crc, strip, (size_t)WIDTH * tile.height);
    }
    return status;
}

static int draw_and_tell(const char *name, const struct tia_view *view, struct tia_hits *hits, bool trace)
{
    uint32_t crc = 0;
    int status = draw(view, hits, trace, &crc);
    board_print(!status ? name : "failed ");
    board_print_hex(crc);
    board_print("\n");
    return status;
}

/* Returns the light that a key sets. */
static const struct tia_light *light_of(uint16_t key)
{
    const struct tia_binding *binding = tia_thesis_scene.bindings;
    while (binding->key != key)
        binding++;
    return &binding->state;
}

int main(void)
{
    const struct tia_tile all = {0, 0, WIDTH, HEIGHT};
    struct tia_view *view;
    struct tia_hits *hits = NULL;
    int status =
        CORE.view_init(&CORE, &view, view_memory, sizeof view_memory, &tia_thesis_scene, 1, WIDTH, HEIGHT, NULL);
    if (!status)
        status = tia_view_set_lights(view, light_of('a'), 1);
    if (!status && WHOLE)
        status = tia_hits_init(&hits, hits_memory, sizeof hits_memory, view, all);
    if (!status)
        status = draw_and_tell("full ", view, hits, true);
    if (!status && WHOLE)
        status = draw_and_tell("relit ", view, hits, false);
    return -status;
}
