/* pixels.c - a tile's pixels, ray by ray: the renderer of any scene. */
#include "render/dither.h"
#include "whitted.h"

static void trace_tile(const struct tia_view *view, struct tia_hits *hits, struct tia_tile tile)
{
    const struct ray_view *rays = view->prepared;
    struct path path = {.view = rays};

    for (int y = (int)tile.y; y < tile_bottom(tile); y++) {
        for (int x = (int)tile.x; x < tile_right(tile) && !path_stops(&path); x++) {
            struct ray ray;
            struct hit hit;

            ray_camera_ray(&rays->camera, x, y, 0, &ray);
            ray_intersect(rays, &ray, &hit);
            hits->object[hits_index(hits, (unsigned)x, (unsigned)y)] = hit.object;
        }
    }
}

/* What the ray of a pixel's sample meets; `object` is what the first one does. */
static void find_first(struct path *path, int x, int y, int sample, uint32_t object, const struct ray *ray,
                       struct hit *hit)
{
    path->known = false;
    if (path->first)
        path->known = path->first->find(path->first, x, y, sample, ray, hit, &path->lit);
    else if (sample == 0 && !path->observer) /* who counts tests wants those of the search */
        ray_intersect_object(path->view, ray, object, hit);
    else
        ray_intersect(path->view, ray, hit);
}

/* The mean of a pixel's samples, each clamped. `object` is what the first one meets. */
static void pixel(struct path *path, int x, int y, uint32_t object, num_length mean[3])
{
    const struct ray_camera *camera = &path->view->camera;
    int samples = camera->side * camera->side;

    mean[0] = mean[1] = mean[2] = 0;
    for (int i = 0; i < samples && !path_stops(path); i++) {
        struct ray ray;
        struct hit hit;
        num_length colour[3];

        path->next_reached = i == 0 ? 0 : PATH_REACHED;
        ray_camera_ray(camera, x, y, i, &ray);
        ray.tests = path->tests;
        find_first(path, x, y, i, object, &ray, &hit);
        ray_intersect_lights(path->view, &ray, &hit);
        path_colour(path, &ray, &hit, colour);
        for (int c = 0; c < 3; c++)
            mean[c] += num_length_clamp(colour[c], 0, NUM_LENGTH_ONE) / (num_length)samples;
    }
}

/* Quantises all 45 fraction bits at once: rounded twice, a value between two levels could go to the wrong one. */
static tia_rgb565 pack(const num_length mean[3], num_u threshold)
{
    unsigned r = num_levels(mean[0], 31, threshold), g = num_levels(mean[1], 63, threshold),
             b = num_levels(mean[2], 31, threshold);

    return (tia_rgb565)(r << 11 | g << 5 | b);
}

/* False: it was stopped. */
static bool row(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile, int y, char *out,
                ptrdiff_t step, const struct tia_options *options, const struct first_hits *first)
{
    size_t before = (size_t)(y - (int)tile.y) * tile.width;
    uint32_t *path_hash = options->path_hash ? options->path_hash + before : NULL;
    const uint32_t *objects = hits->object + hits_index(hits, tile.x, (unsigned)y);
    struct path path = {.view = view->prepared, .first = first, .hashed = path_hash, .observer = options->observer};
    num_u threshold[8];

    path.tests = options->observer ? &options->observer->tests : NULL;
    for (int i = 0; i < PATH_BLOCKERS; i++)
        path.blocker[i] = TIA_NO_OBJECT;
    dither_thresholds(options->dither, y, threshold);
    for (int i = 0; i < (int)tile.width && !path.stopped; i++) {
        int x = (int)tile.x + i;
        num_length mean[3];

        path.class = first ? 0 : ray_pixel_class(x, y);
        path.hash = PATH_HASH;
        path.reached = 0;
        pixel(&path, x, y, objects[i], mean);
        *(tia_rgb565 *)(void *)(out + i * step) = pack(mean, threshold[x & 7]);
        if (path_hash)
            path_hash[i] = path.hash;
        if (options->lit)
            options->lit[before + (size_t)i] = path.reached;
    }
    return !path.stopped;
}

void whitted_light_tile(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile,
                        const struct tia_surface *surface, const struct tia_options *options,
                        const struct first_hits *first)
{
    bool goes_on = true;

    for (int y = (int)tile.y; y < tile_bottom(tile) && goes_on; y++) {
        char *out = (char *)surface->pixels + (y - (int)tile.y) * surface->pitch;
        goes_on = row(view, hits, tile, y, out, surface->step, options, first);
    }
}

static void light_tile(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile,
                       const struct tia_surface *surface, const struct tia_options *options)
{
    whitted_light_tile(view, hits, tile, surface, options, NULL);
}

static bool draws(const struct tia_scene *scene)
{
    (void)scene;
    return true;
}

static uint64_t buffer_size(const struct tia_scene *scene, uint32_t pixels)
{
    (void)scene;
    (void)pixels;
    return 0;
}

const struct renderer whitted_renderer = {draws,      ray_prepared_size, ray_prepare, ray_set_lights, buffer_size,
                                          trace_tile, light_tile,        false,       true,           NULL};
