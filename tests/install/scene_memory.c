/* scene_memory.c - the sizes in a header by `tia-compile --memory`, and those that the library returns on this machine,
 * name by name. Compiled with SCENE, the scene's name, NAME, the prefix of its sizes, and LIGHTS. */
#include <stdio.h>
#include <stdlib.h>
#include <tia/tia.h>

#include "../workers_in_turn.h"

extern const struct tia_scene SCENE;

#define JOIN2(a, b) a##b
#define JOIN(a, b) JOIN2(a, b)
#define SIZE(what) JOIN(NAME, what)

/* The view's memory, an array as in an embedded program. */
static uint64_t view_memory[TIA_WORDS(SIZE(_VIEW))];

struct asked {
    size_t size; /* size of the first request for a frame's memory */
    unsigned first, requests;
};

static void *no_memory(void *ctx, size_t size)
{
    struct asked *asked = ctx;

    if (asked->requests++ < asked->first)
        return calloc(1, size);
    if (!asked->size)
        asked->size = size;
    return NULL;
}

static int mode(void *ctx, struct tia_mode *out)
{
    (void)ctx;
    *out = (struct tia_mode){.width = 320, .height = 250};
    return TIA_OK;
}

static int poll(void *ctx, struct tia_event *event)
{
    (void)ctx;
    (void)event;
    return 0;
}

/* Functions that the viewer requires, but does not call, as nothing is drawn without memory. */

static int acquire(void *ctx, struct tia_tile tile, struct tia_surface *surface)
{
    (void)ctx;
    (void)tile;
    (void)surface;
    return TIA_ERR_DEVICE;
}

static int submit(void *ctx, struct tia_tile tile)
{
    (void)ctx;
    (void)tile;
    return TIA_ERR_DEVICE;
}

static int present(void *ctx)
{
    (void)ctx;
    return TIA_ERR_DEVICE;
}

static int wait_long(void *ctx, int timeout_ms)
{
    (void)ctx;
    (void)timeout_ms;
    return TIA_ERR_DEVICE;
}

static uint64_t now_us(void *ctx)
{
    (void)ctx;
    return 0;
}

/* With so many workers, tiles have the least number of rows. */
static size_t viewer_size(void)
{
    static const struct tia_workers workers = {run_in_turn, enter_in_turn, leave_in_turn, NULL, 64};
    static const struct tia_display display = {.mode = mode, .acquire = acquire, .submit = submit, .present = present};
    static const struct tia_input input = {.poll = poll, .wait = wait_long};
    static const struct tia_clock clock = {now_us};
    static struct tia_light lights[LIGHTS];
    static bool detached[LIGHTS];
    struct asked asked = {0, tia_scene_moves(&SCENE), 0};
    struct tia_viewer viewer = {.scene = &SCENE,
                                .lights = {.array = lights, .detached = detached, .capacity = LIGHTS},
                                .ports = {.display = &display, .input = &input, .clock = &clock},
                                .job = {.workers = &workers},
                                .hooks = {.memory = no_memory, .ctx = &asked}};

    (void)tia_viewer_run(&viewer);
    return asked.size;
}

/* Returns the memory of rows of which `columns` pixels are drawn at once, with the number of lights that takes most. */
static size_t rows_size(uint16_t columns)
{
    static struct tia_light lights[LIGHTS];
    struct tia_rows rows = {.core = &tia_core_q16, .scene = &SCENE, .width = 320, .height = 250, .columns = columns};
    size_t most = tia_draw_rows_size(&rows);

    rows.lights = lights;
    for (rows.light_count = 1; rows.light_count <= LIGHTS; rows.light_count++)
        most = tia_draw_rows_size(&rows) > most ? tia_draw_rows_size(&rows) : most;
    return most;
}

static void tell(const char *what, size_t said, size_t asked)
{
    printf("%s %lu %lu\n", what, (unsigned long)said, (unsigned long)asked);
}

int main(void)
{
    struct tia_tile row = {0, 0, 320, 1}, odd = {0, 0, 33, 7}, frame = {0, 0, 320, 250};
    struct tia_view *view;

    if (tia_view_init(&view, view_memory, sizeof view_memory, &SCENE, LIGHTS, 320, 250, NULL))
        return 1;
    tell("view", SIZE(_VIEW), tia_view_size(&SCENE, LIGHTS));
    tell("row", SIZE(_HITS_320x1), tia_hits_size(&SCENE, row));
    tell("rows", SIZE(_ROWS_320), rows_size(0));
    tell("part", SIZE(_ROWS_320) - SIZE(_HITS_320x1) + SIZE(_HITS_33x1), rows_size(33));
    tell("tile", SIZE(_HITS_33x7), tia_hits_size(&SCENE, odd));
    tell("frame", SIZE(_HITS_320x250), tia_hits_size(&SCENE, frame));
    tell("viewer", SIZE(_VIEWER_320x250), viewer_size());
    return 0;
}
