/* transmittance.c - the objects between a point and a light.
 *
 * An object that transmits nothing ends the search. Other objects multiply the light by their transmission. Products
 * are rounded, so the factors are always applied in the order of the objects' indices, whatever the order in which the
 * objects are found. A search finds the KEPT lowest indices; if there are more, another search finds the next ones. */
#include "render/geometry/walk.h"
#include "scene/colour.h"
#include "texture.h"
#include "trace.h"

#define KEPT 16

/* An object that transmits light: it multiplies the light by `through`, `times` times. */
struct filter {
    uint32_t object, times;
    num_length through[3];
};

/* The objects with the lowest indices that transmit light, in rising order. */
struct filters {
    struct filter kept[KEPT];
    uint32_t count, from; /* number of objects; lowest index that the search accepts */
    uint32_t blocker;     /* object that transmits nothing, or TIA_NO_OBJECT */
    uint32_t missed;      /* an object that the ray certainly misses, or TIA_NO_OBJECT */
    bool more;
    bool opaque; /* objects transmit light only where an opacity texture lets it pass */
};

static void keep(struct filters *filters, const struct filter *filter)
{
    uint32_t i = filters->count;

    if (i == KEPT) {
        filters->more = true;
        if (filters->kept[KEPT - 1].object < filter->object)
            return;
        i--;
    }
    for (; i > 0 && filters->kept[i - 1].object > filter->object; i--)
        filters->kept[i] = filters->kept[i - 1];
    filters->kept[i] = *filter;
    filters->count += filters->count < KEPT;
}

/* True if the material depends on the element: for grids and solids. */
static bool has_materials(const struct ray_view *view, uint32_t object)
{
    uint32_t spheres = view->scene->sphere_count;
    enum tia_shape_kind kind = object < spheres ? TIA_SPHERE : view->scene->shapes[object - spheres].kind;

    return kind == TIA_GRID || kind == TIA_SOLID;
}

/* A shadow ray that crosses an object with an opacity texture. */
struct crossing {
    struct ray ray;
    num_length limit;
    uint32_t layers;
    bool counted; /* a surface without an opacity texture was crossed: later ones do not filter the light again */
    bool opaque;  /* see struct filters */
};

static void multiply(num_length through[3], const num_length factor[3])
{
    for (int c = 0; c < 3; c++)
        through[c] = num_product(through[c], factor[c]);
}

/* Filters the light by the surface at the hit, and moves the ray behind it. */
static void cross(const struct ray_view *view, struct crossing *crossing, const struct hit *hit, num_length through[3])
{
    const struct tia_material *m = &view->scene->materials[ray_material(view, hit->object, hit->element)];
    struct num_point point = num_point_at(crossing->ray.origin, crossing->ray.direction, hit->t);
    num_length opacity, factor[3];

    factor[0] = factor[1] = factor[2] = 0;
    if (!crossing->opaque)
        ray_rgb(&m->transmission, factor);
    if (m->opacity) {
        const struct tia_texture *t = &view->scene->textures[m->opacity - 1];
        struct texture_place place;
        ray_texture_place(view, t, hit, point, &place);
        (void)ray_texture(t, &place, &opacity);
        for (int c = 0; c < 3; c++)
            factor[c] = num_product(factor[c], opacity) + NUM_LENGTH_ONE - opacity;
    }
    if (m->opacity || !crossing->counted)
        multiply(through, factor);
    crossing->counted = crossing->counted || !m->opacity;
    crossing->layers += m->opacity != 0;
    crossing->ray.origin = num_point_at(point, crossing->ray.direction, view->bias);
    crossing->limit -= hit->t + view->bias;
}

static bool is_black(const num_length rgb[3])
{
    return rgb[0] == 0 && rgb[1] == 0 && rgb[2] == 0;
}

#define PATIENCE 16 /* number of surfaces between two calls of `stop` */

/* Filters the light by an object with an opacity texture. Returns false if the object transmits nothing. */
static bool layers_transmit(const struct ray_view *view, const struct ray *ray, uint32_t object, num_length limit,
                            struct filters *filters)
{
    struct filter filter = {object, 1, {NUM_LENGTH_ONE, NUM_LENGTH_ONE, NUM_LENGTH_ONE}};
    struct crossing crossing = {*ray, limit, 0, false, filters->opaque};
    struct hit hit;
    uint32_t met = 0;

    while (crossing.limit >= 0 && ray_meets(view, &crossing.ray, object, crossing.limit, &hit)) {
        cross(view, &crossing, &hit, filter.through);
        if (is_black(filter.through) || crossing.layers > TIA_LAYERS_MAX ||
            (++met % PATIENCE == 0 && view_stops(view->view))) {
            filters->blocker = object;
            return false;
        }
    }
    if (met)
        keep(filters, &filter);
    return true;
}

/* Filters the light by an object. Returns false if the object transmits nothing. */
static bool object_transmits(const struct ray_view *view, const struct ray *ray, uint32_t object, num_length limit,
                             struct filters *filters)
{
    const struct tia_material *materials = view->scene->materials;
    bool several = has_materials(view, object);
    struct filter filter = {.object = object};
    uint32_t element = 0;

    if (object < filters->from || object == filters->missed)
        return true;
    if (view->layered && ray_is_layered(view, object))
        return layers_transmit(view, ray, object, limit, filters);
    if (!ray_occluded_by(view, ray, object, limit, several ? &element : NULL))
        return true;
    const struct tia_rgb *transmission = &materials[ray_material(view, object, element)].transmission;
    if (filters->opaque || colour_is_black(transmission)) {
        filters->blocker = object;
        return false;
    }
    ray_rgb(transmission, filter.through);
    filter.times = ray_groups_met(view, ray, object, limit);
    keep(filters, &filter);
    return true;
}

static bool all_transmit(const struct ray_view *view, const struct ray *ray, num_length limit, struct filters *filters)
{
    struct candidates candidates;
    struct cancel cancel = view_cancel(view->view);
    uint32_t object;

    candidates_start(&candidates, view->scene, ray);
    while ((object = candidates_next(&candidates, limit)) != TIA_NO_OBJECT && !cancelled(&cancel, 1))
        if (!object_transmits(view, ray, object, limit, filters))
            return false;
    return true;
}

static void apply(const struct filters *filters, num_length through[3])
{
    for (uint32_t i = 0; i < filters->count; i++)
        for (uint32_t n = 0; n < filters->kept[i].times; n++)
            multiply(through, filters->kept[i].through);
}

static bool passes(const struct ray_view *view, const struct ray *ray, num_length limit, bool opaque, uint32_t *blocker,
                   num_length through[3])
{
    struct filters filters; /* not initialised, since it has many words */

    filters.count = filters.from = 0;
    filters.opaque = opaque;
    filters.missed = TIA_NO_OBJECT;
    if (*blocker != TIA_NO_OBJECT) {
        ray_tested(ray, 1);
        if (!object_transmits(view, ray, *blocker, limit, &filters))
            return false;
        filters.missed = filters.count ? TIA_NO_OBJECT : *blocker;
    }
    through[0] = through[1] = through[2] = NUM_LENGTH_ONE;
    do {
        filters.count = 0;
        filters.more = false;
        if (!all_transmit(view, ray, limit, &filters)) {
            *blocker = filters.blocker;
            return false;
        }
        apply(&filters, through);
        filters.from = filters.count ? filters.kept[filters.count - 1].object + 1 : 0;
    } while (filters.more && !view_stops(view->view));
    return through[0] > 0 || through[1] > 0 || through[2] > 0;
}

bool ray_transmittance(const struct ray_view *view, const struct ray *ray, num_length limit, uint32_t *blocker,
                       num_length through[3])
{
    return passes(view, ray, limit, false, blocker, through);
}

bool ray_visibility(const struct ray_view *view, const struct ray *ray, num_length limit, uint32_t *blocker,
                    num_length *through)
{
    num_length rgb[3];
    bool some = passes(view, ray, limit, true, blocker, rgb);

    *through = some ? rgb[0] : 0;
    return some;
}
