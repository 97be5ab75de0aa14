/* pixels.c - draws the pixels of a tile, ray by ray; this renderer draws any scene. */
#include "observe.h"
#include "render/core/dither.h"
#include "samples/sobol.h"
#include "whitted.h"

/* Finds the hit of a ray from the eye. `sample` is 0 only for the first sample of the first channel. That sample's
 * object is read from *object or, if path->traces, stored there. */
static void find_first(struct path *path, int x, int y, int sample, uint32_t *object, const struct ray *ray,
                       struct hit *hit)
{
    path->known = false;
    if (path->first) {
        path->known = path->first->find(path->first, x, y, sample, ray, hit, &path->lit);
        return;
    }
    if (sample == 0 && !path->traces && !path_is_watched(path)) { /* observers count the tests of the search, too */
        ray_intersect_object(path->view, ray, *object, hit);
        return;
    }
    ray_intersect(path->view, ray, hit);
    *object = sample == 0 ? hit->object : *object;
}

/* Adds to `mean` the mean of a pixel's samples for a channel; each sample is clamped. `object` is as in find_first. */
static void add_channel(struct path *path, const struct light_pixel *at, int channel, uint32_t *object,
                        num_length mean[3])
{
    const struct ray_camera *camera = &path->view->camera;
    int samples = camera->side * camera->side;

    path->class = path->first ? 0 : ray_pixel_class(at->x, at->y);
    for (int i = 0; i < samples && !path_stops(path); i++) {
        struct ray ray;
        struct hit hit;
        num_length colour[3];

        path->next_reached = i + channel == 0 ? 0 : PATH_REACHED;
        path->pixel = path->view->filtered ? at : NULL;
        path->sample = i;
        path->seed = sampler_of((uint32_t)i, at->x, at->y, 0).seed;
        ray_camera_ray(camera, at, i, &ray);
        observe_count(path, &ray);
        find_first(path, at->x, at->y, i + channel, object, &ray, &hit);
        ray_intersect_lights(path->view, &ray, &hit);
        path_colour(path, &ray, &hit, colour);
        for (int c = 0; c < 3; c++)
            mean[c] += num_length_clamp(colour[c], 0, NUM_LENGTH_ONE) / (num_length)samples;
    }
}

/* Computes a pixel's mean colour; if there are three channels, each has separate rays. */
static void pixel(struct path *path, int x, int y, uint32_t *object, num_length mean[3])
{
    const struct ray_camera *camera = &path->view->camera;

    mean[0] = mean[1] = mean[2] = 0;
    for (int channel = 0; channel < camera->channels; channel++) {
        num_length all[3] = {0, 0, 0};
        struct light_pixel at;

        if (ray_camera_pixel(camera, x, y, channel, &at))
            add_channel(path, &at, channel, object, all);
        else
            *object = TIA_NO_OBJECT;
        for (int c = 0; c < 3; c++)
            mean[c] = camera->channels == 1 || c == channel ? all[c] : mean[c];
    }
}

/* Quantises a pixel. All 45 fractional bits are rounded at once: rounding twice could give the wrong level. */
static tia_rgb565 pack(const num_length mean[3], num_u threshold)
{
    unsigned r = num_levels(mean[0], 31, threshold), g = num_levels(mean[1], 63, threshold),
             b = num_levels(mean[2], 31, threshold);

    return (tia_rgb565)(r << 11 | g << 5 | b);
}

static void put_colours(const num_length mean[3], uint16_t *colours)
{
    for (int c = 0; c < 3; c++)
        colours[c] = (uint16_t)num_levels(mean[c], 65535, NUM_ROUND);
}

/* A tile's job: view, target and options. */
struct job {
    const struct tia_view *view;
    const struct tia_hits *hits;
    struct tia_tile tile;
    const struct tia_surface *surface;
    const struct tia_options *options;
    const struct first_hits *first; /* hits found without rays; NULL: rays find all hits */
    bool traces;                    /* the hits are found here, and stored */
};

/* Draws a row. Returns false if the row was stopped. */
static bool row(const struct job *job, int y)
{
    const struct tia_options *options = job->options;
    size_t before = (size_t)(y - (int)job->tile.y) * job->tile.width;
    char *out = (char *)job->surface->pixels + (y - (int)job->tile.y) * job->surface->pitch;
    const struct tia_debug debug = options_debug(options);
    uint32_t *path_hash = debug.path_hash ? debug.path_hash + before : NULL;
    uint32_t *objects = job->hits->object + hits_index(job->hits, job->tile.x, (unsigned)y);
    struct path path = {
        .view = job->view->prepared, .first = job->first, .traces = job->traces, .hashed = path_hash != NULL};
    num_u threshold[8];

    observe_begin(&path, options);
    for (int i = 0; i < PATH_BLOCKERS; i++)
        path.blocker[i] = TIA_NO_OBJECT;
    dither_thresholds(options->dither, y, threshold);
    for (int i = 0; i < (int)job->tile.width && !path.stopped; i++) {
        int x = (int)job->tile.x + i;
        num_length mean[3];

        path.hash = PATH_HASH;
        path.reached = 0;
        pixel(&path, x, y, &objects[i], mean);
        *(tia_rgb565 *)(void *)(out + i * job->surface->step) =
            surface_order(job->surface, pack(mean, threshold[x & 7]));
        if (options->colours)
            put_colours(mean, options->colours + 3 * (before + (size_t)i));
        if (path_hash)
            path_hash[i] = path.hash;
        if (debug.lit)
            debug.lit[before + (size_t)i] = path.reached;
    }
    return !path.stopped;
}

static void draw(const struct job *job)
{
    bool goes_on = true;

    for (int y = (int)job->tile.y; y < tile_bottom(job->tile) && goes_on; y++)
        goes_on = row(job, y);
}

void whitted_light_tile(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile,
                        const struct tia_surface *surface, const struct tia_options *options,
                        const struct first_hits *first)
{
    draw(&(const struct job){view, hits, tile, surface, options, first, false});
}

static void light_tile(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile,
                       const struct tia_surface *surface, const struct tia_options *options)
{
    whitted_light_tile(view, hits, tile, surface, options, NULL);
}

/* Traces and lights a tile in one pass, in which each ray from the eye is traced only once. */
static void render_tile(const struct tia_view *view, struct tia_hits *hits, struct tia_tile tile,
                        const struct tia_surface *surface, const struct tia_options *options)
{
    draw(&(const struct job){view, hits, tile, surface, options, NULL, true});
}

const struct renderer whitted_renderer = {
    .prepared_size = ray_prepared_size,
    .prepare = ray_prepare,
    .set_lights = ray_set_lights,
    .trace = ray_trace_tile,
    .light = light_tile,
    .by_pixel = true,
    .part = SIMD_RAYS,
    .render = render_tile,
};
