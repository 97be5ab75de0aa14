/* shadows.c - draws a scene of flat faces tile by tile, with each technique for shadows, and prints a line for each:
 * the picture's checksum, and the bytes of the view and of a tile's hits. Instructions between the marks are counted,
 * see count.py. */
#include "boxes.h"

#include "marks.h"
#include <tia/debug.h>

enum { WIDTH = 160, HEIGHT = 120, TILE_WIDTH = 32, TILE_HEIGHT = 24, MEMORY = 1 << 20 };

static const struct tia_material materials[] = {{.colour = {ONE, ONE / 2, ONE / 4}}, {.colour = {ONE / 2, ONE, ONE}}};
static const struct tia_light lights[] = {
    {.centre = {Q(4), Q(7), Q(5)}, .emission = {ONE / 2, ONE / 2, ONE / 2}},
    {.kind = TIA_DIRECTIONAL_LIGHT,
     .direction = {ONE / 2, -ONE / 2, -ONE / 4},
     .emission = {ONE / 4, ONE / 4, ONE / 2}},
};
static struct tia_scene scene = {
    .camera = {.eye = {Q(3), Q(4), Q(9)}, .reference = {0, Q(0.5), 0}, .up = {0, Q(1), 0}, .fov = Q(45)},
    .background = {ONE / 8, ONE / 4, ONE / 2},
    .materials = materials,
    .material_count = 2,
    .lights = lights,
    .light_count = 2,
    .shapes = shapes,
    .shape_count = sizeof shapes / sizeof *shapes,
    .transforms = &turned,
    .transform_count = 1,
    .shadow_map = {.size = TIA_MAP_SIZE_MIN},
};

static uint64_t memory[MEMORY / sizeof(uint64_t)];
static tia_rgb565 picture[WIDTH * HEIGHT];

static int draw_tile(const struct tia_view *view, char *hits_memory, size_t size, struct tia_tile tile)
{
    const struct tia_surface surface = {
        .pixels = picture + (size_t)tile.y * WIDTH + tile.x, .step = 2, .pitch = 2 * WIDTH};
    struct tia_hits *hits;
    int status = tia_hits_init(&hits, hits_memory, size, view, tile);

    return status ? status : tia_view_draw(view, hits, tile, &surface, NULL);
}

static int draw(void)
{
    const struct tia_tile first = {0, 0, TILE_WIDTH, TILE_HEIGHT};
    size_t view_size = tia_view_size(&scene, scene.light_count), hits_size = tia_hits_size(&scene, first);
    size_t room = (view_size + 7) / 8 * 8;
    struct tia_view *view;

    if (room > sizeof memory || hits_size > sizeof memory - room)
        return TIA_ERR_MEMORY;
    int status = tia_view_init(&view, memory, view_size, &scene, scene.light_count, WIDTH, HEIGHT, NULL);
    count_begin();
    for (uint16_t y = 0; y < HEIGHT; y += TILE_HEIGHT)
        for (uint16_t x = 0; x < WIDTH && !status; x += TILE_WIDTH)
            status =
                draw_tile(view, (char *)memory + room, hits_size, (struct tia_tile){x, y, TILE_WIDTH, TILE_HEIGHT});
    count_end();
    if (!status)
        tell(tia_shadows_name(scene.shadows), tia_crc32(0, picture, sizeof picture / sizeof *picture), view_size,
             hits_size);
    return status;
}

int main(void)
{
    int status = TIA_OK;

    for (unsigned i = 0; !status && tia_shadows_name(i); i++) {
        scene.shadows = (enum tia_shadows)i;
        status = draw();
    }
    return -status;
}
