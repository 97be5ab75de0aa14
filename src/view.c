#include "view.h"

#include "rgb565.h"

static bool is_inside(struct tia_tile tile, struct tia_tile area)
{
    return tile.width && tile.height && tile.x >= area.x && tile.y >= area.y &&
           tile.x - area.x + tile.width <= area.width && tile.y - area.y + tile.height <= area.height;
}

bool view_has_tile(const struct tia_view *view, struct tia_tile area, struct tia_tile tile)
{
    struct tia_tile image = {0, 0, (uint16_t)view->lattice.width, (uint16_t)view->lattice.height};

    return is_inside(tile, image) && is_inside(tile, area);
}

void view_keep_nearer(const struct tia_view *view, uint32_t n, const num_u *t, int count, num_u *best, uint32_t *object)
{
    int exponent = view->bodies[n].t_exponent;

    for (int i = 0; i < count; i++) {
        if (object[i] == TIA_NO_OBJECT || num_nearer(t[i], exponent, best[i], view->bodies[object[i]].t_exponent)) {
            best[i] = t[i];
            object[i] = n;
        }
    }
}

static void prepare_body(const struct tia_view *view, struct body *body, struct tia_vec3 centre, tia_q16 radius)
{
    sphere_prepare(&view->lattice, body, num_vec_between(view->scene->camera.eye, centre), radius);
}

static void prepare_light(struct tia_view *view, uint32_t n)
{
    struct body *body = &view->bodies[view->scene->sphere_count + n];
    prepare_body(view, body, view->lights[n].centre, view->lights[n].radius);
}

static void prepare_spheres(struct tia_view *view)
{
    const struct tia_scene *scene = view->scene;

    for (uint32_t i = 0; i < scene->sphere_count; i++) {
        const struct tia_sphere *s = &scene->spheres[i];
        const struct tia_rgb *through = &scene->materials[s->material].transmission;
        prepare_body(view, &view->bodies[i], s->centre, s->radius);
        view->tinted = view->tinted || !rgb565_is_black(through);
        view->grey_shadows = view->grey_shadows && rgb565_is_grey(through);
    }
}

#define ALIGN(size) (((size) + 7) & ~(size_t)7)

size_t tia_view_size(const struct tia_scene *scene, uint32_t light_capacity)
{
    uint64_t bodies = (uint64_t)scene->sphere_count + light_capacity;

    if (bodies > (SIZE_MAX - sizeof(struct tia_view)) / (2 * sizeof(struct body)))
        return SIZE_MAX;
    return ALIGN(sizeof(struct tia_view)) + ALIGN((size_t)bodies * sizeof(struct body)) +
           ALIGN(light_capacity * sizeof(struct tia_light));
}

int tia_view_init(struct tia_view **view, void *memory, size_t size, const struct tia_scene *scene,
                  uint32_t light_capacity, unsigned width, unsigned height)
{
    struct tia_view *v = memory;

    if (!width || !height || width > TIA_SIZE_MAX || height > TIA_SIZE_MAX || light_capacity < scene->light_count)
        return TIA_ERR_ARGUMENT;
    if (size < tia_view_size(scene, light_capacity))
        return TIA_ERR_MEMORY;
    if (tia_scene_check(scene, NULL) != TIA_OK)
        return TIA_ERR_RANGE;
    v->scene = scene;
    v->bodies = (struct body *)((char *)memory + ALIGN(sizeof *v));
    v->lights =
        (struct tia_light *)((char *)v->bodies + ALIGN((scene->sphere_count + light_capacity) * sizeof(struct body)));
    v->light_count = 0;
    v->light_capacity = light_capacity;
    v->tinted = false;
    v->grey_shadows = true;
    lattice_prepare(&v->lattice, width, height, scene->camera.fov);
    prepare_spheres(v);
    *view = v;
    return tia_view_set_lights(v, scene->lights, scene->light_count);
}

int tia_view_set_lights(struct tia_view *view, const struct tia_light *lights, uint32_t count)
{
    struct tia_scene changed = *view->scene;

    changed.lights = lights;
    changed.light_count = count;
    if (count > view->light_capacity)
        return TIA_ERR_MEMORY;
    if (tia_scene_check(&changed, NULL) != TIA_OK)
        return TIA_ERR_RANGE;
    view->light_count = count;
    view->grey = view->grey_shadows;
    for (uint32_t i = 0; i < count; i++) {
        view->lights[i] = lights[i];
        view->grey = view->grey && rgb565_is_grey(&lights[i].emission);
        prepare_light(view, i);
    }
    return TIA_OK;
}
