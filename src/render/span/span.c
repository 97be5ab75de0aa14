#include "span.h"

#include "scene/colour.h"

size_t span_size(const struct tia_scene *scene, uint32_t light_capacity)
{
    uint64_t spheres = (uint64_t)scene->sphere_count + light_capacity;

    return spheres > SIZE_MAX / 2 / sizeof(struct span_sphere) ? SIZE_MAX
                                                               : (size_t)spheres * sizeof(struct span_sphere);
}

static void prepare_body(const struct tia_view *view, uint32_t n, struct tia_vec3 centre, tia_q16 radius)
{
    span_sphere_prepare(&view->span.primary, &view->span.spheres[n], num_vec_between(view->scene->camera.eye, centre),
                        radius);
}

void span_prepare(struct tia_view *view, void *memory)
{
    const struct tia_scene *scene = view->scene;

    view->span.spheres = memory;
    view->span.tinted = false;
    view->span.grey_shadows = true;
    primary_prepare(&view->span.primary, (unsigned)view->width, (unsigned)view->height, scene->camera.fov);
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
    const struct span_sphere *spheres = view->span.spheres;

    for (int i = 0; i < count; i++) {
        if (object[i] == TIA_NO_OBJECT ||
            num_nearer(t[i], spheres[n].t_exponent, best[i], spheres[object[i]].t_exponent)) {
            best[i] = t[i];
            object[i] = n;
        }
    }
}
