#include "unit.h"

#include <stdio.h>
#include <stdlib.h>

#include <tia/debug.h>
#include <tia/render.h>
#include <tia/viewer.h>

#include "ports.h"

/* ---- states: 0 has the scene's lights; each other one is that after a key ---- */

/* True if binding `n` is the first one of its key, which is the one that the key selects. */
static bool is_first(const struct tia_scene *scene, uint32_t n)
{
    for (uint32_t i = 0; i < n; i++)
        if (scene->bindings[i].key == scene->bindings[n].key)
            return false;
    return true;
}

static uint32_t count_states(const struct tia_scene *scene)
{
    uint32_t states = 1;

    for (uint32_t i = 0; i < scene->binding_count; i++)
        states += is_first(scene, i);
    return states;
}

/* ---- drawing ---- */

/* What draws a rectangle of a picture. */
struct canvas {
    const struct tia_scene *scene;
    struct tia_view *view;
    struct tia_light *lights; /* room for one more than the scene has */
    void *view_memory, *hits_memory;
    tia_rgb565 *pixels;
};

static int set_state(struct canvas *canvas, const uint16_t *key)
{
    uint32_t count = canvas->scene->light_count;

    for (uint32_t i = 0; i < count; i++)
        canvas->lights[i] = canvas->scene->lights[i];
    int status = key ? tia_viewer_press(canvas->scene, canvas->lights, &count, count + 1, *key) : 0;
    return status < 0 ? status : tia_view_set_lights(canvas->view, canvas->lights, count);
}

static int draw(struct canvas *canvas, struct tia_tile area, uint32_t *crc)
{
    const struct tia_surface surface = {.pixels = canvas->pixels, .step = 2, .pitch = 2 * (ptrdiff_t)area.width};
    struct tia_hits *hits;
    size_t size = tia_hits_size(canvas->scene, area);
    int status = tia_hits_init(&hits, canvas->hits_memory, size, canvas->view, area);

    if (!status)
        status = tia_view_draw(canvas->view, hits, area, &surface, NULL);
    *crc = tia_crc32(0, canvas->pixels, (size_t)area.width * area.height);
    return status;
}

/* Draws all rectangles in one state. */
static int draw_state(struct canvas *canvas, const struct convert_telltales *all, const uint16_t *key, uint32_t states,
                      uint32_t *crcs)
{
    int status = set_state(canvas, key);

    for (unsigned i = 0; i < all->count && !status; i++)
        status = draw(canvas, all->of[i].area, &crcs[(size_t)i * states]);
    return status;
}

static int draw_states(struct canvas *canvas, const struct convert_telltales *all, uint32_t *crcs)
{
    const struct tia_scene *scene = canvas->scene;
    uint32_t states = count_states(scene), state = 1;
    int status = draw_state(canvas, all, NULL, states, crcs);

    for (uint32_t i = 0; i < scene->binding_count && !status; i++)
        if (is_first(scene, i))
            status = draw_state(canvas, all, &scene->bindings[i].key, states, crcs + state++);
    return status;
}

/* Allocates and prepares the view, and room for the largest rectangle. */
static int open_canvas(struct canvas *canvas, const struct convert_telltales *all)
{
    uint32_t lights = canvas->scene->light_count + 1;
    size_t view = tia_view_size(canvas->scene, lights), hits = 0, pixels = 0;

    for (unsigned i = 0; i < all->count; i++) {
        size_t size = tia_hits_size(canvas->scene, all->of[i].area);
        size_t count = (size_t)all->of[i].area.width * all->of[i].area.height;
        hits = size > hits ? size : hits;
        pixels = count > pixels ? count : pixels;
    }
    canvas->view_memory = malloc(view);
    canvas->hits_memory = malloc(hits);
    canvas->pixels = malloc(pixels * sizeof *canvas->pixels);
    canvas->lights = malloc(lights * sizeof *canvas->lights);
    if (!canvas->view_memory || !canvas->hits_memory || !canvas->pixels || !canvas->lights)
        return TIA_ERR_MEMORY;
    return tia_view_init(&canvas->view, canvas->view_memory, view, canvas->scene, lights, all->width, all->height,
                         NULL);
}

static void close_canvas(struct canvas *canvas)
{
    free(canvas->view_memory);
    free(canvas->hits_memory);
    free(canvas->pixels);
    free(canvas->lights);
}

uint32_t *telltales_draw(const struct tia_scene *scene, const struct convert_telltales *all, char *why)
{
    struct canvas canvas = {.scene = scene};
    uint32_t *crcs = malloc(sizeof *crcs * all->count * count_states(scene));
    int status = crcs ? open_canvas(&canvas, all) : TIA_ERR_MEMORY;

    if (!status)
        status = draw_states(&canvas, all, crcs);
    close_canvas(&canvas);
    if (!status)
        return crcs;
    (void)snprintf(why, PORT_WHY, "--crc: %s",
                   status == TIA_ERR_MEMORY ? "out of memory"
                                            : "an object or a light is too far away in a picture of this size");
    free(crcs);
    return NULL;
}

/* ---- the tables ---- */

static void write_crcs(struct unit *unit, const char *name, const uint32_t *crcs, uint32_t count)
{
    table_begin(unit, "uint32_t", "crcs_%s", name);
    for (uint32_t i = 0; i < count; i++)
        text_word(&unit->text, "0x%08xu,", crcs[i]);
    table_end(unit);
}

static void write_keys(struct unit *unit)
{
    const struct tia_scene *scene = unit->scene;

    table_begin(unit, "uint16_t", "telltale_keys");
    for (uint32_t i = 0; i < scene->binding_count; i++)
        if (is_first(scene, i))
            text_word(&unit->text, "%u,", scene->bindings[i].key);
    table_end(unit);
}

void unit_telltales(struct unit *unit, const struct convert_telltales *all, const uint32_t *crcs)
{
    uint32_t states = count_states(unit->scene);

    text_print(&unit->text, "\n");
    for (unsigned i = 0; i < all->count; i++)
        write_crcs(unit, all->of[i].name, crcs + (size_t)i * states, states);
    table_begin(unit, "struct tia_telltale", "telltale");
    for (unsigned i = 0; i < all->count; i++) {
        struct tia_tile a = all->of[i].area;
        text_word(&unit->text, "{\"%s\", {%u, %u, %u, %u}, %s_crcs_%s},", all->of[i].name, a.x, a.y, a.width, a.height,
                  unit->symbol, all->of[i].name);
        text_print(&unit->text, "\n");
    }
    table_end(unit);
    if (states > 1)
        write_keys(unit);
    text_print(&unit->text, "extern const struct tia_telltales %s_telltales;\n", unit->symbol);
    text_print(&unit->text, "const struct tia_telltales %s_telltales = {\n", unit->symbol);
    unit->text.indent = 4;
    text_word(&unit->text, ".width = %u, .height = %u,", all->width, all->height);
    field_table(unit, "telltales", 1, "telltale");
    field_table(unit, "keys", states - 1, "telltale_keys");
    field_unsigned(unit, "telltale_count", all->count);
    field_unsigned(unit, "key_count", states - 1);
    text_print(&unit->text, "\n};\n");
}
