/* tia-compile scenes/thesis.tia --name thesis -o telltales.c --crc 320x240 --rectangle ball=96,56,128,128
 *     --memory telltales.h -s 320x8 --lights 1 */
#include <tia/tia.h>
#include <tia/trust.h>

#include "telltales.h"

enum { ROWS = 8 };

extern const struct tia_telltales thesis_telltales;

static uint64_t view_memory[TIA_WORDS(THESIS_VIEW)], hits_memory[TIA_WORDS(THESIS_HITS_320x8)];
static tia_rgb565 strip[320 * ROWS];
static struct tia_seal seal;
static struct tia_telltale_sum sums[1];

/* A constant: the addresses are in the program, where no changed bit of the RAM reaches them. */
static const struct tia_sealed sealed = {view_memory, sizeof view_memory, hits_memory, sizeof hits_memory, &seal, true};

int prepare(void)
{
    struct tia_view *view;
    int status = tia_core_spheres.view_init(&tia_core_spheres, &view, view_memory, sizeof view_memory,
                                            &tia_thesis_scene, 1, 320, 240, NULL);
    return status ? status : tia_view_seal(&sealed);
}

/* Draws the frame of a state: 0 has no light, the others have those of the keys a, d, s, w. Returns TIA_OK only if the
 * view was as prepared, before and after each strip, and the rectangle is what the build machine has drawn. */
int draw(uint32_t state, void (*send_strip)(struct tia_tile tile, tia_rgb565 *pixels))
{
    const struct tia_surface surface = {.pixels = strip, .step = sizeof *strip, .pitch = 320 * sizeof *strip};
    const struct tia_light *light = state ? &tia_thesis_scene.bindings[state - 1].state : NULL;
    int status = tia_view_set_lights_checked(&sealed, light, light ? 1 : 0);

    for (uint16_t y = 0; y < 240 && status == TIA_OK; y += ROWS) {
        const struct tia_tile tile = {.y = y, .width = 320, .height = ROWS};
        status = tia_view_draw_checked(&sealed, tile, &surface, NULL);
        if (status == TIA_OK) {
            send_strip(tile, strip);
            status = tia_telltales_add(&thesis_telltales, sums, tile, &surface);
        }
    }
    return status ? status : tia_telltales_check(&thesis_telltales, sums, state, NULL);
}
