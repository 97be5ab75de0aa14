/* footprint.c - the parts of surfaces that rays stand for.
 *
 * The neighbour of the ray O + t D starts at O' in the direction D'. With v = O' + t D' - P, linearised, it meets the
 * tangent plane at P, whose normal is N, at P + v - D (v.N)/(D.N). Towards the horizon D.N goes to 0 and the footprint
 * grows without limit. So v and the quotient are cut to 2^15, and positions stay below P + 2^16. */
#include "footprint.h"

#include "filter.h"
#include "render/trace/texture.h"
#include "scene/colour.h"

/* Returns the change of the hit's point from a ray to its neighbour. */
static struct num_point moved(const struct ray *ray, const struct ray *next, num_length t, const struct shading *s)
{
    struct num_point v = footprint_cut(num_point_sub(num_point_at(next->origin, next->direction, t), s->point));
    num_length dt = num_div(num_point_dot(v, s->geometric), num_dir_dot(ray->direction, s->geometric));

    return num_point_sub(v, num_point_along(ray->direction, num_length_clamp(dt, -FOOTPRINT_REACH, FOOTPRINT_REACH)));
}

/* Sets the edges of a camera ray's footprint. */
static void from_neighbours(const struct path *path, const struct ray *ray, const struct hit *hit,
                            const struct shading *s, struct num_point edge[2])
{
    for (int i = 0; i < 2; i++) {
        struct ray next;
        ray_camera_next(&path->view->camera, path->pixel, path->sample, i, &next);
        edge[i] = moved(ray, &next, hit->t, s);
    }
}

/* Sets the edges of the section of a cone by the tangent plane: along the ray's projection, and across it. */
static void from_cone(const struct cone *cone, const struct ray *ray, const struct hit *hit, const struct shading *s,
                      struct num_point edge[2])
{
    const num_length width = footprint_cone_at(cone, hit->t).width;
    const num_unit cosine = num_dir_dot(s->viewer, s->geometric);
    struct num_dir axes[2];

    shape_axes(s->geometric, axes);
    if (cosine < NUM_UNIT_ONE - NUM_UNIT_ONE / 65536) {
        axes[0] = num_dir_normalised(num_dir_add(ray->direction, num_dir_scaled(s->geometric, cosine)));
        axes[1] = num_dir_cross(s->geometric, axes[0]);
    }
    num_length longer = cosine > NUM_UNIT_LEAST ? num_div(width, cosine) : FOOTPRINT_REACH;
    edge[0] = num_point_along(axes[0], num_length_clamp(longer, 0, FOOTPRINT_REACH));
    edge[1] = num_point_along(axes[1], width);
}

static const struct tia_texture *filtered(const struct ray_view *view, uint32_t number)
{
    const struct tia_texture *t = number ? &view->scene->textures[number - 1] : NULL;

    return t && t->footprint ? t : NULL;
}

void footprint_filter(const struct path *path, const struct ray *ray, const struct hit *hit, struct shading *s)
{
    const struct ray_view *view = path->view;
    const struct tia_material *m = s->material;
    const struct tia_texture *colour = colour_is_black(&m->colour) ? NULL : filtered(view, m->texture);
    const struct tia_texture *opacity = filtered(view, m->opacity);
    struct num_point edge[2];
    num_length value[3];

    if (!colour && !opacity)
        return;
    if (path->pixel)
        from_neighbours(path, ray, hit, s, edge);
    else
        from_cone(&path->cone, ray, hit, s, edge);
    if (colour && filter_texture(view, hit, s->point, colour, edge, value)) {
        ray_rgb(&m->colour, s->colour);
        for (int c = 0; c < 3; c++)
            s->colour[c] = num_product(s->colour[c], value[c]);
        s->textured[0] = false;
    }
    if (opacity && filter_texture(view, hit, s->point, opacity, edge, value)) {
        s->opacity = value[0];
        s->textured[1] = false;
    }
}
