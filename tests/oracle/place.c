/* place.c - a scene's objects, placed by their transforms. */
#include "shape.h"

#define FAR 65536.0

/* Rotates about one axis, right-handed: a turns towards b. */
static void rotate(double *a, double *b, double angle)
{
    double c = cos(angle), s = sin(angle), x = *a;

    *a = c * x - s * *b;
    *b = s * x + c * *b;
}

struct oracle_vec transform_turn(const struct tia_transform *transform, struct oracle_vec v)
{
    rotate(&v.y, &v.z, radians(transform->rotation.x));
    rotate(&v.z, &v.x, radians(transform->rotation.y));
    rotate(&v.x, &v.y, radians(transform->rotation.z));
    return v;
}

struct oracle_vec transform_turn_back(const struct tia_transform *transform, struct oracle_vec v)
{
    rotate(&v.x, &v.y, -radians(transform->rotation.z));
    rotate(&v.z, &v.x, -radians(transform->rotation.y));
    rotate(&v.y, &v.z, -radians(transform->rotation.x));
    return v;
}

static struct oracle_vec multiplied(struct oracle_vec a, struct oracle_vec b)
{
    return (struct oracle_vec){a.x * b.x, a.y * b.y, a.z * b.z};
}

static struct oracle_vec quotient(struct oracle_vec a, struct oracle_vec b)
{
    return (struct oracle_vec){a.x / b.x, a.y / b.y, a.z / b.z};
}

struct oracle_vec transform_point(const struct tia_transform *transform, struct oracle_vec v)
{
    struct oracle_vec turned = transform_turn(transform, multiplied(v, position(transform->scale)));

    return along(turned, 1, position(transform->position));
}

static bool tapered_hit(struct ray ray, const struct tia_vec3 *base, const struct tia_vec3 *top, tia_q16 base_radius,
                        tia_q16 top_radius, const struct tia_fine_ends *fine, bool capped, struct hit *hit)
{
    double more = fine ? ldexp(fine->base_radius, -32) : 0, other = fine ? ldexp(fine->top_radius, -32) : 0;

    return shape_cone(ray, finely(*base, fine ? &fine->base : NULL), finely(*top, fine ? &fine->top : NULL),
                      q16(base_radius) + more, q16(top_radius) + (base_radius == top_radius ? more : other), capped,
                      hit);
}

/* False for a member of a solid. */
static bool is_of_scene(const struct tia_scene *scene, const struct tia_shape *s)
{
    bool found = false;

    for (uint32_t i = 0; i < scene->shape_count; i++)
        found = found || s == &scene->shapes[i];
    return found;
}

static bool local_hit(const struct tia_scene *scene, const struct tia_shape *s, struct ray ray, struct hit *hit)
{
    const struct tia_fine_ends *fine =
        scene->fine && s->transform == 0 && is_of_scene(scene, s) ? &scene->fine->shapes[s - scene->shapes] : NULL;
    struct oracle_vec corner[3];

    switch (s->kind) {
    case TIA_SPHERE:
        return shape_sphere(ray, position(s->sphere.centre), q16(s->sphere.radius), hit);
    case TIA_PLANE:
        return shape_plane(ray, position(s->plane.point), direction(s->plane.normal), hit);
    case TIA_DISC:
        return shape_disc(ray, position(s->disc.centre), direction(s->disc.normal), q16(s->disc.radius), hit);
    case TIA_CYLINDER:
        return tapered_hit(ray, &s->cylinder.base, &s->cylinder.top, s->cylinder.radius, s->cylinder.radius, fine,
                           s->cylinder.capped, hit);
    case TIA_CONE:
        return tapered_hit(ray, &s->cone.base, &s->cone.top, s->cone.base_radius, s->cone.top_radius, fine,
                           s->cone.capped, hit);
    case TIA_BOX:
        return shape_box(ray, position(s->box.min), position(s->box.max), hit);
    case TIA_TORUS:
        return shape_torus(ray, position(s->torus.centre), direction(s->torus.axis), q16(s->torus.major),
                           q16(s->torus.minor), hit);
    case TIA_ROUNDED:
        return shape_rounded(ray, position(s->rounded.min), position(s->rounded.max), q16(s->rounded.radius), hit);
    case TIA_TRIANGLE:
        for (int i = 0; i < 3; i++)
            corner[i] = position(s->triangle.corner[i]);
        return shape_triangle(ray, corner, hit);
    case TIA_MESH:
        return shape_mesh(ray, &scene->meshes[s->mesh], hit);
    case TIA_SOLID:
        return shape_solid(scene, &scene->solids[s->solid], ray, hit);
    default:
        return shape_grid(ray, &scene->grids[s->grid], hit);
    }
}

/* Returns the ray in the axes of a shape before its transform; the parameter t of a point stays the same. */
static struct ray local_ray(const struct tia_transform *t, struct ray ray)
{
    struct oracle_vec scale = position(t->scale), from = sub(ray.origin, position(t->position));

    return (struct ray){quotient(transform_turn_back(t, from), scale),
                        quotient(transform_turn_back(t, ray.direction), scale)};
}

static struct oracle_vec own_point(const struct tia_shape *s, struct ray local, double t)
{
    struct oracle_vec p = at(local, t);

    return s->kind == TIA_SPHERE ? sub(p, position(s->sphere.centre)) : p;
}

bool shape_hit(const struct tia_scene *scene, const struct tia_shape *shape, struct ray ray, struct hit *hit)
{
    if (shape->transform == 0) {
        bool met = local_hit(scene, shape, ray, hit);
        hit->own = own_point(shape, ray, met ? hit->t : 0);
        return met;
    }
    const struct tia_transform *t = &scene->transforms[shape->transform - 1];
    struct oracle_vec scale = position(t->scale);
    const struct ray local = local_ray(t, ray);
    if (!local_hit(scene, shape, local, hit))
        return false;
    hit->own = own_point(shape, local, hit->t);
    /* normals are transformed by the inverse's transpose */
    hit->normal = unit(transform_turn(t, quotient(hit->normal, scale)));
    hit->smooth = unit(transform_turn(t, quotient(hit->smooth, scale)));
    return true;
}

bool object_hit(const struct tia_scene *scene, uint32_t index, struct ray ray, struct hit *hit)
{
    if (index < scene->sphere_count) {
        const struct tia_sphere *s = &scene->spheres[index];
        const struct tia_fine_sphere *fine = scene->fine ? &scene->fine->spheres[index] : NULL;
        if (!shape_sphere(ray, finely(s->centre, fine ? &fine->centre : NULL),
                          q16(s->radius) + (fine ? ldexp(fine->radius, -32) : 0), hit))
            return false;
        hit->material = s->material;
        hit->own = sub(at(ray, hit->t), finely(s->centre, fine ? &fine->centre : NULL));
    } else {
        const struct tia_shape *s = &scene->shapes[index - scene->sphere_count];
        if (!shape_hit(scene, s, ray, hit))
            return false;
        hit->material += s->kind == TIA_SOLID ? 0 : s->material;
        if (s->kind == TIA_PLANE) {
            hit->u = ldexp(hit->u, -(int)scene->scale_bits);
            hit->v = ldexp(hit->v, -(int)scene->scale_bits);
        }
    }
    hit->own = scaled(hit->own, ldexp(1, -(int)scene->scale_bits));
    struct oracle_vec p = at(ray, hit->t);
    return fabs(p.x) < FAR && fabs(p.y) < FAR && fabs(p.z) < FAR;
}

unsigned groups_hit(const struct tia_scene *scene, uint32_t index, struct ray ray, double distance)
{
    const struct tia_shape *s = index < scene->sphere_count ? NULL : &scene->shapes[index - scene->sphere_count];

    if (!s || s->kind != TIA_MESH || !scene->meshes[s->mesh].groups)
        return 1;
    if (s->transform != 0)
        ray = local_ray(&scene->transforms[s->transform - 1], ray);
    return shape_mesh_groups(ray, &scene->meshes[s->mesh], distance);
}
