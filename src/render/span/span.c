#include "span.h"

#include "scene/colour.h"

size_t span_size(const struct tia_scene *scene, uint32_t light_capacity)
{
    uint64_t bodies = (uint64_t)scene->sphere_count + light_capacity;

    return bodies > SIZE_MAX / 2 / sizeof(struct body) ? SIZE_MAX : (size_t)bodies * sizeof(struct body);
}

static void prepare_body(const struct tia_view *view, uint32_t n, struct tia_vec3 centre, tia_q16 radius)
{
    sphere_prepare(&view->span.lattice, &view->span.bodies[n], num_vec_between(view->scene->camera.eye, centre),
                   radius);
}

void span_prepare(struct tia_view *view, void *memory)
{
    const struct tia_scene *scene = view->scene;

    view->span.bodies = memory;
    view->span.tinted = false;
    view->span.grey_shadows = true;
    lattice_prepare(&view->span.lattice, (unsigned)view->width, (unsigned)view->height, scene->camera.fov);
    for (uint32_t i = 0; i < scene->sphere_count; i++) {
        const struct tia_sphere *s = &scene->spheres[i];
        const struct tia_rgb *through = &scene->materials[s->material].transmission;
        prepare_body(view, i, s->centre, s->radius);
        view->span.tinted = view->span.tinted || !colour_is_black(through);
        view->span.grey_shadows = view->span.grey_shadows && colour_is_grey(through);
    }
}

void span_set_lights(struct tia_view *view)
{
    view->span.grey = view->span.grey_shadows;
    for (uint32_t i = 0; i < view->light_count; i++) {
        const struct tia_light *light = &view->lights[i];
        view->span.grey = view->span.grey && colour_is_grey(&light->emission);
        prepare_body(view, view->scene->sphere_count + i, light->centre, light->radius);
    }
}

void span_keep_nearer(const struct tia_view *view, uint32_t n, const num_u *t, int count, num_u *best, uint32_t *object)
{
    const struct body *bodies = view->span.bodies;

    for (int i = 0; i < count; i++) {
        if (object[i] == TIA_NO_OBJECT ||
            num_nearer(t[i], bodies[n].t_exponent, best[i], bodies[object[i]].t_exponent)) {
            best[i] = t[i];
            object[i] = n;
        }
    }
}
