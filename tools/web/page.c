/* page.c - the functions that the worker's script calls: to load a scene, to apply settings, to run the viewer. */
#include "page.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <tia/debug.h>

#define EXPORT(name) __attribute__((export_name(name)))

struct session session = {.pointer_x = -1};

/* ---- the drawn picture ---- */

const struct tia_camera *session_camera(void)
{
    return session.state.moved ? &session.state.camera : &session.scene.camera;
}

/* What another worker needs to go on; the lights follow. */
struct kept {
    struct tia_viewer_state state;
    enum tia_shadows shadows;
};

static size_t lights_size(void)
{
    return session.lights.capacity * sizeof *session.lights.array;
}

uint32_t session_keep(const void **state)
{
    const struct kept kept = {session.state, session.variant.shadows};

    if (!session.kept)
        return 0;
    memcpy(session.kept, &kept, sizeof kept);
    memcpy((char *)session.kept + sizeof kept, session.lights.array, lights_size());
    *state = session.kept;
    return (uint32_t)(sizeof kept + lights_size());
}

void session_show(void)
{
    struct web_frame *frame = &session.frame;
    struct web_screen *screen = &session.screen;

    frame->crc = frame->block == 1 ? tia_crc32(0, screen->pixels, (size_t)screen->width * screen->height) : 0;
    memcpy(frame->differs, difference_counts, sizeof frame->differs);
    light_tell(frame);
    frame->state_size = session_keep(&frame->state);
    if (session.settings.arithmetic == ARITHMETIC_DIFFERENCE && frame->block == 1)
        difference_spread(screen->pixels, screen->width, screen->height);
    web_show(screen, frame);
}

static int frame_done(void *ctx, const struct tia_frame *frame)
{
    (void)ctx;
    session.frame = (struct web_frame){.number = frame->number,
                                       .block = frame->block,
                                       .done = frame->done,
                                       .samples = session.spp ? 1 : 0,
                                       .spp = session.spp,
                                       .draw_us = (uint32_t)frame->draw_us,
                                       .key_us = (uint32_t)frame->key_us,
                                       .relit = frame->relit,
                                       .plays = tia_scene_moves(&session.scene),
                                       .paused = session.state.paused,
                                       .time = session.state.time,
                                       .copied = share_copied()};
    bool again = frame->pixels == 0; /* the picture is shown again, by the viewer as it was without samples */
    if (again && samples_show())
        return TIA_OK;
    if (frame->block == 1 && !again)
        share_end();
    session_show();
    session.rays_due = session.settings.rays && session.pointer_x >= 0;
    return TIA_OK;
}

static void *get_memory(void *ctx, size_t size)
{
    (void)ctx;
    if (size > session.memory_size) {
        free(session.memory);
        session.memory = malloc(size);
        session.memory_size = session.memory ? size : 0;
    }
    return session.memory;
}

/* ---- settings ---- */

/* Copies the scene's keys, and adds one for the pointer, with any valid light as its state. Returns false if there is
 * no memory. */
static bool copy_bindings(struct tia_scene *scene)
{
    uint32_t count = scene->binding_count;
    const struct tia_light *some = scene->light_count ? scene->lights : count ? &scene->bindings[0].state : NULL;

    free(session.bindings);
    session.bindings = some ? malloc((count + 1) * sizeof *session.bindings) : NULL;
    if (!session.bindings)
        return !some;
    for (uint32_t i = 0; i < count; i++)
        session.bindings[i] = scene->bindings[i];
    session.bindings[count] = (struct tia_binding){.key = WEB_DRAGGED, .state = *some};
    scene->bindings = session.bindings;
    scene->binding_count = count + 1;
    return true;
}

static void set_samples(struct tia_scene *scene)
{
    const struct settings *settings = &session.settings;
    struct tia_integration *how = &scene->integration;

    if (settings->integrator >= 0)
        how->integrator = (enum tia_integrator)settings->integrator;
    session.spp = 0;
    if (how->integrator == TIA_WHITTED) {
        if (settings->samples)
            scene->camera.samples = settings->samples < 16 ? settings->samples : 16;
        return;
    }
    scene->shadows = TIA_SHADOWS_TRACED;
    how->spp = settings->samples ? settings->samples : how->spp ? how->spp : TIA_SPP_DEFAULT;
    if (settings->arithmetic != ARITHMETIC_DIFFERENCE) {
        session.spp = how->spp;
        how->spp = 1; /* the viewer draws the first sample */
    }
}

void session_failed(int status)
{
    struct tia_fault fault;

    if (tia_scene_check(&session.scene, &fault))
        (void)snprintf(session.why, sizeof session.why, "%s %u: %s: %s", fault.thing, (unsigned)fault.index,
                       fault.field, fault.rule);
    else
        (void)snprintf(session.why, sizeof session.why, "%s",
                       status == TIA_ERR_MEMORY ? "memory: exhausted" : "this scene cannot be drawn so");
}

static bool begin_lights(bool goes_on)
{
    if (goes_on && session.kept)
        return true;
    lights_free(&session.lights);
    session.lights = (struct lights){.array = NULL};
    free(session.kept);
    session.kept = lights_copy(&session.lights, &session.scene) ? malloc(sizeof(struct kept) + lights_size()) : NULL;
    session.state = (struct tia_viewer_state){.light_count = session.scene.light_count};
    return session.kept;
}

bool session_begin(bool goes_on)
{
    struct web_screen *screen = &session.screen;

    share_end();
    session.why[0] = '\0';
    session.rays_due = false;
    session.steer = (struct steer){.has_place = false};
    session.scene = session.file.scene;
    set_samples(&session.scene);
    free(screen->pixels);
    screen->width = session.settings.width;
    screen->height = session.settings.height;
    screen->pixels = calloc((size_t)screen->width * screen->height, sizeof *screen->pixels);
    return screen->pixels && copy_bindings(&session.scene) && begin_lights(goes_on);
}

/* ---- exported functions ---- */

/* Reads the scene `name` and the files that it refers to. Returns 0; or 1 with the reason in web_why, and keeps the old
 * scene. */
EXPORT("web_load") int web_load(const char *name);
int web_load(const char *name)
{
    static char kept[SCENE_WHY];
    struct scene_file file;
    int format = scene_format_of(name);

    (void)snprintf(kept, sizeof kept, "%s", name);
    free(session.report);
    session.report = NULL;
    file.report = NULL;
    if (format == SCENE_UNKNOWN || scene_open(&file, kept, format, false)) {
        (void)snprintf(session.why, sizeof session.why, "%s", format == SCENE_UNKNOWN ? "unknown format" : file.why);
        session.report = file.report;
        return 1;
    }
    if (session.loaded)
        scene_close(&session.file);
    session.file = file;
    session.loaded = true;
    return 0;
}

EXPORT("web_set")
void web_set(unsigned width, unsigned height, int arithmetic, int view, int rays, int integrator, unsigned samples);
void web_set(unsigned width, unsigned height, int arithmetic, int view, int rays, int integrator, unsigned samples)
{
    session.settings = (struct settings){.width = (uint16_t)width,
                                         .height = (uint16_t)height,
                                         .arithmetic = (enum arithmetic)arithmetic,
                                         .view = (enum view)view,
                                         .rays = rays != 0,
                                         .integrator = integrator,
                                         .samples = samples};
}

/* Runs the viewer. Returns 0 after an event that ends it; 1 if there is nothing to do and the browser cannot suspend
 * the module; 2 on failure, with the reason in web_why. */
EXPORT("web_run") int web_run(int goes_on);
int web_run(int goes_on)
{
    if (!session.loaded || !session_begin(goes_on)) {
        session_failed(TIA_ERR_MEMORY);
        return 2;
    }
    session.state.goes_on = goes_on;
    const struct tia_core *core = seat_core();
    struct tia_viewer viewer = {.core = core,
                                .simd = seat.base == &tia_core_q16 ? tia_simd_best() : NULL,
                                .scene = &session.scene,
                                .variant = &session.variant,
                                .lights = {.array = session.lights.array,
                                           .kept = session.lights.kept,
                                           .detached = session.lights.detached,
                                           .capacity = session.lights.capacity},
                                .pacing = {.time = session.state.time},
                                .ports = {.display = &web_display,
                                          .display_ctx = &session.screen,
                                          .input = &session_input,
                                          .input_ctx = &session.screen,
                                          .clock = &web_clock},
                                .hooks = {.memory = get_memory, .frame_done = frame_done, .control = &session_control},
                                .state = &session.state};
    int status = tia_viewer_run(&viewer);
    seat.view = NULL;
    if (!status)
        return 0;
    if (status == TIA_STOPPED && session.screen.stays)
        return 1;
    session_failed(status);
    return 2;
}

/* Returns memory for the state of another worker with the same scene, which web_take_kept then uses. Returns NULL if
 * the state is one of another scene, or if there is no memory. */
EXPORT("web_kept") void *web_kept(unsigned size);
void *web_kept(unsigned size)
{
    session.scene = session.file.scene;
    if (!session.loaded || !copy_bindings(&session.scene) || !begin_lights(false))
        return NULL;
    return size == sizeof(struct kept) + lights_size() ? session.kept : NULL;
}

EXPORT("web_take_kept") void web_take_kept(void);
void web_take_kept(void)
{
    struct kept kept;

    memcpy(&kept, session.kept, sizeof kept);
    session.state = kept.state;
    session.shadows = kept.shadows;
    memcpy(session.lights.array, (char *)session.kept + sizeof kept, lights_size());
}

EXPORT("web_why") const char *web_why(void);
const char *web_why(void)
{
    return session.why;
}

/* Returns all mistakes of the scene that web_load refused, up to 20, in the order of the text; "" if none has a place.
 * A mistake is a line "FILE:LINE:COLUMN: WHAT" (columns count bytes, from 1), and two lines that begin with blanks: the
 * line of the text, and a mark below the word. Valid until the next web_load. */
EXPORT("web_mistakes") const char *web_mistakes(void);
const char *web_mistakes(void)
{
    return session.report ? session.report : "";
}

/* Returns memory for a name that the script writes, of SCENE_WHY bytes. */
EXPORT("web_name") char *web_name(void);
char *web_name(void)
{
    static char name[SCENE_WHY];
    return name;
}
