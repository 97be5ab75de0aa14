/* crowd.c - draws a frame of SPHERES spheres and LIGHTS lights, row by row, to count instructions, see count.py: the
 * lights are set, and the frame is drawn, between marks. The scene is a ground and balls at random places above it. */
#include "boards/board.h"
#include "marks.h"
#include <tia/debug.h>
#include <tia/tia.h>

enum { WIDTH = 320, HEIGHT = 240, MATERIALS = 6 };

static struct tia_material materials[MATERIALS + 1];
static struct tia_sphere spheres[SPHERES];
static struct tia_light lights[LIGHTS];
static const struct tia_scene scene = {
    .camera = {.eye = {0, TIA_Q16(2), 0}, .fov = TIA_Q16(40)},
    .background = {TIA_Q30(.6), TIA_Q30(.7), TIA_Q30(.8)},
    .materials = materials,
    .material_count = MATERIALS + 1,
    .spheres = spheres,
    .sphere_count = SPHERES,
    .lights = lights,
    .light_count = LIGHTS,
};
static uint64_t view_memory[SPHERES * (21 + (SPHERES + 7) / 8 * LIGHTS / 8) + LIGHTS * 32 + 48];
static uint64_t hits_memory[8 + WIDTH];
static tia_rgb565 row[WIDTH];

/* Returns a number from least to most, the next one of a sequence. */
static int32_t between(uint32_t *state, int32_t least, int32_t most)
{
    *state = *state * UINT32_C(1664525) + UINT32_C(1013904223);
    return least + (int32_t)((uint64_t)(*state >> 8) * (uint32_t)(most - least) >> 24);
}

/* The more balls there are, the smaller they are: they cover about the same part of the picture. */
static void make_scene(void)
{
    static const int32_t most_radius[] = {TIA_Q16(1.2), TIA_Q16(.9), TIA_Q16(.6)};
    int32_t radius = most_radius[(SPHERES > 8) + (SPHERES > 32)];
    uint32_t state = 1;

    for (int i = 0; i <= MATERIALS; i++)
        materials[i].colour =
            (struct tia_rgb){between(&state, 0, TIA_Q30_ONE), between(&state, 0, TIA_Q30_ONE), TIA_Q30(.6)};
    spheres[0] = (struct tia_sphere){{0, TIA_Q16(-10002), TIA_Q16(-20)}, TIA_Q16(10000), MATERIALS};
    for (uint32_t i = 1; i < SPHERES; i++) {
        int32_t r = between(&state, radius / 4, radius);
        spheres[i].centre.x = between(&state, TIA_Q16(-8), TIA_Q16(8));
        spheres[i].centre.y = between(&state, r - TIA_Q16(2), TIA_Q16(4));
        spheres[i].centre.z = between(&state, TIA_Q16(-30), TIA_Q16(-12));
        spheres[i].radius = r;
        spheres[i].material = i % (uint32_t)MATERIALS;
    }
    for (int l = 0; l < LIGHTS; l++) {
        lights[l].centre.x = between(&state, TIA_Q16(-25), TIA_Q16(25));
        lights[l].centre.y = between(&state, TIA_Q16(10), TIA_Q16(25));
        lights[l].centre.z = between(&state, TIA_Q16(-30), TIA_Q16(5));
        lights[l].emission = (struct tia_rgb){TIA_Q30(1.2) / LIGHTS, TIA_Q30(1.2) / LIGHTS, TIA_Q30(1.2) / LIGHTS};
    }
}

int main(void)
{
    const struct tia_core *core = &tia_core_spheres;
    const struct tia_surface surface = {.pixels = row, .step = sizeof *row, .pitch = sizeof row};
    struct tia_view *view;
    struct tia_hits *hits;
    uint32_t crc = 0;

    make_scene();
    int status = core->view_init(core, &view, view_memory, sizeof view_memory, &scene, LIGHTS, WIDTH, HEIGHT, NULL);
    count_begin();
    status = status ? status : tia_view_set_lights(view, lights, LIGHTS);
    count_end();
    for (uint16_t y = 0; y < HEIGHT && !status; y++) {
        const struct tia_tile tile = {0, y, WIDTH, 1};
        count_begin();
        status = tia_hits_init(&hits, hits_memory, sizeof hits_memory, view, tile);
        status = status ? status : tia_view_draw(view, hits, tile, &surface, NULL);
        count_end();
        crc = tia_crc32(crc, row, WIDTH);
    }
    board_print(!status ? "full " : "failed ");
    board_print_hex(crc);
    board_print("\n");
    return -status;
}
