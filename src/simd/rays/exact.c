/* exact.c - draws undecided samples by the fixed-point path. */
#include "render/whitted/whitted.h"
#include "sure.h"

void tia_sure_sample(const struct ray_view *view, int x, int y, int i, num_length colour[3])
{
    struct path path = {.view = view, .class = ray_pixel_class(x, y), .next_reached = PATH_REACHED};
    const struct light_pixel pixel = ray_pixel_at(x, y);
    struct ray ray;
    struct hit hit;

    for (int k = 0; k < PATH_BLOCKERS; k++)
        path.blocker[k] = TIA_NO_OBJECT;
    ray_camera_ray(&view->camera, &pixel, i, &ray);
    ray_intersect(view, &ray, &hit);
    ray_intersect_lights(view, &ray, &hit);
    path_colour(&path, &ray, &hit, colour);
}
