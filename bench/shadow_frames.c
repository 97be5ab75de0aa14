#include "shadow_frames.h"

#include "common/scene/scene_load.h"
#include "milliseconds.h"
#include "shadow_scene.h"
#include "simd_rays.h"
#include "viewer/strips.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <tia/tia.h>

#define ROUNDS 7
#define PATIENCE 250 /* milliseconds after which no third round begins */

static const struct technique {
    const char *name;
    enum tia_shadows shadows;
    uint16_t map_size;
} techniques[] = {{"traced", TIA_SHADOWS_TRACED, 0},      {"rays", TIA_SHADOWS_RAYS, 0},
                  {"zpass", TIA_SHADOWS_ZPASS, 0},        {"zfail", TIA_SHADOWS_ZFAIL, 0},
                  {"map 512", TIA_SHADOWS_MAP, 512},      {"map 1024", TIA_SHADOWS_MAP, 1024},
                  {"map-exact", TIA_SHADOWS_MAP_EXACT, 0}};

#define TECHNIQUES ((int)(sizeof techniques / sizeof *techniques))

static const struct drawn_case {
    uint16_t width, height;
    int level;
    uint32_t lights;
} cases[] = {{640, 480, 0, 1},   {640, 480, 1, 1},   {640, 480, 2, 1},   {640, 480, 3, 1},
             {640, 480, 4, 1},   {640, 480, 5, 1},   {640, 480, 2, 2},   {640, 480, 2, 4},
             {320, 240, 2, 1},   {1280, 960, 2, 1},  {1920, 1080, 0, 1}, {1920, 1080, 1, 1},
             {1920, 1080, 2, 1}, {1920, 1080, 3, 1}, {1920, 1080, 4, 1}, {1920, 1080, 5, 1}};

#define CASES ((int)(sizeof cases / sizeof *cases))

struct times {
    double frame, relit;
};

static struct {
    uint32_t faces;
    struct times of[TECHNIQUES];
} results[CASES];

struct shown {
    struct tia_tile area;
    unsigned rows; /* of a strip */
    struct tia_view *view;
    struct tia_hits *hits;
    struct tia_surface surface;
    void *memory[3];
};

static void open_frame(struct shown *f, const struct tia_scene *scene, uint16_t width, uint16_t height)
{
    f->area = (struct tia_tile){0, 0, width, height};
    f->rows = tia_strips_raster_rows(scene, width, height, 1);
    const struct tia_simd *simd = tia_simd_best();
    size_t sizes[3] = {tia_view_size(scene, scene->light_count), tia_hits_size(scene, f->area),
                       tia_simd_size(simd, scene, scene->light_count, 1)};
    for (int i = 0; i < 3; i++) {
        f->memory[i] = malloc(sizes[i] + 1); /* + 1, since tia_simd_size may be 0 */
        shadow_must(f->memory[i] != NULL);
    }
    f->surface = (struct tia_surface){.pixels = malloc((size_t)width * height * 2), .step = 2, .pitch = 2 * width};
    shadow_must(f->surface.pixels &&
                !tia_view_init(&f->view, f->memory[0], sizes[0], scene, scene->light_count, width, height, NULL));
    shadow_must(!tia_view_set_simd(f->view, simd, f->memory[2], sizes[2]));
    shadow_must(!tia_hits_init(&f->hits, f->memory[1], sizes[1], f->view, f->area));
}

static void close_frame(struct shown *f)
{
    free(f->surface.pixels);
    for (int i = 0; i < 3; i++)
        free(f->memory[i]);
}

/* Draws a frame strip by strip, as tia does; `relit`: only its lights have moved, and visible points are known. Returns
 * the milliseconds. */
static double draw(const struct shown *f, const struct tia_scene *scene, bool relit)
{
    struct tia_surface surface = f->surface;
    struct tia_tile strip = f->area;
    double start = cpu_milliseconds();

    shadow_must(!tia_view_set_lights(f->view, scene->lights, scene->light_count));
    for (unsigned y = 0; y < f->area.height; y += f->rows) {
        strip.y = (uint16_t)y;
        strip.height = (uint16_t)(f->area.height - y < f->rows ? f->area.height - y : f->rows);
        surface.pixels = f->surface.pixels + (size_t)y * f->area.width;
        shadow_must((relit || !tia_view_trace(f->view, f->hits, strip)) &&
                    !tia_view_light(f->view, f->hits, strip, &surface, NULL));
    }
    return cpu_milliseconds() - start;
}

/* Measures frames, and such after lights have moved. */
static void measure(struct times *least, const struct tia_scene *scene, const struct drawn_case *c)
{
    double spent = 0;
    struct shown f;

    open_frame(&f, scene, c->width, c->height);
    for (int round = 0; round < 2 || (round < ROUNDS && spent < PATIENCE); round++) {
        double frame = draw(&f, scene, false);
        keep_least(&least->frame, frame);
        keep_least(&least->relit, draw(&f, scene, true));
        spent += frame;
    }
    close_frame(&f);
}

static void measure_case(int index, struct shadow_scene *s)
{
    const struct drawn_case *c = &cases[index];

    shadow_scene_make(s, c->level);
    results[index].faces = s->mesh.count;
    s->scene.light_count = c->lights;
    size_t size = tia_bvh_size(&s->scene);
    void *boxes = malloc(size);
    shadow_must(boxes && !tia_bvh_build(&s->scene.bvh, boxes, size, NULL, &s->scene, NULL));
    for (int i = 0; i < TECHNIQUES; i++) {
        s->scene.shadows = techniques[i].shadows;
        s->scene.shadow_map = (struct tia_shadow_map){.size = techniques[i].map_size};
        measure(&results[index].of[i], &s->scene, c);
    }
    free(boxes);
}

/* Ends the row of a table's names, and prints the line below: `first`, and a column for each technique. */
static void print_rule(const char *first)
{
    printf("\n%s", first);
    for (int i = 0; i < TECHNIQUES; i++)
        printf("--:|");
    printf("\n");
}

static void print(const char *what, bool relit)
{
    printf("\n| %s, ms: size | faces | lights |", what);
    for (int i = 0; i < TECHNIQUES; i++)
        printf(" %s |", techniques[i].name);
    print_rule("|---|--:|--:|");
    for (int k = 0; k < CASES; k++) {
        printf("| %ux%u | %u | %u |", cases[k].width, cases[k].height, results[k].faces, cases[k].lights);
        for (int i = 0; i < TECHNIQUES; i++)
            printf(" %.1f |", relit ? results[k].of[i].relit : results[k].of[i].frame);
        printf("\n");
    }
}

void bench_shadow_frames(void)
{
    struct shadow_scene s;

    shadow_scene_init(&s);
    for (int i = 0; i < CASES; i++)
        measure_case(i, &s);
    shadow_scene_free(&s);
    print("frame", false);
    print("frame with moved lights", true);
}

/* ---- scene files ---- */

static const char *const files[] = {
    "scenes/shadow-volume.tia",    "scenes/shadow-mapping.tia", "scenes/shadows/open.tia", "scenes/shadows/place.tia",
    "scenes/shadows/receiver.tia", "scenes/shadows/caster.tia", "scenes/shadows/soft.tia", "scenes/porch.tia"};

/* Measures a scene file with each technique, and prints the time of traced rays and the others' ratios to it. */
static void measure_file(const char *path, uint16_t width, uint16_t height)
{
    struct drawn_case c = {.width = width, .height = height};
    double traced = 0;
    struct scene_file file;

    shadow_must(!scene_open(&file, path, scene_format_of(path), true));
    printf("| %s | %ux%u |", path, width, height);
    for (int i = 0; i < TECHNIQUES; i++) {
        struct times least = {0, 0};
        file.scene.shadows = techniques[i].shadows;
        file.scene.shadow_map.size = techniques[i].map_size;
        measure(&least, &file.scene, &c);
        traced = i == 0 ? least.frame : traced;
        printf(i == 0 ? " %.1f |" : " %.2f |", i == 0 ? traced : least.frame / traced);
        (void)fflush(stdout);
    }
    printf("\n");
    scene_close(&file);
}

void bench_shadow_files(void)
{
    printf("\n| scene | size | traced, ms |");
    for (int i = 1; i < TECHNIQUES; i++)
        printf(" %s/traced |", techniques[i].name);
    print_rule("|---|---|");
    for (size_t i = 0; i < sizeof files / sizeof *files; i++)
        if (!bench_scene || strstr(files[i], bench_scene)) {
            measure_file(files[i], 640, 480);
            measure_file(files[i], 1920, 1080);
        }
}
