/* chain.h - the mirror_chain of mirrors.h, named CHAIN, in the arithmetic for which it is compiled. */
#include "mirrors.h"
#include "render/trace/shading.h"

static mirror_real real_of(num_length x)
{
    return (mirror_real)x / (mirror_real)NUM_LENGTH_ONE;
}

unsigned CHAIN(const struct tia_view *view, int x, int y, unsigned most, struct mirror_hit hits[])
{
    const struct ray_view *rays = view->prepared;
    struct light_pixel pixel = ray_pixel_at(x, y);
    struct shading s;
    struct ray ray;
    struct hit hit;
    unsigned count = 0;

    ray_camera_ray(&rays->camera, &pixel, 0, &ray);
    for (; count < most; count++) {
        ray_intersect(rays, &ray, &hit);
        if (hit.object == TIA_NO_OBJECT)
            break;
        shading_prepare(rays, rays->bias, &ray, &hit, &s);
        hits[count] = (struct mirror_hit){hit.object, {real_of(s.point.x), real_of(s.point.y), real_of(s.point.z)}};
        ray.origin = s.outside;
        ray.direction = shading_mirrored(&s);
    }
    return count;
}
