#include "shadows_compare.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <tia/debug.h>

#include "common/light_copy.h"
#include "common/message.h"
#include "common/pressed_keys.h"
#include "common/scene/scene_load.h"
#include "common/scene/scene_report.h"
#include "heatmap_files.h"
#include "shadows_report.h"
#include "technique_frame.h"

/* Verdicts; in a picture, later ones hide the earlier. */
enum shadow_verdict { RIGHT, OTHER_OBJECT, WRONGLY_DARK, WRONGLY_LIT };

static const tia_rgb565 colours[] = {[OTHER_OBJECT] = 0xffe0, [WRONGLY_DARK] = 0x001f, [WRONGLY_LIT] = 0xf800};

#define TECHNIQUES HEATMAP_PANELS

struct comparison {
    const struct options *options;
    struct shadows_report report;
    struct pictures pictures;
    const char *name; /* name of the scene */
    struct technique_job job;
    uint64_t mask; /* bits of the light samples that are compared, as in struct tia_debug */
    struct technique_frame reference;
    struct shadows_row rows[TECHNIQUES];
    unsigned count; /* number of rows; the first one is the reference's */
    struct heatmap map;
};

static int failed(int result, const char *what, const char *why)
{
    return message_why("tia-compare", result, what, why);
}

/* ---- techniques ---- */

static bool is_wanted(const struct comparison *c, unsigned technique)
{
    return !c->options->technique || !strcmp(c->options->technique, tia_shadows_name(technique));
}

static bool qualifies(const struct tia_scene *scene, unsigned technique, struct tia_fault *fault)
{
    struct tia_scene tried = *scene;

    tried.shadows = (enum tia_shadows)technique;
    return !tia_scene_check(&tried, fault);
}

/* Returns the technique of the reference: exact rays if the scene qualifies for them, else traced rays. */
static unsigned reference_of(const struct tia_scene *scene)
{
    struct tia_fault fault;
    unsigned i = 0;

    while (tia_shadows_name(i) && strcmp(tia_shadows_name(i), "rays") != 0)
        i++;
    return tia_shadows_name(i) && qualifies(scene, i, &fault) ? i : TIA_SHADOWS_TRACED;
}

/* ---- lights ---- */

static unsigned samples_of(const struct tia_light *light)
{
    if (tia_light_has(light->kind, TIA_LIGHT_EVERYWHERE))
        return 0;
    return !tia_light_has(light->kind, TIA_LIGHT_AREA) ? 1
           : light->samples                            ? light->samples
                                                       : TIA_LIGHT_SAMPLES_DEFAULT;
}

/* Returns the bits of the samples of light number `light`, from 1. */
static uint64_t bits_of(const struct lights *lights, unsigned light)
{
    unsigned before = 0, samples = samples_of(&lights->array[light - 1]);

    for (unsigned i = 0; i + 1 < light; i++)
        before += samples_of(&lights->array[i]);
    uint64_t upto = before + samples >= 64 ? UINT64_MAX : (UINT64_C(1) << (before + samples)) - 1;
    return before >= 64 ? 0 : upto >> before << before;
}

static int choose_lights(struct comparison *c, struct lights *lights)
{
    const struct options *o = c->options;
    const char *keys = o->keys ? o->keys : "", *bad;
    uint16_t *pressed = malloc((strlen(keys) + 1) * sizeof *pressed);
    size_t count;

    if (!pressed || !lights_copy(lights, c->job.scene)) {
        free(pressed);
        return failed(1, c->name, "out of memory");
    }
    bool known = keys_parse(keys, c->job.scene, pressed, &count, &bad);
    if (known)
        lights_press(lights, c->job.scene, pressed, count);
    free(pressed);
    c->job.lights = lights->array;
    c->job.light_count = lights->count;
    c->job.light_capacity = lights->capacity;
    if (!known)
        return failed(2, c->name, "--keys: no key that moves a light");
    if (o->light > lights->count)
        return failed(2, c->name, "--light: it has no such light");
    c->mask = o->light ? bits_of(lights, o->light) : UINT64_MAX;
    return c->mask ? 0 : failed(2, c->name, "--light: an ambient light has no shadows");
}

/* ---- pixels ---- */

static enum shadow_verdict judge(const struct comparison *c, const struct technique_frame *got, size_t i,
                                 struct shadows_row *row)
{
    const struct technique_frame *want = &c->reference;

    row->colours += got->pixels[i] != want->pixels[i];
    if (got->object[i] != want->object[i]) {
        row->objects++;
        return OTHER_OBJECT;
    }
    bool dark = want->lit[i] & ~got->lit[i] & c->mask, lit = got->lit[i] & ~want->lit[i] & c->mask;
    row->dark += dark;
    row->lit += lit;
    return lit ? WRONGLY_LIT : dark ? WRONGLY_DARK : RIGHT;
}

/* Adds the row of a frame. Adds its panel to the heatmap, unless the frame is the reference. */
static void add_frame(struct comparison *c, const struct technique_frame *frame, struct shadows_row *row)
{
    bool is_reference = frame == &c->reference;
    unsigned char *verdict = c->options->heatmap && !is_reference ? c->map.verdict[c->map.panels++] : NULL;

    row->fits = true;
    row->wall_us = frame->wall_us;
    row->cpu_us = frame->cpu_us;
    row->bytes = frame->bytes;
    for (size_t i = 0; i < (size_t)c->job.width * c->job.height; i++) {
        enum shadow_verdict v = judge(c, frame, i, row);
        if (verdict)
            verdict[i] = (unsigned char)v;
    }
}

static int draw(struct comparison *c, struct technique_frame *frame, unsigned technique)
{
    struct shadows_row *row = &c->rows[c->count++];

    *row = (struct shadows_row){.name = tia_shadows_name(technique)};
    if (!qualifies(c->job.scene, technique, &row->fault))
        return 0;
    int status = technique_draw(frame, &c->job, (enum tia_shadows)technique);
    if (status == TIA_ERR_RANGE) {
        row->fault = (struct tia_fault){0};
        return 0;
    }
    if (status)
        return failed(1, c->name, "out of memory");
    add_frame(c, frame, row);
    return 0;
}

static int draw_others(struct comparison *c, unsigned reference)
{
    int result = 0;

    for (unsigned i = 0; tia_shadows_name(i) && c->count < TECHNIQUES && result == 0; i++) {
        struct technique_frame frame = {0};
        if (i == reference || !is_wanted(c, i))
            continue;
        result = draw(c, &frame, i);
        technique_free(&frame);
    }
    return result;
}

/* ---- a scene ---- */

/* Returns an array with true for each mesh that is closed, to be freed by free(); NULL if there is no memory. */
static bool *check_meshes(const struct tia_scene *scene)
{
    bool *is_closed = calloc((size_t)scene->mesh_count + 1, sizeof *is_closed);

    for (uint32_t i = 0; is_closed && i < scene->mesh_count; i++) {
        void *room = malloc(tia_shadow_mesh_room(&scene->meshes[i]) + 1);
        is_closed[i] = room && tia_shadow_mesh_closes(&scene->meshes[i], room);
        if (!room) {
            free(is_closed);
            is_closed = NULL;
        }
        free(room);
    }
    return is_closed;
}

static int tell(struct comparison *c)
{
    bool *is_closed = check_meshes(c->job.scene);
    size_t count = (size_t)c->job.width * c->job.height;
    struct shadows_table table = {.scene = c->name,
                                  .reference = c->rows[0].name,
                                  .width = c->job.width,
                                  .height = c->job.height,
                                  .light = c->options->light,
                                  .rows = c->rows,
                                  .count = c->count,
                                  .is_closed = is_closed,
                                  .meshes = c->job.scene->mesh_count};

    if (!is_closed)
        return failed(1, c->name, "out of memory");
    for (size_t i = 0; i < count; i++)
        table.seen += c->reference.object[i] != TIA_NO_OBJECT;
    shadows_report_scene(&c->report, &table);
    free(is_closed);
    return 0;
}

/* Returns 0; or 2, after an error message, if the scene qualifies for none of the selected techniques but traced
 * rays. */
static int check_scene(const struct comparison *c)
{
    struct tia_fault first = {0}, fault;
    char why[300];

    for (unsigned i = TIA_SHADOWS_TRACED + 1; tia_shadows_name(i); i++) {
        if (!is_wanted(c, i))
            continue;
        if (qualifies(c->job.scene, i, &fault))
            return 0;
        first = first.field ? first : fault;
    }
    if (!first.field) /* no technique but traced rays is selected */
        return 0;
    (void)snprintf(why, sizeof why, "--shadows: %s %u: %s: %s", first.thing, (unsigned)first.index, first.field,
                   first.rule);
    return failed(2, c->name, why);
}

static int make_heatmap(struct comparison *c)
{
    size_t bytes = (size_t)c->job.width * c->job.height * sizeof *c->map.picture;

    if (!c->options->heatmap)
        return 0;
    memcpy(c->map.picture, c->reference.pixels, bytes);
    return !pictures_add(&c->pictures, &c->map) ? 0 : failed(1, "--heatmap", c->pictures.why);
}

static int compare(struct comparison *c)
{
    unsigned reference = reference_of(c->job.scene);

    c->count = 0;
    if (c->options->heatmap && !heatmap_alloc(&c->map, c->job.width, c->job.height, TECHNIQUES, colours))
        return failed(1, c->name, "out of memory");
    c->map.panels = 0;
    int result = check_scene(c);
    if (result == 0)
        result = draw(c, &c->reference, reference);
    if (result == 0)
        result = draw_others(c, reference);
    if (result == 0)
        result = make_heatmap(c);
    return result ? result : tell(c);
}

static int compare_file(struct comparison *c, const char *path)
{
    struct scene_file file;
    const char *slash = strrchr(path, '/');
    struct lights lights = {0};
    char line[SCENE_WHY];

    if (scene_open(&file, path, scene_format_of(path), false))
        return scene_report_print(&file, "tia-compare", 2);
    for (unsigned at = 0; scene_warning(&file, &at, line);)
        (void)message("tia-compare", 0, "%s", line);
    c->name = slash ? slash + 1 : path;
    c->job.scene = &file.scene;
    c->reference = (struct technique_frame){0};
    c->map = (struct heatmap){0};
    int result = choose_lights(c, &lights);
    if (result == 0)
        result = compare(c);
    technique_free(&c->reference);
    heatmap_free(&c->map);
    lights_free(&lights);
    scene_close(&file);
    return result;
}

int shadows_compare(const struct options *options, struct threads *pool)
{
    struct comparison c = {.options = options, .report = {.json = options->json}};
    int result = 0;

    c.job = (struct technique_job){.width = options->width ? options->width : 640,
                                   .height = options->width ? options->height : 480,
                                   .rounds = options->best_of,
                                   .workers = threads_workers(pool)};
    if (options->heatmap && !pictures_begin(&c.pictures, options->heatmap, (unsigned)options->scene_count))
        result = failed(1, "--heatmap", c.pictures.why);
    if (result == 0)
        shadows_report_begin(&c.report);
    for (int i = 0; i < options->scene_count && result == 0; i++)
        result = compare_file(&c, options->scenes[i]);
    if (result == 0 && options->heatmap && pictures_publish(&c.pictures))
        result = failed(1, "--heatmap", c.pictures.why);
    if (result == 0)
        shadows_report_end(&c.report);
    pictures_end(&c.pictures);
    return result;
}
