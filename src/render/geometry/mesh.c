/* mesh.c - faces over shared vertices; the element of an intersection is its face. */
#include "triangle.h"
#include "walk.h"

/* A search among faces: the nearest intersection so far is at nearest.t, or nothing nearer than that. */
struct search {
    const struct tia_mesh *mesh;
    struct triangle_ray ray;
    struct intersection nearest;
    bool any, found; /* any intersection ends the search */
};

static struct triangle_corners corners_of(const struct tia_mesh *mesh, uint32_t face)
{
    const struct tia_corner *corner = mesh->faces[face].corner;

    return (struct triangle_corners){
        {mesh->vertices[corner[0].vertex], mesh->vertices[corner[1].vertex], mesh->vertices[corner[2].vertex]}};
}

static void try_face(struct search *s, uint32_t face)
{
    struct triangle_corners corners = corners_of(s->mesh, face);
    num_length t;

    if (!triangle_intersect(&s->ray, &corners, s->nearest.t, &t))
        return;
    if (s->found && t == s->nearest.t && face > s->nearest.element)
        return;
    s->nearest = (struct intersection){t, face};
    s->found = true;
}

/* Faces items[i], or i, for i from `first` on. */
static void try_faces(struct search *s, const uint32_t *items, uint32_t first, uint32_t count)
{
    for (uint32_t i = first; i - first < count && !(s->any && s->found); i++)
        try_face(s, items ? items[i] : i);
}

static void try_tree(struct search *s, const struct tia_bvh_tree *tree, const struct ray *ray)
{
    struct walk walk;
    const struct tia_bvh_node *leaf;

    walk_start(&walk, tree, ray);
    while (!(s->any && s->found) && (leaf = walk_leaf(&walk, s->nearest.t)) != NULL)
        try_faces(s, tree->items, leaf->index, leaf->count);
}

static bool search(const struct prepared_mesh *prepared, const struct ray *ray, num_length limit, bool any,
                   struct intersection *intersection)
{
    struct search s = {.mesh = prepared->mesh, .nearest = {limit, 0}, .any = any};

    triangle_ray_prepare(&s.ray, ray);
    if (prepared->tree)
        try_tree(&s, prepared->tree, ray);
    else
        try_faces(&s, NULL, 0, prepared->mesh->face_count);
    *intersection = s.nearest;
    return s.found;
}

static bool intersect(const struct shape *shape, const struct ray *ray, num_length limit,
                      struct intersection *intersection)
{
    return search(&shape->mesh, ray, limit, false, intersection);
}

static bool occluded(const struct shape *shape, const struct ray *ray, num_length limit)
{
    struct intersection intersection;

    return search(&shape->mesh, ray, limit, true, &intersection);
}

/* The vertices' normals, each weighted with its part; the face's own where they cancel. */
static struct num_dir smooth_normal(const struct tia_mesh *mesh, const struct tia_corner corner[3],
                                    const num_unit parts[3], struct num_dir flat)
{
    struct num_dir sum = {0, 0, 0}, smooth;

    for (int i = 0; i < 3; i++)
        sum = num_dir_add(sum, num_dir_scaled(num_dir_of(mesh->normals[corner[i].normal]), parts[i]));
    return num_normalise3(sum.x / 2, sum.y / 2, sum.z / 2, &smooth.x, &smooth.y, &smooth.z) ? smooth : flat;
}

static void surface_at(const struct shape *shape, struct num_point point, uint32_t element, struct surface *surface)
{
    const struct tia_mesh *mesh = shape->mesh.mesh;
    const struct tia_corner *corner = mesh->faces[element].corner;
    struct triangle_corners corners = corners_of(mesh, element);
    num_unit parts[3];

    (void)triangle_normal(&corners, &surface->normal);
    surface->smooth = surface->normal;
    if (corner[0].normal == TIA_NO_INDEX)
        return;
    triangle_barycentric(&corners, surface->normal, point, parts);
    surface->smooth = smooth_normal(mesh, corner, parts, surface->normal);
}

static void uv_at(const struct shape *shape, struct num_point point, uint32_t element, num_length uv[2])
{
    const struct tia_mesh *mesh = shape->mesh.mesh;
    const struct tia_corner *corner = mesh->faces[element].corner;
    struct triangle_corners corners = corners_of(mesh, element);
    struct num_dir normal;
    num_unit parts[3];

    (void)triangle_normal(&corners, &normal);
    triangle_barycentric(&corners, normal, point, parts);
    uv[0] = num_length_of_unit(parts[1]);
    uv[1] = num_length_of_unit(parts[2]);
    if (corner[0].uv == TIA_NO_INDEX)
        return;
    const struct tia_uv *a = &mesh->uvs[corner[0].uv], *b = &mesh->uvs[corner[1].uv], *c = &mesh->uvs[corner[2].uv];
    uv[0] = num_dot3(num_length_of(a->u), num_length_of(b->u), num_length_of(c->u), parts[0], parts[1], parts[2]);
    uv[1] = num_dot3(num_length_of(a->v), num_length_of(b->v), num_length_of(c->v), parts[0], parts[1], parts[2]);
}

static void prepare(struct shape *shape, const struct tia_scene *scene, const struct tia_shape *given)
{
    shape->mesh.mesh = &scene->meshes[given->mesh];
    shape->mesh.tree = scene->bvh ? &scene->bvh->meshes[given->mesh] : NULL;
}

const struct shape_kind SHAPE_KIND(mesh) = {prepare, intersect, occluded, surface_at, uv_at};
