/* gather.c - the data of lights, emitters and materials for paths, converted from fixed point to doubles. */
#include "gather.h"
#include "render/path/path.h"
#include "render/path/scatter.h"
#include "scene/colour.h"

#define ALIGN64(n) (((n) + 63) / 64 * 64)

struct places {
    struct sure_paths *paths;
    struct sure_shine *lights, *spheres;
    struct sure_emitter *emitters;
    struct sure_lobes *lobes;
};

/* Divides the memory at `start`, behind a struct sure_scene, into arrays. Returns the number of bytes used; if `start`
 * is NULL, only computes that. */
static uint64_t divide(char *start, const struct tia_scene *scene, uint32_t light_capacity, struct places *p)
{
    bool paths = scene->integration.integrator == TIA_PATHS;
    uint64_t lights = paths ? light_capacity : 0;
    uint64_t emitters = paths ? emitters_size(scene, light_capacity) / sizeof(struct emitter) : 0;
    const uint64_t sizes[] = {sizeof *p->paths, lights * sizeof *p->lights, (emitters - lights) * sizeof *p->spheres,
                              emitters * sizeof *p->emitters,
                              paths ? (uint64_t)scene->material_count * sizeof *p->lobes : 0};
    void *at[5];
    uint64_t used = 0;

    for (int i = 0; i < 5; i++) {
        at[i] = start ? start + used : NULL;
        used += ALIGN64(sizes[i]);
    }
    *p = (struct places){at[0], at[1], at[2], at[3], at[4]};
    return used;
}

size_t tia_gather_size(const struct tia_scene *scene, uint32_t light_capacity)
{
    size_t rays = tia_sure_size(scene, light_capacity);
    struct places places;

    if (!scene->bvh || rays >= SIZE_MAX / 4)
        return scene->bvh ? SIZE_MAX : 0;
    uint64_t size = ALIGN64((uint64_t)rays) + divide(NULL, scene, light_capacity, &places);
    return size < SIZE_MAX / 2 ? (size_t)size : SIZE_MAX;
}

static void find_places(const struct tia_view *view, struct places *p)
{
    uint64_t before = ALIGN64((uint64_t)tia_sure_size(view->scene, view->light_capacity)) - 64;

    (void)divide((char *)tia_sure_scene(view) + before, view->scene, view->light_capacity, p);
}

/* Sets the chances that scatter.c computes from a material's own colours. They are the same for every direction of the
 * surface. */
static void set_lobes(struct sure_lobes *to, const struct tia_material *m)
{
    struct shading s = {
        .material = m, .normal = {0, 0, NUM_UNIT_ONE}, .viewer = {0, 0, NUM_UNIT_ONE}, .facing = NUM_UNIT_ONE};
    struct scatter scatter;

    ray_rgb(&m->colour, s.colour);
    scatter_prepare(&scatter, &s);
    to->black = scatter.black;
    to->rough = scatter.rough;
    to->known = !(m->texture && scatter.below[2]);
    to->glow = (double)(UINT32_C(1) << m->emission_bits);
    for (int i = 0; i < 3; i++)
        to->below[i] = to->upto[i] = scatter.below[i];
    to->spread = 0;
    for (int i = 0; i < 4; i++) {
        num_unit before = i ? num_of_chance(scatter.below[i - 1]) : 0;
        to->chance[i] = sure_cosine((i < 3 ? num_of_chance(scatter.below[i]) : NUM_UNIT_ONE) - before);
    }
}

void tia_gather_prepare(struct tia_view *view)
{
    const struct tia_scene *scene = view->scene;
    struct sure_scene *s;
    struct places p;

    tia_sure_prepare(view);
    s = tia_sure_scene(view);
    find_places(view, &p);
    s->bias = sure_length(num_ray_bias(s->view->bias));
    s->paths = p.paths;
    *p.paths = (struct sure_paths){.lights = p.lights,
                                   .emitters = p.emitters,
                                   .spheres = p.spheres,
                                   .lobes = p.lobes,
                                   .bounces = scene->integration.bounces ? scene->integration.bounces : TIA_BOUNCES_MAX,
                                   .reach = scene->integration.distance
                                                ? sure_length(num_length_of(scene->integration.distance))
                                                : sure_length(NUM_LENGTH_MAX)};
    for (uint32_t i = 0; scene->integration.integrator == TIA_PATHS && i < scene->material_count; i++)
        set_lobes(&p.lobes[i], &scene->materials[i]);
}

/* Converts a density to a double; false if it is 0 or its exponent is beyond +-500. */
static bool number_of(struct num_density d, double *x)
{
    *x = (double)d.mantissa;
    if (!d.mantissa || d.exponent > 500 || d.exponent < -500)
        return false;
    for (int i = 0; i < d.exponent; i++)
        *x *= 2;
    for (int i = 0; i > d.exponent; i--)
        *x /= 2;
    return true;
}

/* True if the points of a light are within 2^-30 of its plane. Where the sides are nearly parallel, the rounding of
 * their directions turns the normal, and long sides leave the plane by more than 2^-26. Shadow rays end 2^-26 in front
 * of the plane and would meet such a light, see find_hidden(). The limit is a sixteenth of that distance, to allow for
 * roundings. */
static bool is_flat(const struct ray_light *l)
{
    num_length off = 0;

    for (int i = 0; tia_light_has(l->kind, TIA_LIGHT_SIDES) && i < 2; i++) {
        num_length side = num_point_dot(l->side[i], l->direction);
        off += side < 0 ? -side : side;
    }
    return off < NUM_LENGTH_ONE >> 30;
}

static void set_shine(struct sure_shine *to, const struct emitter *e)
{
    for (int c = 0; c < 3; c++)
        to->radiance[c] = sure_length(e->radiance[c]);
    to->area = 1;
    to->known = e->kind != EMITTER_PLANE || (is_flat(e->light) && number_of(e->area, &to->area));
}

static bool is_emitter(const struct tia_scene *scene, uint32_t sphere)
{
    return !colour_is_black(&scene->materials[scene->spheres[sphere].material].emission);
}

static void set_emitters(const struct tia_view *view, struct sure_scene *s, struct places *p)
{
    const struct emitters *from = &path_view_of(view)->emitters;
    struct sure_shine *sphere_shine = p->spheres;
    uint32_t sphere = 0;

    p->paths->emitter_count = from->count;
    p->paths->one_of = from->count ? 1.0 / from->count : 0;
    for (uint32_t i = 0; i < from->count; i++) {
        const struct emitter *e = &from->first[i];
        struct sure_emitter *to = &p->emitters[i];
        *to = (struct sure_emitter){.light = TIA_NO_OBJECT, .sphere = TIA_NO_OBJECT};
        if (e->light) {
            to->light = (uint32_t)(e->light - s->view->lights);
            to->shine = &p->lights[to->light];
            continue;
        }
        while (!is_emitter(view->scene, sphere))
            sphere++;
        to->sphere = sphere++;
        to->shine = sphere_shine;
        set_shine(sphere_shine++, e);
    }
}

void tia_gather_set_lights(struct tia_view *view)
{
    struct sure_scene *s = tia_sure_scene(view);
    struct places p;

    tia_sure_set_lights(view);
    if (view->scene->integration.integrator != TIA_PATHS)
        return;
    find_places(view, &p);
    for (uint32_t i = 0; i < s->light_count; i++) {
        struct emitter e;
        emitter_of_light(&s->view->lights[i], &view->lights[i], &e);
        set_shine(&p.lights[i], &e);
    }
    set_emitters(view, s, &p);
}
