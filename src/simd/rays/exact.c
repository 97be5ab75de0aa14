/* exact.c - draws undecided samples, and undecided rays within samples, by the fixed-point path. */
#include "bounds.h"
#include "sure.h"

static void begin(struct path *path, const struct ray_view *view, int x, int y)
{
    *path = (struct path){.view = view, .class = ray_pixel_class(x, y), .next_reached = PATH_REACHED};
    for (int k = 0; k < PATH_BLOCKERS; k++)
        path->blocker[k] = TIA_NO_OBJECT;
}

void tia_sure_sample(const struct ray_view *view, int x, int y, int i, num_length colour[3])
{
    const struct light_pixel pixel = ray_pixel_at(x, y);
    struct path path;
    struct ray ray;
    struct hit hit;

    begin(&path, view, x, y);
    ray_camera_ray(&view->camera, &pixel, i, &ray);
    ray_intersect(view, &ray, &hit);
    ray_intersect_lights(view, &ray, &hit);
    path_colour(&path, &ray, &hit, colour);
}

void tia_sure_add_rests(struct sure_block *b)
{
    const struct ray_view *view = b->scene->view;
    uint32_t rays = 0; /* of all samples; TIA_RAYS_MAX counts those of one, half of which the kernels may use up */

    for (int k = 0; k < b->rest_count; k++) {
        const struct sure_rest *rest = &b->rest[k];
        int i = (int)rest->slot;
        struct sure_place p = sure_place_of(b, i / b->samples);
        const struct light_pixel pixel = ray_pixel_at(b->x + p.x, b->y + p.y);
        struct bounce first = {.throughput = {NUM_LENGTH_ONE, NUM_LENGTH_ONE, NUM_LENGTH_ONE}};
        num_length colour[3];
        struct path path;

        if (b->unsure[i] || cancelled(&b->cancel, CANCEL_INTERVAL))
            continue;
        begin(&path, view, b->x + p.x, b->y + p.y);
        ray_camera_ray(&view->camera, &pixel, i % b->samples, &first.ray);
        rays += path_resume(&path, &first, &rest->route, colour);
        b->unsure[i] = rays > TIA_RAYS_MAX / 2;
        for (int c = 0; c < 3; c++) {
            double part = sure_length(colour[c]);
            b->colour[c][i] += part;
            b->error[i] += BOUND(EXACT_REST) * (1 + part);
        }
    }
    b->rest_count = 0;
}
