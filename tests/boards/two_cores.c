#include <tia/tia.h>

#include "thesis.h" /* tia-compile scenes/thesis.tia --name thesis --memory thesis.h -s 320x1 --lights 1 */

static uint64_t view_memory[TIA_WORDS(THESIS_VIEW)];
static struct tia_view *view; /* both cores read it */
static struct half {          /* of one core */
    uint64_t hits[TIA_WORDS(THESIS_HITS_320x1)];
    tia_rgb565 row[320];
} halves[2];

/* For one core, while the other does not draw. */
int prepare(const struct tia_light *light)
{
    const struct tia_core *core = &tia_core_spheres;
    int status = TIA_OK;
    if (!view)
        status = core->view_init(core, &view, view_memory, sizeof view_memory, &tia_thesis_scene, 1, 320, 240, NULL);
    return status == TIA_OK ? tia_view_set_lights(view, light, 1) : status;
}

/* Draws every second row on the core `number`, 0 or 1. `send_row` may be called by both at once. */
int draw_half(unsigned number, void (*send_row)(unsigned y, const tia_rgb565 *pixels))
{
    struct half *half = &halves[number];
    const struct tia_surface surface = {.pixels = half->row, .step = sizeof *half->row, .pitch = sizeof half->row};
    struct tia_hits *hits;
    int status = TIA_OK;
    for (unsigned y = number; y < 240 && status == TIA_OK; y += 2) {
        const struct tia_tile tile = {.y = (uint16_t)y, .width = 320, .height = 1};
        tia_hits_init(&hits, half->hits, sizeof half->hits, view, tile);
        status = tia_view_draw(view, hits, tile, &surface, NULL);
        if (status == TIA_OK)
            send_row(y, half->row);
    }
    return status;
}
