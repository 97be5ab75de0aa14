#include <tia/tia.h>

#include "thesis.h" /* tia-compile scenes/thesis.tia --name thesis --memory thesis.h -s 320x1 -s 64x1 --lights 1 */

static uint64_t view_memory[TIA_WORDS(THESIS_VIEW)], hits_memory[TIA_WORDS(THESIS_HITS_320x1)]; /* a row's hits */
static tia_rgb565 row[320];

int draw(void (*send_row)(unsigned y, const tia_rgb565 *pixels))
{
    const struct tia_core *core = &tia_core_spheres; /* or ..._spheres_small, in less flash; tia_core_q16: any scene */
    const struct tia_surface surface = {.pixels = row, .step = sizeof *row, .pitch = sizeof row};
    struct tia_view *view;
    struct tia_hits *hits;
    int status = core->view_init(core, &view, view_memory, sizeof view_memory, &tia_thesis_scene, 1, 320, 240, NULL);
    if (status == TIA_OK)
        status = tia_view_set_lights(view, &tia_thesis_scene.bindings[0].state, 1); /* key a's light */
    for (uint16_t y = 0; y < 240 && status == TIA_OK; y++) {
        const struct tia_tile tile = {.y = y, .width = 320, .height = 1};
        tia_hits_init(&hits, hits_memory, sizeof hits_memory, view, tile);
        status = tia_view_draw(view, hits, tile, &surface, NULL);
        send_row(y, row);
    }
    return status;
}
