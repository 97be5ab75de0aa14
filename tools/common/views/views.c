#include "views.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "false_colour.h"
#include "legend.h"
#include "projected.h"

enum { RAYS_DRAWN = 256 };

/* State of the views. Set when a view is prepared and when its lights are set, before the threads draw. */
static struct {
    struct views views;
    const struct tia_core *watched;
    struct tia_core core;
    struct tia_drawing drawing;
    struct legend legend;
    const struct tia_scene *scene;
    unsigned width, height;
    struct line lines[2 * RAYS_DRAWN];
    unsigned line_count;
} now;

const char *view_name(unsigned view)
{
    static const char *const names[VIEW_COUNT] = {"colour", "depth", "normal", "object", "cost", "light", "path"};

    return view < VIEW_COUNT ? names[view] : NULL;
}

/* ---- the rays of a pixel ---- */

static void add_line(struct tia_vec3 from, struct tia_vec3 to, tia_rgb565 colour)
{
    struct line *line = &now.lines[now.line_count];

    line->colour = colour;
    if (projected_segment(&now.scene->camera, now.width, now.height, from, to, line->ends))
        now.line_count++;
}

static void add_ray(void *ctx, const struct tia_traced *traced)
{
    unsigned kind = (unsigned)traced->ray;
    double part = now.legend.scale / 10; /* length of a drawn normal */
    struct tia_vec3 tip = {(tia_q16)fmin(traced->to.x + part * traced->normal.x, INT32_MAX),
                           (tia_q16)fmin(traced->to.y + part * traced->normal.y, INT32_MAX),
                           (tia_q16)fmin(traced->to.z + part * traced->normal.z, INT32_MAX)};

    (void)ctx;
    if (now.line_count + 2 > 2 * RAYS_DRAWN)
        return;
    add_line(traced->from, traced->to, legend_ray(traced->ray == TIA_RAY_SHADOW && !traced->arrives ? kind + 1 : kind));
    if (traced->ray != TIA_RAY_SHADOW && traced->object != TIA_NO_OBJECT)
        add_line(traced->to, tip, legend_ray(TIA_RAY_SHADOW + 2));
}

static int collect_rays(const struct tia_view *view, unsigned x, unsigned y)
{
    const struct tia_tile pixel = {(uint16_t)x, (uint16_t)y, 1, 1};
    struct tia_observer observer = {add_ray, NULL, 0};
    const struct tia_options options = {.debug = &(struct tia_debug){.observer = &observer}};
    tia_rgb565 colour;
    const struct tia_surface surface = {.pixels = &colour, .step = sizeof colour, .pitch = sizeof colour};
    struct tia_hits *hits;

    now.line_count = 0;
    if (x >= now.width || y >= now.height)
        return TIA_OK;
    size_t size = now.watched->hits_size(now.watched, now.scene, pixel);
    void *memory = malloc(size);
    int status = memory ? tia_drawing.hits_init(&hits, memory, size, view, pixel) : TIA_ERR_MEMORY;
    if (!status)
        status = tia_drawing.trace(view, hits, pixel);
    if (!status)
        status = tia_drawing.light(view, hits, pixel, &surface, &options);
    free(memory);
    return status;
}

/* ---- the core ---- */

/* Returns the distance that gets the middle of the palette: that of the camera's reference point; 10 if it has none. */
static double scale_of(const struct tia_scene *scene)
{
    const struct tia_camera *c = &scene->camera;
    double x = ((double)c->eye.x - c->reference.x) / 65536, y = ((double)c->eye.y - c->reference.y) / 65536,
           z = ((double)c->eye.z - c->reference.z) / 65536;

    return c->up.x != 0 || c->up.y != 0 || c->up.z != 0 ? sqrt(x * x + y * y + z * z) : 10;
}

static int view_init(const struct tia_core *core, struct tia_view **view, void *memory, size_t size,
                     const struct tia_scene *scene, uint32_t capacity, unsigned width, unsigned height,
                     const struct tia_job *job)
{
    now.scene = scene;
    now.width = width;
    now.height = height;
    now.legend = (struct legend){now.views.view,
                                 now.views.draws_rays,
                                 width,
                                 height,
                                 scale_of(scene),
                                 scene->sphere_count + scene->shape_count,
                                 0};
    return now.watched->view_init(core, view, memory, size, scene, capacity, width, height, job);
}

static int set_lights(struct tia_view *view, const struct tia_light *lights, uint32_t count)
{
    int status = tia_drawing.set_lights(view, lights, count);

    now.legend.lights = count;
    return status || !now.views.draws_rays ? status : collect_rays(view, now.views.x, now.views.y);
}

static int draw_false(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile,
                      const struct tia_surface *surface, const struct tia_options *options)
{
    int status = TIA_OK;

    for (unsigned i = 0; i < (unsigned)tile.width * tile.height && !status; i++) {
        unsigned x = i % tile.width, y = i / tile.width;
        struct tia_tile pixel = {(uint16_t)(tile.x + x), (uint16_t)(tile.y + y), 1, 1};
        char *row = (char *)surface->pixels + (ptrdiff_t)y * surface->pitch;
        struct seen seen = {.rays = 0};
        struct tia_observer observer = {seen_ray, &seen, 0};
        const struct tia_debug debug = {.observer = &observer};
        struct tia_options observed = *options;
        tia_rgb565 colour;

        observed.debug = &debug;
        status = tia_drawing.light(view, hits, pixel, &(struct tia_surface){.pixels = &colour, .step = 2, .pitch = 2},
                                   &observed);
        *(tia_rgb565 *)(void *)(row + (ptrdiff_t)x * surface->step) =
            seen_colour(&seen, now.views.view, observer.tests, now.legend.scale);
    }
    return status;
}

static int light(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile,
                 const struct tia_surface *surface, const struct tia_options *options)
{
    int status = now.views.view == VIEW_COLOUR ? tia_drawing.light(view, hits, tile, surface, options)
                                               : draw_false(view, hits, tile, surface, options);

    for (unsigned i = 0; !status && now.views.draws_rays && i < now.line_count; i++)
        line_draw(&now.lines[i], tile, surface);
    if (!status)
        legend_draw(&now.legend, tile, surface);
    return status;
}

static int render(const struct tia_view *view, struct tia_hits *hits, struct tia_tile tile,
                  const struct tia_surface *surface, const struct tia_options *options)
{
    int status = tia_drawing.trace(view, hits, tile);

    return status ? status : light(view, hits, tile, surface, options);
}

const struct tia_core *views_core(const struct views *views, const struct tia_core *watched)
{
    now.views = *views;
    now.watched = watched;
    now.core = *watched;
    now.core.view_init = view_init;
    now.core.drawing = &now.drawing;
    now.drawing = tia_drawing;
    now.drawing.set_lights = set_lights;
    now.drawing.light = light;
    now.drawing.render = render;
    return &now.core;
}

int views_point(const struct tia_view *view, unsigned x, unsigned y, const struct line **lines, unsigned *count)
{
    int status = collect_rays(view, x, y);

    *lines = now.lines;
    *count = status ? 0 : now.line_count;
    return status;
}

/* Changes the scene so that rays draw it. Spans do not support a reference point, so the camera gets one along -z, the
 * direction in which it looks. */
void views_need_rays(struct tia_scene *scene)
{
    struct tia_camera *c = &scene->camera;

    if (tia_draws_by_pixel(scene) || scene->shadows != TIA_SHADOWS_TRACED)
        return;
    c->up = (struct tia_vec3){0, TIA_Q16_ONE, 0};
    c->reference = c->eye;
    c->reference.z -= TIA_Q16_ONE;
}
