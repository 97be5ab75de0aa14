/* pixels.c - a tile's pixels, ray by ray. */
#include "ray_view.h"
#include "rgb565.h"
#include "span/kernels.h"
#include "whitted.h"

void ray_trace(const struct tia_view *view, struct tia_hits *hits, struct tia_tile tile)
{
    for (int y = tile.y; y < tile.y + tile.height; y++) {
        for (int x = tile.x; x < tile.x + tile.width; x++) {
            struct ray ray;
            struct hit hit;

            ray_camera_ray(&view->rays->camera, x, y, 0, &ray);
            ray_nearest(view->rays, &ray, &hit);
            hits->object[hits_index(hits, (unsigned)x, (unsigned)y)] = hit.object;
        }
    }
}

/* The mean of a pixel's samples, each clamped. `object` is what the first one meets. */
static void pixel(struct path *path, int x, int y, uint32_t object, num_x mean[3])
{
    const struct ray_camera *camera = &path->view->camera;
    int samples = camera->side * camera->side;

    mean[0] = mean[1] = mean[2] = 0;
    for (int i = 0; i < samples; i++) {
        struct ray ray;
        struct hit hit;
        num_x colour[3];

        ray_camera_ray(camera, x, y, i, &ray);
        if (i == 0)
            ray_meet(path->view, &ray, object, &hit);
        else
            ray_nearest(path->view, &ray, &hit);
        ray_see_lights(path->view, &ray, &hit);
        path_colour(path, &ray, &hit, colour);
        for (int c = 0; c < 3; c++)
            mean[c] += num_x_clamp(colour[c], 0, NUM_X_ONE) / (num_x)samples;
    }
}

/* Up to CHUNK pixels of a row. */
static void pixels(struct path *path, const struct tia_hits *hits, int x, int y, int count, const num_u threshold[8],
                   uint32_t *reached, tia_rgb565 *out)
{
    num_u rgb[3][CHUNK];

    for (int i = 0; i < count; i++) {
        num_x mean[3];

        path->class = ray_pixel_class(x + i, y);
        path->hash = PATH_HASH;
        pixel(path, x + i, y, hits->object[hits_index(hits, (unsigned)(x + i), (unsigned)y)], mean);
        for (int c = 0; c < 3; c++)
            rgb[c][i] = num_shown(mean[c]);
        if (reached)
            reached[i] = path->hash;
    }
    kernel_pack(rgb[0], rgb[1], rgb[2], threshold, x, count, out);
}

static void row(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile, int y, char *out,
                ptrdiff_t step, const struct tia_options *options)
{
    uint32_t *reached = options->reached ? options->reached + (size_t)(y - tile.y) * tile.width : NULL;
    struct path path = {.view = view->rays, .hashed = reached != NULL};
    tia_rgb565 packed[CHUNK];
    num_u threshold[8];

    for (int i = 0; i < PATH_BLOCKERS; i++)
        path.blocker[i] = TIA_NO_OBJECT;
    rgb565_thresholds(options->dither, y, threshold);
    for (int x = 0; x < tile.width; x += CHUNK) {
        int count = tile.width - x < CHUNK ? tile.width - x : CHUNK;

        pixels(&path, hits, tile.x + x, y, count, threshold, reached ? reached + x : NULL, packed);
        for (int i = 0; i < count; i++)
            *(tia_rgb565 *)(void *)(out + (x + i) * step) = packed[i];
    }
}

void ray_light(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile,
               const struct tia_surface *surface, const struct tia_options *options)
{
    for (int y = tile.y; y < tile.y + tile.height; y++) {
        char *out = (char *)surface->pixels + (y - tile.y) * surface->pitch;
        row(view, hits, tile, y, out, surface->step, options);
    }
}
