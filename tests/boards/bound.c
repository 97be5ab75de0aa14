/* bound.c - draws single rows of random scenes, whose instructions are counted between marks, see bound.py. Each row is
 * drawn three times, and each time a line says what its bound depends on, "WORD SPHERES LIGHTS WIDTH TRAITS POLLS":
 *
 *     row     without `stop`; the marks enclose the row
 *     polls   with a `stop` that returns false; the marks enclose what is between two polls
 *     stop    with one that returns true from some poll on; the marks enclose what follows that poll
 *
 * One scene of eight is a crowd. Traits of the others are, by chance: a ground, spheres that are the same as others,
 * the eye in a sphere, materials that transmit light, visible lights, spheres that overlap, dithering, pixels that are
 * not contiguous, lights that graze a sphere, and one light with few spheres, as steps of colours need it. */
#include "boards/board.h"
#include "marks.h"
#include <tia/tia.h>

enum { SPHERES = 64, LIGHTS = 16, FEW_SPHERES = 16, FEW_LIGHTS = 4, STEPPED = 8 };
enum { WIDTH = 640, HEIGHT = 240, MATERIALS = 4, ROWS = 2, ALL_TRAITS = 1024 };
enum trait {
    GROUND = 1,
    TWINS = 2,
    INSIDE = 4,
    GLASS = 8,
    LAMPS = 16,
    TIGHT = 32,
    DITHER = 64,
    APART = 128,
    GRAZING = 256,
    ONE_LIGHT = 512
};

static struct tia_material materials[MATERIALS];
static struct tia_sphere spheres[SPHERES];
static struct tia_light lights[LIGHTS];
static uint64_t view_memory[SPHERES * (21 + (SPHERES + 7) / 8 * LIGHTS / 8) + STEPPED * 96 + LIGHTS * 32 + 48];
static uint64_t hits_memory[16 + WIDTH];
static tia_rgb565 row[2 * WIDTH];
static uint32_t state;

/* Returns a number from least to most, the next one of a sequence. */
static int32_t between(int32_t least, int32_t most)
{
    state = state * UINT32_C(1664525) + UINT32_C(1013904223);
    return least + (int32_t)((uint64_t)(state >> 8) * (uint32_t)(most - least) >> 24);
}

/* ---- scenes ---- */

static struct tia_vec3 place(int32_t reach, int32_t near, int32_t far)
{
    return (struct tia_vec3){between(-reach, reach), between(-reach, reach), between(-far, -near)};
}

static void make_materials(unsigned traits)
{
    for (int i = 0; i < MATERIALS; i++) {
        int32_t grey = between(0, TIA_Q30_ONE);
        materials[i] = (struct tia_material){.colour = {grey, between(0, TIA_Q30_ONE), between(0, TIA_Q30_ONE)}};
        if (i == 0)
            materials[i].colour = (struct tia_rgb){grey, grey, grey};
        if (traits & GLASS && i == 1)
            materials[i].transmission = (struct tia_rgb){grey, TIA_Q30(.5), TIA_Q30(.9)};
    }
}

static void make_spheres(unsigned traits, uint32_t count)
{
    int32_t reach = traits & TIGHT ? TIA_Q16(3) : TIA_Q16(9);
    int32_t most = count > FEW_SPHERES ? TIA_Q16(2) : TIA_Q16(5);

    for (uint32_t i = 0; i < count; i++) {
        spheres[i].centre = place(reach, TIA_Q16(8), TIA_Q16(30));
        spheres[i].radius = between(TIA_Q16(.05), between(TIA_Q16(.1), most));
        spheres[i].material = i % (uint32_t)MATERIALS;
        if (traits & TWINS && i % 3 == 2) {
            spheres[i].centre = spheres[i - 1].centre;
            spheres[i].radius = spheres[i - 1].radius;
        }
    }
    if (traits & GROUND)
        spheres[0] = (struct tia_sphere){{0, TIA_Q16(-10003), TIA_Q16(-20)}, TIA_Q16(10000), 0};
    if (traits & INSIDE)
        spheres[count - 1] = (struct tia_sphere){{TIA_Q16(1), 0, TIA_Q16(-5)}, TIA_Q16(60), 1};
}

static void make_lights(unsigned traits, uint32_t sphere_count, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        int32_t bright = between(TIA_Q30(.1), TIA_Q30(1));
        lights[i] = (struct tia_light){.centre = place(TIA_Q16(25), -TIA_Q16(5), TIA_Q16(30)),
                                       .emission = {bright, bright, i % 2 ? bright / 2 : bright}};
        if (traits & LAMPS)
            lights[i].radius = between(0, TIA_Q16(2));
        if (traits & GRAZING) { /* near the highest point of a sphere, above it or in it */
            const struct tia_sphere *s = &spheres[between(0, (int32_t)sphere_count)];
            lights[i].centre = s->centre;
            lights[i].centre.y += s->radius + between(-TIA_Q16(.01), TIA_Q16(.02));
        }
    }
}

/* ---- rows ---- */

static struct {
    bool ready; /* the row is being drawn */
    bool marks; /* mark each poll */
    uint32_t count, until;
} polls;

static bool poll(void *ctx)
{
    (void)ctx;
    if (!polls.ready)
        return false;
    bool stops = ++polls.count >= polls.until;
    if (polls.marks) {
        count_end();
        count_begin();
    } else if (polls.count == polls.until) {
        count_begin();
    }
    return stops;
}

/* A row that is drawn. */
struct drawn {
    const struct tia_core *core;
    const struct tia_scene *scene;
    unsigned traits;
    uint16_t width;
    struct tia_tile tile;
};

/* Draws a row with `stop`, or without. Returns false if preparing or drawing fails. */
static bool draw(const struct drawn *d, const char *word, bool (*stop)(void *ctx))
{
    const int32_t step = d->traits & APART ? 4 : 2;
    const struct tia_surface surface = {.pixels = row, .step = step, .pitch = sizeof row};
    const struct tia_options options = {.dither = (d->traits & DITHER) != 0};
    const struct tia_job job = {.stop = stop};
    const uint32_t facts[] = {d->scene->sphere_count, d->scene->light_count, d->width, d->traits};
    struct tia_view *view;
    struct tia_hits *hits;

    polls.ready = false;
    int status = d->core->view_init(d->core, &view, view_memory, sizeof view_memory, d->scene, d->scene->light_count,
                                    d->width, HEIGHT, &job);
    polls.ready = true;
    polls.count = 0;
    if (!stop || polls.marks)
        count_begin();
    status = status ? status : tia_hits_init(&hits, hits_memory, sizeof hits_memory, view, d->tile);
    status = status ? status : tia_view_draw(view, hits, d->tile, &surface, &options);
    count_end();
    board_print(word);
    for (int i = 0; i < 4; i++) {
        board_print(" ");
        board_print_hex(facts[i]);
    }
    board_print(" ");
    board_print_hex(polls.count);
    board_print("\n");
    return status == (polls.until == UINT32_MAX ? TIA_OK : TIA_STOPPED);
}

static bool draw_rows(struct drawn *d)
{
    bool done = true;

    for (int i = 0; i < ROWS && done; i++) {
        d->tile = (struct tia_tile){0, (uint16_t)between(0, HEIGHT), d->width, 1};
        polls.until = UINT32_MAX;
        polls.marks = false;
        done = draw(d, "row", NULL);
        polls.marks = true;
        done = done && draw(d, "polls", poll);
        polls.marks = false;
        polls.until = (uint32_t)between(1, (int32_t)polls.count + 1);
        done = done && draw(d, "stop", poll);
    }
    return done;
}

static bool draw_scene(bool crowd)
{
    unsigned traits = (unsigned)between(0, ALL_TRAITS) & (unsigned)between(0, ALL_TRAITS);
    uint32_t most = crowd ? SPHERES : traits & ONE_LIGHT ? STEPPED : FEW_SPHERES;
    uint32_t sphere_count = (uint32_t)between(1, (int32_t)most + 1);
    uint32_t light_count = (uint32_t)between(0, (crowd ? LIGHTS : FEW_LIGHTS) + 1);

    light_count = traits & ONE_LIGHT ? 1 : light_count;
    make_materials(traits);
    make_spheres(traits, sphere_count);
    make_lights(traits, sphere_count, light_count);
    const struct tia_scene scene = {.camera = {.fov = between(TIA_Q16(20), TIA_Q16(90))},
                                    .background = {TIA_Q30(.6), TIA_Q30(.7), TIA_Q30(.8)},
                                    .materials = materials,
                                    .material_count = MATERIALS,
                                    .spheres = spheres,
                                    .sphere_count = sphere_count,
                                    .lights = lights,
                                    .light_count = light_count};
    struct drawn d = {&tia_core_spheres, &scene, traits, (uint16_t)between(16, WIDTH + 1), {0, 0, 0, 0}};
    return draw_rows(&d);
}

int main(void)
{
    bool done = true;

    state = SEED;
    for (int n = 0; n < SCENES && done; n++)
        done = draw_scene(n % 8 == 7);
    board_print(done ? "done\n" : "failed\n");
    return done ? 0 : 1;
}
