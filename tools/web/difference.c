/* difference.c - two cores in one: fixed point, and doubles for comparison, as in tia-compare. */
#include "page.h"

#include <tia/debug.h>

enum { MANY = 1000, REACH = 2 }; /* limits as for tia-compare's pictures */

struct pair {
    const struct tia_core *core;
    struct tia_view *view[2];
};

struct pair_hits {
    const struct tia_view *view;
    struct tia_hits *hits[2];
};

static const struct tia_core *const cores[2] = {&tia_core_q16, &tia_core_f64};
static const tia_rgb565 colours[3] = {0xffe0, 0xf800, 0x07ff};
uint32_t difference_counts[3];

/* Returns the views of both cores. In memory, a view of this core is a struct pair followed by both views, and hits
 * likewise are a struct pair_hits followed by both hits. */
static const struct pair *pair_of(const struct tia_view *view)
{
    return (const struct pair *)(const void *)view;
}

static const struct pair_hits *hits_of(const struct tia_hits *hits)
{
    return (const struct pair_hits *)(const void *)hits;
}

static size_t whole(size_t size)
{
    return (size + 15) / 16 * 16;
}

static size_t sum(size_t head, size_t a, size_t b)
{
    return a > SIZE_MAX / 4 || b > SIZE_MAX / 4 ? SIZE_MAX : whole(head) + whole(a) + whole(b);
}

static size_t view_size(const struct tia_core *core, const struct tia_scene *scene, uint32_t capacity)
{
    (void)core;
    return sum(sizeof(struct pair), cores[0]->view_size(cores[0], scene, capacity),
               cores[1]->view_size(cores[1], scene, capacity));
}

static int view_init(const struct tia_core *core, struct tia_view **view, void *memory, size_t size,
                     const struct tia_scene *scene, uint32_t capacity, unsigned width, unsigned height,
                     const struct tia_job *job)
{
    struct pair *pair = memory;
    char *at = (char *)memory + whole(sizeof *pair);
    int status = size < view_size(core, scene, capacity) ? TIA_ERR_MEMORY : TIA_OK;

    for (int i = 0; i < 2 && !status; i++) {
        size_t part = whole(cores[i]->view_size(cores[i], scene, capacity));
        status = cores[i]->view_init(cores[i], &pair->view[i], at, part, scene, capacity, width, height, job);
        at += part;
    }
    if (!status)
        pair->core = core;
    *view = memory;
    return status;
}

static int set_lights(struct tia_view *view, const struct tia_light *lights, uint32_t count)
{
    int status = tia_view_set_lights(pair_of(view)->view[0], lights, count);

    return status ? status : tia_view_set_lights(pair_of(view)->view[1], lights, count);
}

static size_t hits_size(const struct tia_core *core, const struct tia_scene *scene, struct tia_tile area)
{
    (void)core;
    return sum(sizeof(struct pair_hits), cores[0]->hits_size(cores[0], scene, area),
               cores[1]->hits_size(cores[1], scene, area));
}

static int hits_init(struct tia_hits **hits, void *memory, size_t size, const struct tia_view *view,
                     struct tia_tile area)
{
    struct pair_hits *both = memory;
    char *at = (char *)memory + whole(sizeof *both);
    int status = TIA_OK;

    for (int i = 0; i < 2 && !status; i++) {
        size_t needed = whole(cores[0]->hits_size(cores[0], &session.scene, area)),
               used = (size_t)(at - (char *)memory);
        size_t part = i == 0 ? needed : size - used;
        status = tia_hits_init(&both->hits[i], at, part, pair_of(view)->view[i], area);
        at += part;
    }
    both->view = view;
    *hits = memory;
    return status;
}

static uint32_t hits_object(const struct tia_hits *hits, unsigned x, unsigned y)
{
    return tia_hits_object(hits_of(hits)->hits[0], x, y);
}

static int trace(const struct tia_view *view, struct tia_hits *hits, struct tia_tile tile)
{
    int status = tia_view_trace(pair_of(view)->view[0], hits_of(hits)->hits[0], tile);

    return status ? status : tia_view_trace(pair_of(view)->view[1], hits_of(hits)->hits[1], tile);
}

static unsigned apart(unsigned a, unsigned b)
{
    return a > b ? a - b : b - a;
}

/* Returns a pixel's colour, and counts a difference. If both cores agree, the colour is grey at a quarter of the
 * brightness. */
static tia_rgb565 verdict(tia_rgb565 a, tia_rgb565 b, bool other_path)
{
    unsigned r = apart(a >> 11, b >> 11), g = apart(a >> 5 & 63, b >> 5 & 63), blue = apart(a & 31, b & 31);
    unsigned most = r > g ? r : g, level = ((a >> 11) + (a >> 6 & 31u) + (a & 31u)) / 12;

    most = blue > most ? blue : most;
    if (!most && !other_path)
        return (tia_rgb565)(level << 11 | level << 6 | level);
    unsigned kind = other_path ? 2 : most > 1;
    difference_counts[kind]++;
    return colours[kind];
}

static int light_row(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile row,
                     const struct tia_surface *surface, const struct tia_options *options)
{
    static tia_rgb565 pixels[2][TIA_SIZE_MAX];
    static uint32_t paths[2][TIA_SIZE_MAX];
    int status = TIA_OK;

    for (int i = 0; i < 2 && !status; i++) {
        struct tia_options both = {.dither = options && options->dither,
                                   .debug = &(struct tia_debug){.path_hash = paths[i]}};
        struct tia_surface line = {.pixels = pixels[i], .step = sizeof(tia_rgb565), .pitch = sizeof pixels[i]};
        status = tia_view_light(pair_of(view)->view[i], hits_of(hits)->hits[i], row, &line, &both);
    }
    for (unsigned x = 0; x < row.width && !status; x++)
        *(tia_rgb565 *)(void *)((char *)surface->pixels + (ptrdiff_t)x * surface->step) =
            verdict(pixels[0][x], pixels[1][x], paths[0][x] != paths[1][x]);
    return status;
}

static int light(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile,
                 const struct tia_surface *surface, const struct tia_options *options)
{
    int status = TIA_OK;

    for (unsigned y = 0; y < tile.height && !status; y++) {
        struct tia_tile row = {tile.x, (uint16_t)(tile.y + y), tile.width, 1};
        struct tia_surface line = *surface;
        line.pixels = (tia_rgb565 *)(void *)((char *)surface->pixels + (ptrdiff_t)y * surface->pitch);
        status = light_row(view, hits, row, &line, options);
    }
    return status;
}

static int render(const struct tia_view *view, struct tia_hits *hits, struct tia_tile tile,
                  const struct tia_surface *surface, const struct tia_options *options)
{
    int status = trace(view, hits, tile);

    return status ? status : light(view, hits, tile, surface, options);
}

static bool draws_by_pixel(const struct tia_core *core, const struct tia_scene *scene)
{
    (void)core;
    return tia_draws_by_pixel(scene);
}

static const struct tia_drawing drawing = {.set_lights = set_lights,
                                           .hits_init = hits_init,
                                           .hits_object = hits_object,
                                           .trace = trace,
                                           .light = light,
                                           .render = render};
const struct tia_core difference_core = {.name = "q16 - f64",
                                         .view_size = view_size,
                                         .view_init = view_init,
                                         .hits_size = hits_size,
                                         .draws_by_pixel = draws_by_pixel,
                                         .drawing = &drawing};

static unsigned kind_of(tia_rgb565 pixel)
{
    unsigned kind = 0;

    while (kind < 3 && colours[kind] != pixel)
        kind++;
    return kind;
}

/* Spreads a difference to the pixels around it that do not differ. Their colours differ slightly from those of
 * differences, so that they are not spread again. */
static void spread(tia_rgb565 *pixels, unsigned width, unsigned height, size_t at)
{
    static const tia_rgb565 around[3] = {0xff80, 0xf820, 0x07df};
    unsigned x = (unsigned)(at % width), y = (unsigned)(at / width), kind = kind_of(pixels[at]);

    for (unsigned v = y > REACH ? y - REACH : 0; v <= y + REACH && v < height; v++)
        for (unsigned u = x > REACH ? x - REACH : 0; u <= x + REACH && u < width; u++)
            if (kind_of(pixels[(size_t)v * width + u]) == 3)
                pixels[(size_t)v * width + u] = around[kind];
}

void difference_spread(tia_rgb565 *pixels, unsigned width, unsigned height)
{
    if (difference_counts[0] + difference_counts[1] + difference_counts[2] > MANY)
        return;
    for (size_t i = 0; i < (size_t)width * height; i++)
        if (kind_of(pixels[i]) < 3)
            spread(pixels, width, height, i);
}
