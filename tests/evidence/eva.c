/* eva.c - draws every STEP-th row from FIRST on of the built-in scene in a state of its light, as the program of
 * docs/boards.md does, and shows a number of each row's pixels: Frama-C's Eva interprets it, and the same program runs.
 *
 * STATE 0 is without a light; 1 to 4 have the lights of the keys a, d, s, w. */
#include <tia/tia.h>

#ifdef __FRAMAC__
extern void Frama_C_show_each_row(int state, int y, uint32_t number);
#define SHOW Frama_C_show_each_row
#else
#include <stdio.h>
#define SHOW(state, y, number) ((void)printf("%d %d %lu\n", state, y, (unsigned long)(number)))
#endif

enum { WIDTH = 320, HEIGHT = 240 };

extern const struct tia_scene thesis;

static uint64_t view_memory[(VIEW_BYTES + 7) / 8], hits_memory[(HITS_BYTES + 7) / 8];
static tia_rgb565 row[WIDTH];

static int draw(struct tia_view *view, uint16_t y)
{
    const struct tia_surface surface = {.pixels = row, .step = sizeof *row, .pitch = sizeof row};
    const struct tia_tile tile = {.y = y, .width = WIDTH, .height = 1};
    struct tia_hits *hits;
    int status = tia_hits_init(&hits, hits_memory, sizeof hits_memory, view, tile);

    return status ? status : tia_view_draw(view, hits, tile, &surface, NULL);
}

int main(void)
{
    const struct tia_core *core = &tia_core_spheres_small;
    struct tia_view *view;
    int status = core->view_init(core, &view, view_memory, sizeof view_memory, &thesis, 1, WIDTH, HEIGHT, NULL);

    if (status == TIA_OK && STATE)
        status = tia_view_set_lights(view, &thesis.bindings[STATE ? STATE - 1 : 0].state, 1);
    for (uint16_t y = FIRST; y < HEIGHT && status == TIA_OK; y += STEP) {
        uint32_t number = 0;
        status = draw(view, y);
        for (int x = 0; x < WIDTH; x++)
            number = number * 31 + row[x];
        if (status == TIA_OK)
            SHOW(STATE, y, number);
    }
    return status;
}
