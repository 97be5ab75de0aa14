/* solid_rays.h - rays at the scene of solid_made.h. */
#ifndef TESTS_SOLID_RAYS_H
#define TESTS_SOLID_RAYS_H

#include "check.h"
#include "render/trace/trace.h"
#include "solid_made.h"

#include <math.h>

#define NEAR(got, want)                                                                                                \
    CHECK_MSG(fabs((got) - (want)) < 1e-9, "%s is %.12g, not %.12g", #got, (double)(got), (double)(want))

static struct tia_view *view;
static void *memory;

static void close_view(void)
{
    free(memory);
    memory = NULL;
}

static void open_view(void)
{
    size_t size = tia_view_size(&scene, 1);
    struct tia_fault fault = {0};

    CHECK_MSG(!tia_scene_check(&scene, &fault), "%s %u: %s: %s", fault.thing, fault.index, fault.field, fault.rule);
    close_view();
    memory = malloc(size);
    CHECK_EQ(tia_view_init(&view, memory, size, &scene, 1, 16, 16, NULL), TIA_OK);
}

static struct num_point point_of(double x, double y, double z)
{
    return (struct num_point){num_length_of_q45((int64_t)ldexp(x, 45)), num_length_of_q45((int64_t)ldexp(y, 45)),
                              num_length_of_q45((int64_t)ldexp(z, 45))};
}

static struct ray ray_of(double x, double y, double z, double dx, double dy, double dz)
{
    struct num_dir d = num_dir_normalised((struct num_dir){num_unit_of_q62((int64_t)ldexp(dx, 60)),
                                                           num_unit_of_q62((int64_t)ldexp(dy, 60)),
                                                           num_unit_of_q62((int64_t)ldexp(dz, 60))});

    return (struct ray){.origin = point_of(x, y, z), .direction = d};
}

/* A hit's distance, its member, and the normal against the ray's direction: 0 if there is none. */
struct found {
    double t, facing;
    struct num_dir normal;
    uint32_t material;
    bool met;
};

static double real_of(num_length x)
{
    return (double)x / (double)NUM_LENGTH_ONE;
}

static struct found cast(struct ray ray)
{
    const struct ray_view *rays = view->prepared;
    struct found found = {.met = false};
    struct surface surface;
    struct hit hit;

    ray_intersect(rays, &ray, &hit);
    if (hit.object == TIA_NO_OBJECT)
        return found;
    ray_surface(rays, &hit, num_point_at(ray.origin, ray.direction, hit.t), &surface);
    found.met = true;
    found.t = real_of(hit.t);
    found.normal = surface.normal;
    found.facing = (double)num_dir_dot(surface.normal, ray.direction) / (double)NUM_UNIT_ONE;
    found.material = ray_material(rays, hit.object, hit.element);
    return found;
}

/* Checks the hit of a ray: its distance, or none if that is negative, the material, and the side that is met. */
static void expect(struct ray ray, double t, uint32_t material, bool enters)
{
    struct found found = cast(ray);

    CHECK_MSG(found.met == (t >= 0), "met: %d, not %d", found.met, t >= 0);
    if (t < 0)
        return;
    NEAR(found.t, t);
    CHECK_MSG(found.material == material, "material %u, not %u", found.material, material);
    CHECK_MSG((found.facing < 0) == enters, "normal at %g against the ray", found.facing);
}

#endif
