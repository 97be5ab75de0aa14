#include <tia/tia.h>

#include "thesis.h" /* tia-compile scenes/thesis.tia --name thesis --memory thesis.h -s 320x1 -s 64x1 --lights 1 */

static uint64_t memory[TIA_WORDS(THESIS_ROWS_320 - THESIS_HITS_320x1 + THESIS_HITS_64x1)]; /* 64 columns at once */

int draw(int (*send_row)(void *panel, unsigned y, const tia_rgb565 *pixels, unsigned width), void *panel)
{
    const struct tia_rows rows = {.core = &tia_core_spheres, /* or ..._spheres_small; tia_core_q16 draws any scene */
                                  .scene = &tia_thesis_scene,
                                  .lights = &tia_thesis_scene.bindings[0].state, /* key a's light */
                                  .light_count = 1,
                                  .width = 320,
                                  .height = 240,
                                  .columns = 64}; /* whole rows take less time and 2 KB more */
    return tia_draw_rows(&rows, memory, sizeof memory, send_row, panel);
}
