/* light.c - draws ambient occlusion, then light along paths, tile by tile in 64 KiB of RAM, and prints a line for each:
 * the picture's checksum, and the bytes of the view and of a tile's hits; on the board also the peak stack use. */
#include "boxes.h"

#include <tia/debug.h>

/* Sizes of the picture, of tiles, which do not divide it, and of the memory in bytes. Only a strip of pixels is stored.
 */
enum { WIDTH = 64, HEIGHT = 48, TILE_WIDTH = 15, TILE_HEIGHT = 7, MEMORY = 16384 };

static const struct tia_material materials[] = {
    {.colour = {ONE / 4 * 3, ONE / 4 * 3, ONE / 2}},
    {.colour = {ONE / 4, ONE / 4, ONE / 2}, .specular = {ONE / 2, ONE / 2, ONE / 2}, .exponent = Q(40)},
    {.refraction = {ONE, ONE, ONE}, .index = Q(1.5), .fresnel = true},
};
static const struct tia_sphere ball = {{Q(0.25), Q(0.75), Q(2)}, Q(0.75), 2};
static const struct tia_light lamp = {.kind = TIA_RECTANGLE_LIGHT,
                                      .centre = {0, Q(4), 0},
                                      .side = {{Q(1), 0, 0}, {0, 0, Q(1)}},
                                      .emission = {ONE, ONE, ONE},
                                      .emission_bits = 2};
static struct tia_scene scene = {
    .camera = {.eye = {Q(3), Q(4), Q(9)}, .reference = {0, Q(0.5), 0}, .up = {0, Q(1), 0}, .fov = Q(45)},
    .background = {ONE / 8, ONE / 4, ONE / 2},
    .materials = materials,
    .material_count = sizeof materials / sizeof *materials,
    .spheres = &ball,
    .sphere_count = 1,
    .lights = &lamp,
    .light_count = 1,
    .shapes = shapes,
    .shape_count = sizeof shapes / sizeof *shapes,
    .transforms = &turned,
    .transform_count = 1,
};

static uint64_t memory[MEMORY / sizeof(uint64_t)];
static tia_rgb565 strip[WIDTH * TILE_HEIGHT];

#if __STDC_HOSTED__
static void tell_stack(void) {}
#else
static void tell_stack(void)
{
    board_print("stack ");
    board_print_number(board_stack_used());
    board_print("\n");
}
#endif

static uint16_t at_most(unsigned most, unsigned length)
{
    return (uint16_t)(length < most ? length : most);
}

static int draw_strip(const struct tia_view *view, char *hits_memory, size_t size, unsigned y)
{
    struct tia_hits *hits;
    int status = TIA_OK;

    for (unsigned x = 0; x < WIDTH && !status; x += TILE_WIDTH) {
        const struct tia_tile tile = {(uint16_t)x, (uint16_t)y, at_most(TILE_WIDTH, WIDTH - x),
                                      at_most(TILE_HEIGHT, HEIGHT - y)};
        const struct tia_surface surface = {.pixels = strip + x, .step = 2, .pitch = 2 * WIDTH};
        status = tia_hits_init(&hits, hits_memory, size, view, tile);
        status = status ? status : tia_view_draw(view, hits, tile, &surface, NULL);
    }
    return status;
}

static int draw(void)
{
    const struct tia_tile first = {0, 0, TILE_WIDTH, TILE_HEIGHT};
    size_t view_size = tia_view_size(&scene, 1), hits_size = tia_hits_size(&scene, first);
    size_t room = (view_size + 7) / 8 * 8;
    struct tia_view *view;
    uint32_t crc = 0;

    if (room > sizeof memory || hits_size > sizeof memory - room)
        return TIA_ERR_MEMORY;
    int status = tia_view_init(&view, memory, view_size, &scene, 1, WIDTH, HEIGHT, NULL);
    for (unsigned y = 0; y < HEIGHT && !status; y += TILE_HEIGHT) {
        status = draw_strip(view, (char *)memory + room, hits_size, y);
        crc = tia_crc32(crc, strip, (size_t)WIDTH * at_most(TILE_HEIGHT, HEIGHT - y));
    }
    if (!status)
        tell(tia_integrator_name(scene.integration.integrator), crc, view_size, hits_size);
    return status;
}

int main(void)
{
    scene.integration = (struct tia_integration){.integrator = TIA_OCCLUSION, .spp = 4, .distance = Q(2)};
    int status = draw();

    scene.integration = (struct tia_integration){.integrator = TIA_PATHS, .spp = 2};
    status = status ? status : draw();
    tell_stack();
    return -status;
}
