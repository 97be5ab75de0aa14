/* trust.c - draws a frame of the built-in scene with the light of key a, strip by strip, and prints the checksum.
 * Instructions between the marks are counted, see count.py: without checks, with a check before the first and after the
 * last strip, with tia_view_draw_checked, and those of the telltale of one rectangle.
 *
 *   ROWS     rows of a strip */
#include "boards/board.h"
#include "marks.h"
#include <tia/debug.h>
#include <tia/tia.h>
#include <tia/trust.h>

enum { WIDTH = 320, HEIGHT = 240, VIEW_SIZE = 2304, HITS_SIZE = 64 + WIDTH * ROWS * 8 };

static uint64_t view_memory[VIEW_SIZE / sizeof(uint64_t)], hits_memory[HITS_SIZE / sizeof(uint64_t)];
static tia_rgb565 strip[WIDTH * ROWS];
static const struct tia_surface surface = {.pixels = strip, .step = 2, .pitch = 2 * WIDTH};
static struct tia_seal seal;
static struct tia_sealed sealed = {.view = view_memory,
                                   .view_size = sizeof view_memory,
                                   .hits = hits_memory,
                                   .hits_size = sizeof hits_memory,
                                   .seal = &seal};

/* A rectangle of 64x64 pixels; its CRC is not known here, and is only computed. */
static const uint32_t crcs[] = {0};
static const struct tia_telltale telltale = {"ball", {128, 88, 64, 64}, crcs};
static const struct tia_telltales telltales = {WIDTH, HEIGHT, &telltale, NULL, 1, 0};

enum way { PLAIN, AROUND, CHECKED, TELLTALE };

static int draw_strip(enum way way, struct tia_tile tile)
{
    struct tia_hits *hits;

    if (way == CHECKED)
        return tia_view_draw_checked(&sealed, tile, &surface, NULL);
    int status = tia_hits_init(&hits, hits_memory, sizeof hits_memory, sealed.view, tile);
    return status ? status : tia_view_draw(sealed.view, hits, tile, &surface, NULL);
}

static int draw(enum way way, uint32_t *crc)
{
    struct tia_telltale_sum sum = {0, 0};
    int status = way == AROUND ? tia_view_check(&sealed) : TIA_OK;

    for (uint16_t y = 0; y < HEIGHT && !status; y += ROWS) {
        const struct tia_tile tile = {0, y, WIDTH, ROWS};
        status = draw_strip(way, tile);
        if (way == TELLTALE && !status)
            status = tia_telltales_add(&telltales, &sum, tile, &surface);
        if (crc)
            *crc = tia_crc32(*crc, strip, WIDTH * ROWS);
    }
    return way == AROUND && !status ? tia_view_check(&sealed) : status;
}

/* Draws for the checksum, then between the marks. */
static int draw_and_tell(const char *name, enum way way)
{
    uint32_t crc = 0;
    int status = draw(way, &crc);

    count_begin();
    status = status ? status : draw(way, NULL);
    count_end();
    board_print(!status ? name : "failed");
    board_print(" ");
    board_print_hex(crc);
    board_print("\n");
    return status;
}

int main(void)
{
    static const char *const names[] = {"plain", "around", "checked", "telltale"};
    const struct tia_core *core = &tia_core_spheres;
    struct tia_view *view;
    int status =
        core->view_init(core, &view, view_memory, sizeof view_memory, &tia_thesis_scene, 1, WIDTH, HEIGHT, NULL);

    sealed.view_size = core->view_size(core, &tia_thesis_scene, 1);
    if (!status)
        status = tia_view_seal(&sealed);
    if (!status)
        status = tia_view_set_lights_checked(&sealed, &tia_thesis_scene.bindings[0].state, 1);
    for (int way = PLAIN; way <= TELLTALE && !status; way++)
        status = draw_and_tell(names[way], (enum way)way);
    return -status;
}
