/* shadow.c - the objects in front of a light. */
#include "rays.h"

double oracle_opacity(const struct tia_scene *scene, const struct hit *hit, uint32_t *cell)
{
    uint32_t opacity = scene->materials[hit->material].opacity;

    *cell = ORACLE_BLENDED;
    return opacity == 0 ? 1 : oracle_texture(&scene->textures[opacity - 1], hit->u, hit->v, cell).channel[0];
}

/* Returns the fraction of the light that passes an object with opacity or cells, computed surface by surface. */
static struct colour surfaces(const struct tia_scene *scene, uint32_t object, struct ray ray, double distance)
{
    struct colour left = {{1, 1, 1}};
    unsigned layers = 0, others = 0;
    uint32_t cell;
    struct hit h;

    while (object_hit(scene, object, ray, &h) && h.t < distance) {
        const struct tia_material *m = &scene->materials[h.material];
        if (m->opacity != 0)
            left = product(left, mixed(oracle_opacity(scene, &h, &cell), rgb(m->transmission)));
        else if (others++ == 0)
            left = product(left, rgb(m->transmission));
        layers += m->opacity != 0;
        if (layers > TIA_LAYERS_MAX)
            return (struct colour){{0, 0, 0}};
        ray.origin = at(ray, h.t + oracle_bias(scene));
        distance -= h.t + oracle_bias(scene);
    }
    return left;
}

/* True if an object's surfaces may filter light differently: for a grid, and for a solid with an opacity. */
static bool is_mixed(const struct tia_scene *scene, uint32_t object)
{
    const struct tia_shape *s = object < scene->sphere_count ? NULL : &scene->shapes[object - scene->sphere_count];
    bool opacity = false;

    for (uint32_t i = 0; s && s->kind == TIA_SOLID && i < scene->solids[s->solid].member_count; i++)
        opacity = opacity || scene->materials[scene->solids[s->solid].members[i].material].opacity != 0;
    return s && (s->kind == TIA_GRID || opacity);
}

struct colour oracle_transmission(const struct tia_scene *scene, struct ray ray, double distance)
{
    struct colour left = {{1, 1, 1}};
    struct hit h;

    for (uint32_t i = 0; i < scene->sphere_count + scene->shape_count; i++) {
        if (!object_hit(scene, i, ray, &h) || h.t >= distance)
            continue;
        if (is_mixed(scene, i) || scene->materials[h.material].opacity != 0)
            left = product(left, surfaces(scene, i, ray, distance));
        else
            for (unsigned n = groups_hit(scene, i, ray, distance); n > 0; n--)
                left = product(left, rgb(scene->materials[h.material].transmission));
    }
    return left;
}
