#include "trace.h"

#define PATIENCE 16 /* number of rays between two calls of `stop`, which may read a clock or a keyboard */

void ray_trace_tile(const struct tia_view *view, struct tia_hits *hits, struct tia_tile tile)
{
    const struct ray_view *rays = view->prepared;
    unsigned count = 0;

    for (int y = (int)tile.y; y < tile_bottom(tile); y++) {
        for (int x = (int)tile.x; x < tile_right(tile); x++) {
            struct light_pixel pixel;
            struct ray ray;
            struct hit hit;

            if (++count % PATIENCE == 0 && view_stops(view))
                return;
            hit.object = TIA_NO_OBJECT;
            if (ray_camera_pixel(&rays->camera, x, y, 0, &pixel)) {
                ray_camera_ray(&rays->camera, &pixel, 0, &ray);
                ray_intersect(rays, &ray, &hit);
            }
            hits->object[hits_index(hits, (unsigned)x, (unsigned)y)] = hit.object;
        }
    }
}
