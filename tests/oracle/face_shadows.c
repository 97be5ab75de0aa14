#include "face_shadows.h"

#include "light.h"

/* ---- the faces ---- */

static const struct tia_transform none = {.scale = TIA_VEC3(1, 1, 1)};

static struct oracle_vec placed(const struct tia_scene *scene, const struct tia_shape *s, struct oracle_vec v)
{
    return transform_point(s->transform ? &scene->transforms[s->transform - 1] : &none, v);
}

static struct oracle_face triangle(const struct tia_scene *scene, const struct tia_shape *s, struct oracle_vec a,
                                   struct oracle_vec b, struct oracle_vec c)
{
    struct oracle_face face = {.at = placed(scene, s, a), .object = (uint32_t)(s - scene->shapes)};

    face.edge[0] = sub(placed(scene, s, b), face.at);
    face.edge[1] = sub(placed(scene, s, c), face.at);
    return face;
}

static double *axis_of(struct oracle_vec *v, int axis)
{
    return axis == 0 ? &v->x : axis == 1 ? &v->y : &v->z;
}

/* Writes the two triangles of a box's side at its lowest or highest coordinate along an axis. */
static void add_side(const struct tia_scene *scene, const struct tia_shape *s, int axis, bool high,
                     struct oracle_face *faces)
{
    struct oracle_vec low = position(s->box.min), most = position(s->box.max), corner[4];

    for (int i = 0; i < 4; i++) {
        int u = (axis + 1) % 3, v = (axis + 2) % 3;
        corner[i] = low;
        *axis_of(&corner[i], axis) = high ? *axis_of(&most, axis) : *axis_of(&low, axis);
        *axis_of(&corner[i], u) = i == 1 || i == 2 ? *axis_of(&most, u) : *axis_of(&low, u);
        *axis_of(&corner[i], v) = i >= 2 ? *axis_of(&most, v) : *axis_of(&low, v);
    }
    faces[0] = triangle(scene, s, corner[0], corner[1], corner[2]);
    faces[1] = triangle(scene, s, corner[0], corner[2], corner[3]);
}

static uint32_t add_mesh(const struct tia_scene *scene, const struct tia_shape *s, struct oracle_face *faces)
{
    const struct tia_mesh *mesh = &scene->meshes[s->mesh];

    for (uint32_t i = 0; faces && i < mesh->face_count; i++) {
        const struct tia_corner *c = mesh->faces[i].corner;
        faces[i] = triangle(scene, s, position(mesh->vertices[c[0].vertex]), position(mesh->vertices[c[1].vertex]),
                            position(mesh->vertices[c[2].vertex]));
    }
    return mesh->face_count;
}

static uint32_t add(const struct tia_scene *scene, const struct tia_shape *s, struct oracle_face *faces)
{
    const struct tia_vec3 *c = s->triangle.corner;

    if (s->kind == TIA_MESH)
        return add_mesh(scene, s, faces);
    if (s->kind == TIA_BOX) {
        for (int i = 0; faces && i < 6; i++)
            add_side(scene, s, i / 2, i % 2, faces + (ptrdiff_t)2 * i);
        return 12;
    }
    if (faces && s->kind == TIA_TRIANGLE)
        faces[0] = triangle(scene, s, position(c[0]), position(c[1]), position(c[2]));
    if (faces && s->kind == TIA_PLANE)
        faces[0] = (struct oracle_face){
            true, position(s->plane.point), {direction(s->plane.normal)}, (uint32_t)(s - scene->shapes)};
    return 1;
}

uint32_t oracle_faces(const struct tia_scene *scene, struct oracle_face *faces)
{
    uint32_t count = 0;

    for (uint32_t i = 0; i < scene->shape_count; i++)
        count += add(scene, &scene->shapes[i], faces ? faces + count : NULL);
    return count;
}

/* ---- rays ---- */

/* Computes the intersection of the ray's line with the face. *t is a multiple of the direction, which may have any
 * length. Returns false if there is none. */
static bool meets(const struct oracle_face *f, struct ray ray, double *t)
{
    struct oracle_vec from = sub(ray.origin, f->at);

    if (f->plane) {
        *t = -dot(from, f->edge[0]) / dot(ray.direction, f->edge[0]);
        return isfinite(*t);
    }
    struct oracle_vec p = cross(ray.direction, f->edge[1]), q = cross(from, f->edge[0]);
    double det = dot(p, f->edge[0]), u = dot(from, p) / det, v = dot(ray.direction, q) / det;
    *t = dot(f->edge[1], q) / det;
    return det != 0 && u >= 0 && v >= 0 && u + v <= 1;
}

uint32_t oracle_face_seen(const struct oracle_face *faces, uint32_t count, struct ray ray, double *t)
{
    uint32_t seen = ORACLE_NO_FACE;
    double here;

    *t = INFINITY;
    for (uint32_t i = 0; i < count; i++)
        if (meets(&faces[i], ray, &here) && here > 0 && here < *t) {
            *t = here;
            seen = i;
        }
    return seen;
}

/* Returns the vector from the point to sample i of the light; for a directional light, its direction reversed. */
static struct oracle_vec way_to(const struct tia_light *light, unsigned i, struct oracle_vec p)
{
    struct oracle_vec source = position(light->centre);
    double u, v;

    if (light->kind == TIA_DIRECTIONAL_LIGHT)
        return scaled(direction(light->direction), -1);
    if (light->kind == TIA_RECTANGLE_LIGHT) {
        light_pattern(0, i, light_samples(light), &u, &v);
        source = along(source, 2 * u - 1, position(light->side[0]));
        source = along(source, 2 * v - 1, position(light->side[1]));
    }
    return sub(source, p);
}

bool oracle_face_lit(const struct oracle_face *faces, uint32_t count, uint32_t face, struct ray eye, double t,
                     const struct tia_light *light, unsigned i)
{
    const struct oracle_face *f = &faces[face];
    struct oracle_vec normal = f->plane ? f->edge[0] : cross(f->edge[0], f->edge[1]);
    struct ray ray = {at(eye, t), way_to(light, i, at(eye, t))};
    double end = light->kind == TIA_DIRECTIONAL_LIGHT ? INFINITY : 1, here;

    if (dot(normal, eye.direction) * dot(normal, ray.direction) >= 0)
        return false;
    for (uint32_t k = 0; k < count; k++)
        if (k != face && meets(&faces[k], ray, &here) && here > 0 && here < end)
            return false;
    return true;
}
