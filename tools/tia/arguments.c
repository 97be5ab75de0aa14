#include "arguments.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "arithmetic.h"
#include "common/parse.h"
#include "common/pressed_keys.h"
#include "common/thread_pool.h"
#include "eye_setup.h"
#include "fail.h"
#include "integration.h"
#include "lightfield_setup.h"
#include "options_check.h"
#include "write.h"

/* Chooses the widest instruction set that the processor has and TIA_SIMD allows. */
static int choose_simd(struct options *options)
{
    const char *most = getenv("TIA_SIMD");

    options->simd = tia_simd_best();
    if (most && tia_simd_named(most, &options->simd))
        return fail(EXIT_USAGE, "TIA_SIMD '%.200s': not plain, scalar, sse41, avx2, avx512, neon, rvv or wasm", most);
    return EXIT_FINE;
}

void arguments_default(struct options *options)
{
    *options = (struct options){.scene_format = SCENE_UNKNOWN,
                                .scene = tia_thesis_scene,
                                .core = &tia_core_q16,
                                .gaze = {.w0 = TIA_GAZE_W0, .m = TIA_GAZE_M},
                                .display = {"auto", NULL},
                                .input = {"auto", NULL},
                                .rate = {25, 1},
                                .threads = threads_processors()};
}

int arguments_check(struct options *options, int argc, char **argv)
{
    options->scene_path = argv[0]; /* NULL if no scene is given */
    options->scene_paths = argv;
    options->scene_count = (uint32_t)argc;
    options->format_of_scenes = options->scene_format;
    options->plain_core = options->core;
    options->depth_bits = 8 * options->colour;
    int status = check(options);
    return status ? status : choose_simd(options);
}

/* Stores an option as it was given. Without memory, options->given_bytes becomes SIZE_MAX. */
static void remember(void *ctx, const struct option_row *row, const char *value)
{
    struct options *options = ctx;
    size_t used = options->given_bytes, length = strlen(row->name) + 1 + (value ? strlen(value) + 1 : 0);
    char *given = used < SIZE_MAX ? realloc(options->given, used + length) : NULL;

    options->given_bytes = given ? used + length : SIZE_MAX;
    if (!given)
        return;
    options->given = given;
    (void)snprintf(given + used, length, "%s%s%s", row->name, value ? "=" : "", value ? value : "");
}

int arguments_parse(struct options *options, int argc, char **argv)
{
    const struct command_extra extra = {.seen = remember, .ctx = options};

    arguments_default(options);
    int status = command_parse_extra(&tia_command, &extra, options, &argc, &argv);
    if (status != COMMAND_RUN)
        return status;
    status = arguments_check(options, argc, argv);
    return status ? status : COMMAND_RUN;
}

/* ---- loading the scene and its keys ---- */

/* Lists the keys that keys_parse accepts, for a message: "a d s w <left> ...". */
static void name_keys(const struct tia_scene *scene, char *text, size_t size)
{
    size_t used = 0;
    text[0] = '\0';
    for (uint32_t i = 0; i < scene->binding_count && used + 60 < size; i++) {
        uint16_t key = scene->bindings[i].key;
        if (key > ' ' && key < 127)
            used += (size_t)snprintf(text + used, size - used, "%c ", key);
    }
    (void)snprintf(text + used, size - used, "<left> <right> <up> <down> <pgup> <pgdn>");
}

static int load_keys(struct options *options)
{
    const char *text = options->key_text, *bad;
    char names[300];
    if (!text)
        return EXIT_FINE;
    options->keys = malloc((strlen(text) + 1) * sizeof *options->keys);
    if (!options->keys)
        return fail(EXIT_RUNNING, "memory: exhausted");
    if (!keys_parse(text, &options->scene, options->keys, &options->key_count, &bad)) {
        name_keys(&options->scene, names, sizeof names);
        return fail(EXIT_USAGE, "--keys '%.200s': no key that moves the light (%s)", bad, names);
    }
    return EXIT_FINE;
}

void arguments_warn(const struct scene_file *file)
{
    char line[SCENE_WHY];
    for (unsigned at = 0; scene_warning(file, &at, line);)
        note("%s", line);
}

static int load_map(struct options *options)
{
    struct tia_shadow_map *map = &options->scene.shadow_map;
    const struct tia_shadow_map *given = &options->map;

    if (options->scene.shadows != TIA_SHADOWS_MAP && (given->size || given->bias || given->filter))
        return fail(EXIT_USAGE, "--%s: only shadow maps have it (--shadows map)",
                    given->size   ? "map-size"
                    : given->bias ? "bias"
                                  : "filter");
    map->size = given->size ? given->size : map->size;
    map->filter = given->filter ? given->filter : map->filter;
    map->amount = given->bias ? given->amount : map->amount;
    map->amount_bits = given->bias ? given->amount_bits : map->amount_bits;
    map->bias = given->bias ? given->bias : map->bias;
    return EXIT_FINE;
}

static int load_tessellated(const char *error, struct tia_scene *scene)
{
    if (error && (!parse_scaled(error, scene->scale_bits, &scene->tessellated) ||
                  (!scene->tessellated && strpbrk(error, "123456789"))))
        return fail(EXIT_USAGE, "--tessellated %.200s: not a length (0 to %u, like 0.01)", error,
                    parse_longest(scene->scale_bits));
    return EXIT_FINE;
}

/* Applies --shadows and its options; reports the first part of the scene that the technique cannot draw. */
static int load_shadows(struct options *options)
{
    struct tia_scene *scene = &options->scene;
    const struct tia_shadow_map *map = &options->map;
    bool given = options->shadows || map->size || map->bias || map->filter || options->tessellated;
    struct tia_fault fault;

    if (options->shadows)
        scene->shadows = (enum tia_shadows)(options->shadows - 1);
    int status = load_map(options);
    status = status ? status : load_tessellated(options->tessellated, scene);
    if (status || !given || !tia_scene_check(scene, &fault))
        return status;
    return fail(EXIT_USAGE, "--shadows %s: %s %u: %s: %s", tia_shadows_name(scene->shadows), fault.thing,
                (unsigned)fault.index, fault.field, fault.rule);
}

/* Applies --view and --draw-rays, which need the fixed-point core and Whitted's integrator. */
static int load_views(struct options *options)
{
    const struct views *views = &options->views;
    const char *option = views->draws_rays ? "draw-rays" : "view";

    options->plain_scene = options->scene;
    if (views->view == VIEW_COLOUR && !views->draws_rays)
        return EXIT_FINE;
    if (!arithmetic_watched())
        return fail(EXIT_USAGE, "--%s: not built in (make builds it)", option);
    if (options->core != &tia_core_q16)
        return fail(EXIT_USAGE, "--%s: not with --arithmetic: it shows the rays of integers", option);
    if (options->scene.integration.integrator)
        return fail(EXIT_USAGE, "--%s: not with --integrator: it shows Whitted's rays", option);
    arguments_set_view(options);
    return EXIT_FINE;
}

void arguments_set_view(struct options *options)
{
    const struct views *views = &options->views;

    options->scene = options->plain_scene;
    options->core = options->plain_core;
    if (views->view == VIEW_COLOUR && !views->draws_rays)
        return;
    views_need_rays(&options->scene);
    options->core = views_core(views, arithmetic_watched());
}

int arguments_load(struct options *options)
{
    int status = options->scene_path ? eye_open(options) : EXIT_FINE;
    if (status)
        return status;
    if (options->scene_path)
        arguments_warn(&options->file);
    status = eye_load(options);
    if (options->samples != 0)
        options->scene.camera.samples = options->samples;
    if (options->depth != 0)
        options->scene.depth = options->depth;
    status = status ? status : load_shadows(options);
    status = status ? status : light_load(options);
    status = status ? status : integration_load(options);
    status = status ? status : load_views(options);
    return status ? status : load_keys(options);
}

void arguments_free(struct options *options)
{
    free(options->keys);
    options->keys = NULL;
    free(options->given);
    options->given = NULL;
    scene_close(&options->file);
    write_free_names(&options->names);
}
