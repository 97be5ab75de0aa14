#include "view.h"

#include "angle.h"
#include "math.h"
#include "rgb565.h"
#include "shape/sphere.h"

num_wide view_reach(const struct tia_view *view, struct num_vec a)
{
    num_wide reach = num_abs(a.x) * view->x_reach + num_abs(a.y) * view->y_reach + num_abs(a.z) * view->depth;
    return reach + num_shift(reach, -20); /* room for NUM_HALF */
}

num_wide view_lattice_y(const struct tia_view *view, int y)
{
    return num_lattice(view->height - 2 * y - 1, view->exponent);
}

struct row_form view_row_form(const struct tia_view *view, struct num_vec a, int x, int y, int shift)
{
    int middle = view->width / 2;
    num_wide lattice = num_lattice(2 * middle + 1 - view->width, view->exponent);
    num_wide start = a.x * lattice + a.y * view_lattice_y(view, y) - a.z * view->depth;
    struct row_form form = {num_shift(start, shift) + NUM_HALF, num_shift(a.x * num_lattice(2, view->exponent), shift)};

    /* From the middle no product is larger than the form itself; and where the shift rounds, every
     * pixel's value is the same wherever a run begins. */
    form.start += (num_wide)(x - middle) * form.step;
    return form;
}

struct row_square view_row_square(const struct tia_view *view, int x, int y)
{
    int shift = view->square_shift;
    num_wide first = num_lattice(2 * x + 1 - view->width, view->exponent), row = view_lattice_y(view, y);
    num_wide step = num_lattice(2, view->exponent);
    num_wide square = first * first + row * row + view->depth * view->depth;
    struct row_square s = {num_shift(square, shift) + NUM_HALF, num_shift(step * (2 * first + step), shift),
                           num_shift(2 * step * step, shift)};

    return s;
}

bool view_tile_inside(struct tia_tile tile, unsigned x, unsigned y, unsigned width, unsigned height)
{
    return tile.width && tile.height && tile.x >= x && tile.y >= y && tile.x - x + tile.width <= width &&
           tile.y - y + tile.height <= height;
}

/* The lattice's exponent makes |v| < 2^30 in every pixel, and beyond the last one as far as row_square
 * looks: its step there, 4 X + 4 for X = width + 1 and less, is below (width + 3)^2. */
static void prepare_lattice(struct tia_view *view)
{
    uint64_t cotangent = tia_cotangent(view->scene->camera.fov);
    uint64_t w = (uint64_t)view->width + 3, h = (uint64_t)view->height + 1;
    uint64_t d = (h * ((cotangent >> 40) + 1) >> 16) + 1;
    int bits = 64 - (int)tia_clz64(w * w + h * h + d * d);

    view->exponent = 30 - (bits + 1) / 2;
    view->depth = num_depth((uint32_t)view->height, cotangent, view->exponent);
    view->x_reach = num_lattice((int32_t)w, view->exponent);
    view->y_reach = num_lattice((int32_t)h, view->exponent);
    num_wide most = view->x_reach * view->x_reach + view->y_reach * view->y_reach + view->depth * view->depth;
    view->square_shift = 63 - num_bits(most + num_shift(most, -20));
}

static void prepare_light(struct tia_view *view, uint32_t n)
{
    struct body *body = &view->bodies[view->scene->sphere_count + n];
    sphere_prepare(view, body, view->lights[n].centre, view->lights[n].radius);
}

static void prepare_spheres(struct tia_view *view)
{
    const struct tia_scene *scene = view->scene;

    for (uint32_t i = 0; i < scene->sphere_count; i++) {
        const struct tia_sphere *s = &scene->spheres[i];
        const struct tia_rgb *through = &scene->materials[s->material].transmission;
        sphere_prepare(view, &view->bodies[i], s->centre, s->radius);
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
    v->width = (int)width;
    v->height = (int)height;
    v->tinted = false;
    v->grey_shadows = true;
    prepare_lattice(v);
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
