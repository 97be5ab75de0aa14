/* Faces without gloss, whose colours are computed with fewer bits and a bound, against the same pixels ray by ray: with
 * tia_debug.lit all of them are drawn by rays. No byte differs. */
#include <stdlib.h>
#include <tia/debug.h>
#include <tia/tia.h>

#include "check.h"
#include "flat_scene.h"

#define WIDTH 160
#define HEIGHT 120

static void *allocated(size_t size)
{
    void *p = malloc(size);

    if (!p)
        abort();
    return p;
}

static size_t differing(const struct tia_scene *scene, bool dither)
{
    static tia_rgb565 pixels[2][WIDTH * HEIGHT];
    static uint64_t lit[WIDTH * HEIGHT];
    struct tia_tile all = {0, 0, WIDTH, HEIGHT};
    size_t sizes[2] = {tia_view_size(scene, scene->light_count), tia_hits_size(scene, all)}, wrong = 0;
    void *memory[2] = {allocated(sizes[0]), allocated(sizes[1])};
    struct tia_view *view;
    struct tia_hits *hits;

    CHECK_EQ(tia_view_init(&view, memory[0], sizes[0], scene, scene->light_count, WIDTH, HEIGHT, NULL), TIA_OK);
    CHECK_EQ(tia_hits_init(&hits, memory[1], sizes[1], view, all), TIA_OK);
    CHECK_EQ(tia_view_trace(view, hits, all), TIA_OK);
    for (int i = 0; i < 2; i++) {
        struct tia_surface surface = {
            .pixels = pixels[i], .step = sizeof(tia_rgb565), .pitch = WIDTH * sizeof(tia_rgb565)};
        struct tia_options options = {.dither = dither, .debug = &(struct tia_debug){.lit = i ? lit : NULL}};
        CHECK_EQ(tia_view_light(view, hits, all, &surface, &options), TIA_OK);
    }
    for (size_t i = 0; i < WIDTH * HEIGHT; i++)
        wrong += pixels[0][i] != pixels[1][i];
    free(memory[0]);
    free(memory[1]);
    return wrong;
}

TEST(diffuse_faces_have_the_colours_of_rays)
{
    for (int round = 0; round < (int)check_count(150); round++) {
        struct tia_scene scene = flat_scene();
        size_t wrong = differing(&scene, round % 2);
        CHECK_MSG(wrong == 0, "scene %d: %zu pixels differ", round, wrong);
    }
}

int main(void)
{
    RUN(diffuse_faces_have_the_colours_of_rays);
    return check_status();
}
