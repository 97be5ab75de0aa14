/* enclosed.c - finds lights that are not visible from outside, since they are inside an object. */
#include "estimate.h"

enum { WAYS = 14 };

/* Returns direction i of the 14 from a cube's centre to its faces and corners, slightly off all symmetries. */
static struct num_dir way(unsigned i)
{
    const num_unit much = NUM_UNIT_ONE / 2, little = NUM_UNIT_ONE / 64;
    num_unit part[3];

    for (unsigned c = 0; c < 3; c++) {
        part[c] = little * (num_unit)(1 + c);
        if (i >= 6)
            part[c] += (i - 6) >> c & 1 ? -much : much;
        else if (i / 2 == c)
            part[c] = i & 1 ? -much : much;
    }
    return num_dir_normalised((struct num_dir){part[0], part[1], part[2]});
}

static bool is_opaque(const struct ray_view *view, const struct hit *hit)
{
    const struct tia_material *m = &view->scene->materials[ray_material(view, hit->object, hit->element)];

    return !m->opacity && !m->refraction.r && !m->refraction.g && !m->refraction.b;
}

/* Returns the opaque object that rays from the point hit in all 14 directions, at distances of `least` or more;
 * TIA_NO_OBJECT if there is no such object. */
static uint32_t around(const struct ray_view *view, struct num_point point, num_length least)
{
    uint32_t object = TIA_NO_OBJECT;

    for (unsigned i = 0; i < WAYS; i++) {
        const struct ray ray = {.origin = point, .direction = way(i)};
        struct hit hit;
        ray_intersect(view, &ray, &hit);
        if (hit.object == TIA_NO_OBJECT || hit.t < least || (i && hit.object != object) || !is_opaque(view, &hit))
            return TIA_NO_OBJECT;
        object = hit.object;
    }
    return object;
}

/* True if the light's edge is inside the object. Tests a rectangle's corners, or four points of a disc's edge. */
static bool edge_is_inside(const struct ray_view *view, const struct ray_light *light, uint32_t object)
{
    for (int i = 0; i < 4; i++) {
        struct num_point at = light->centre;
        if (tia_light_has(light->kind, TIA_LIGHT_DISC))
            at = num_point_at(at, light->axes[i >> 1], i & 1 ? -light->radius : light->radius);
        for (int s = 0; s < 2 && tia_light_has(light->kind, TIA_LIGHT_SIDES); s++)
            at = i >> s & 1 ? num_point_sub(at, light->side[s]) : num_point_add(at, light->side[s]);
        if (around(view, at, 0) != object)
            return false;
    }
    return true;
}

uint32_t estimate_enclosing(const struct tia_view *view, uint32_t number)
{
    const struct ray_view *rays = view->prepared;
    const struct ray_light *light = &rays->lights[number];
    bool flat = tia_light_has(light->kind, TIA_LIGHT_DISC | TIA_LIGHT_SIDES);

    if (tia_light_has(light->kind, TIA_LIGHT_PLACELESS))
        return TIA_NO_OBJECT;
    uint32_t object = around(rays, light->centre, flat ? 0 : light->radius);
    if (object == TIA_NO_OBJECT || (flat && !edge_is_inside(rays, light, object)))
        return TIA_NO_OBJECT;
    return around(rays, num_point_of(view->scene->camera.eye), 0) == object ? TIA_NO_OBJECT : object;
}
