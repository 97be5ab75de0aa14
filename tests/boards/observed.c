/* observed.c - counts the rays of the pictures that rays.c draws on a board: prints the name of each scene file and the
 * number of its rays, of all kinds. */
#include <stdio.h>
#include <stdlib.h>

#include <tia/debug.h>
#include <tia/tia.h>

#include "common/scene/scene_load.h"

enum { WIDTH = 64, HEIGHT = 48 };

static void add_ray(void *ctx, const struct tia_traced *traced)
{
    (void)traced;
    ++*(unsigned *)ctx;
}

static int count(const struct tia_scene *scene, unsigned *rays)
{
    static tia_rgb565 picture[WIDTH * HEIGHT];
    const struct tia_core *core = &tia_core_watched;
    const struct tia_tile whole = {0, 0, WIDTH, HEIGHT};
    const struct tia_surface surface = {.pixels = picture, .step = 2, .pitch = 2 * WIDTH};
    struct tia_observer observer = {.traced = add_ray, .ctx = rays};
    const struct tia_options options = {.debug = &(struct tia_debug){.observer = &observer}};
    size_t view_size = core->view_size(core, scene, scene->light_count),
           hits_size = core->hits_size(core, scene, whole);
    void *memory[] = {malloc(view_size), malloc(hits_size)};
    struct tia_view *view;
    struct tia_hits *hits;

    int status = memory[0] && memory[1] ? TIA_OK : TIA_ERR_MEMORY;
    status = status
                 ? status
                 : core->view_init(core, &view, memory[0], view_size, scene, scene->light_count, WIDTH, HEIGHT, NULL);
    status = status ? status : tia_hits_init(&hits, memory[1], hits_size, view, whole);
    status = status ? status : tia_view_draw(view, hits, whole, &surface, &options);
    free(memory[0]);
    free(memory[1]);
    return status;
}

int main(int argc, char **argv)
{
    for (int i = 1; i < argc; i++) {
        struct scene_file file;
        unsigned rays = 0;
        int status = scene_open(&file, argv[i], scene_format_of(argv[i]), false);

        if (status) {
            (void)fprintf(stderr, "observed: %s\n", file.why);
            return 1;
        }
        status = count(&file.scene, &rays);
        scene_close(&file);
        if (status)
            return 1;
        printf("%s %u\n", argv[i], rays);
    }
    return 0;
}
