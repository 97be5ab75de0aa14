/* spheres.c - the example of docs/library.md: three spheres, drawn row by row; writes the pixels to standard output. */
#include <stdio.h>
#include <tia/tia.h>

static const struct tia_material materials[] = {{.colour = TIA_RGB(0.9, 0.3, 0.2)}, {.colour = TIA_RGB(0.7, 0.7, 0.7)}};
static const struct tia_sphere spheres[] = {{TIA_VEC3(-2, 0, -15), TIA_Q16(2), 0},
                                            {TIA_VEC3(1, -1, -12), TIA_Q16(1), 0},
                                            {TIA_VEC3(0, -1002, -15), TIA_Q16(1000), 1}};
static const struct tia_light light = {
    .centre = TIA_VEC3(10, 10, 0), .radius = TIA_Q16(1), .emission = TIA_RGB(1, 1, 1)};
static const struct tia_scene scene = {.camera = {.fov = TIA_Q16(30)},
                                       .background = TIA_RGB(0.5, 0.7, 0.9),
                                       .materials = materials,
                                       .spheres = spheres,
                                       .lights = &light,
                                       .material_count = 2,
                                       .sphere_count = 3,
                                       .light_count = 1};
static const struct tia_rows rows = {.core = &tia_core_spheres, .scene = &scene, .width = 320, .height = 240};
static uint64_t memory[1024];

static int send_row(void *file, unsigned y, const tia_rgb565 *pixels, unsigned width)
{
    (void)y;
    return fwrite(pixels, sizeof *pixels, width, (FILE *)file) == width ? TIA_OK : TIA_ERR_DEVICE;
}

int main(void)
{
    return tia_draw_rows(&rows, memory, sizeof memory, send_row, stdout) != TIA_OK;
}
