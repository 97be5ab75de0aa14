#include "trace.h"

#include "samples/direction.h"

num_length ray_openness(const struct ray_view *view, const struct ray_place *place, const uint32_t u[2],
                        num_length distance, uint32_t *blocker)
{
    struct ray ray = {.origin = place->outside};
    int64_t local[3];
    num_length through;

    tia_sample_cosine(u, local);
    ray.direction = ray_around(place->normal, num_dir_of_q62(local));
    if (num_dir_dot(ray.direction, place->geometric) <= 0)
        return 0;
    return ray_visibility(view, &ray, distance, blocker, &through) ? through : 0;
}
