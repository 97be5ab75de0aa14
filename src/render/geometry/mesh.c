/* mesh.c - meshes: faces with shared vertices; an intersection's element is the face's index. */
#include "triangle.h"
#include "walk.h"

#define GROUPS 16

/* Numbers of groups that a ray meets, in ascending order: the lowest ones that are `from` or higher. `more`: there are
 * further ones. */
struct groups {
    uint32_t group[GROUPS], count, from;
    bool more;
};

/* A search among faces. nearest.t is at first the limit, then the t of the nearest intersection so far. */
struct search {
    const struct tia_mesh *mesh;
    const struct ray *given;
    struct triangle_ray ray;
    struct intersection nearest;
    bool any, found;       /* any: the first intersection ends the search */
    struct groups *groups; /* NULL, or receives the groups of all intersections */
};

static struct triangle_corners corners_of(const struct tia_mesh *mesh, uint32_t face)
{
    const struct tia_corner *corner = mesh->faces[face].corner;

    return (struct triangle_corners){
        {mesh->vertices[corner[0].vertex], mesh->vertices[corner[1].vertex], mesh->vertices[corner[2].vertex]}};
}

static void keep_group(struct groups *g, uint32_t group)
{
    uint32_t place = g->count;

    if (group < g->from)
        return;
    while (place > 0 && g->group[place - 1] > group)
        place--;
    if (place > 0 && g->group[place - 1] == group)
        return;
    g->more = g->more || g->count == GROUPS;
    if (place == GROUPS)
        return;
    g->count += g->count < GROUPS;
    for (uint32_t i = g->count - 1; i > place; i--)
        g->group[i] = g->group[i - 1];
    g->group[place] = group;
}

static void try_face(struct search *s, uint32_t face)
{
    struct triangle_corners corners = corners_of(s->mesh, face);
    num_length t;

    ray_tested(s->given, 1);
    if (!triangle_intersect(&s->ray, &corners, s->nearest.t, &t))
        return;
    if (s->groups) {
        keep_group(s->groups, s->mesh->groups[face]);
        return;
    }
    if (s->found && t == s->nearest.t && face > s->nearest.element)
        return;
    s->nearest = (struct intersection){t, face};
    s->found = true;
}

/* Tests `count` faces, from i = `first` on: items[i] or, if `items` is NULL, face i. */
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

static void search(struct search *s, const struct prepared_mesh *prepared, const struct ray *ray)
{
    s->mesh = prepared->mesh;
    s->given = ray;
    triangle_ray_prepare(&s->ray, ray);
    if (prepared->tree && prepared->tree->node_count == 1) /* a single leaf, whose box is the object's */
        try_faces(s, prepared->tree->items, 0, prepared->tree->item_count);
    else if (prepared->tree)
        try_tree(s, prepared->tree, ray);
    else
        try_faces(s, NULL, 0, prepared->mesh->face_count);
}

static bool intersect(const struct shape *shape, const struct ray *ray, num_length limit,
                      struct intersection *intersection)
{
    struct search s = {.nearest = {limit, 0}};

    search(&s, &shape->mesh, ray);
    *intersection = s.nearest;
    return s.found;
}

static bool occluded(const struct shape *shape, const struct ray *ray, num_length limit)
{
    struct search s = {.nearest = {limit, 0}, .any = true};

    search(&s, &shape->mesh, ray);
    return s.found;
}

uint32_t mesh_groups_met(const struct shape *shape, const struct ray *ray, num_length limit)
{
    struct groups groups = {.more = true};
    struct search s = {.nearest = {limit, 0}, .groups = &groups};
    uint32_t met = 0;

    while (groups.more) {
        groups.from = groups.count ? groups.group[GROUPS - 1] + 1 : 0;
        groups.count = 0;
        groups.more = false;
        search(&s, &shape->mesh, ray);
        met += groups.count;
    }
    return met;
}

/* Returns a hash of the edge from a to b, which differs from that of the edge from b to a. */
static uint64_t edge_number(const struct tia_vec3 *a, const struct tia_vec3 *b)
{
    const tia_q16 words[6] = {a->x, a->y, a->z, b->x, b->y, b->z};
    uint64_t n = UINT64_C(0x9e3779b97f4a7c15);

    for (int i = 0; i < 6; i++) {
        n = (n ^ (uint32_t)words[i]) * UINT64_C(0xbf58476d1ce4e5b9);
        n ^= n >> 32;
    }
    return n;
}

/* True if the mesh is closed. If every edge has an opposite one, the hashes of edges minus those of their opposites add
 * up to 0; otherwise the sum is 0 with a probability of 2^-64. */
bool mesh_is_closed(const struct tia_mesh *mesh, struct cancel *cancel)
{
    uint64_t sum = 0;

    for (uint32_t i = 0; i < mesh->face_count && !cancelled(cancel, 1); i++) {
        struct triangle_corners corners = corners_of(mesh, i);
        for (int k = 0; k < 3; k++) {
            const struct tia_vec3 *a = &corners.at[k], *b = &corners.at[(k + 1) % 3];
            sum += edge_number(a, b) - edge_number(b, a);
        }
    }
    return sum == 0;
}

/* Returns the mean of the vertices' normals, weighted by the barycentric coordinates. If they cancel, returns `flat`,
 * the face's own normal. */
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

/* Returns the part p of the difference from a to b, within +-2^15. */
static num_length part_of(tia_q16 a, tia_q16 b, num_length p)
{
    const num_length d = num_length_of(b) - num_length_of(a);
    const num_length most = num_ratio(NUM_LENGTH_FAR / 2, (d < 0 ? -d : d) + NUM_LENGTH_ONE);

    return num_product(d, num_length_clamp(p, -most, most));
}

void mesh_uv_change(const struct shape *shape, uint32_t element, struct num_point vector, num_length uv[2])
{
    const struct tia_mesh *mesh = shape->mesh.mesh;
    const struct tia_corner *corner = mesh->faces[element].corner;
    struct triangle_corners corners = corners_of(mesh, element);
    struct num_dir normal;
    num_length parts[2];

    (void)triangle_normal(&corners, &normal);
    triangle_change(&corners, normal, vector, parts);
    uv[0] = parts[0];
    uv[1] = parts[1];
    if (corner[0].uv == TIA_NO_INDEX)
        return;
    const struct tia_uv *a = &mesh->uvs[corner[0].uv], *b = &mesh->uvs[corner[1].uv], *c = &mesh->uvs[corner[2].uv];
    uv[0] = part_of(a->u, b->u, parts[0]) + part_of(a->u, c->u, parts[1]);
    uv[1] = part_of(a->v, b->v, parts[0]) + part_of(a->v, c->v, parts[1]);
}

static void prepare(struct shape *shape, const struct tia_scene *scene, const struct tia_shape *given)
{
    shape->mesh.mesh = &scene->meshes[given->mesh];
    shape->mesh.tree = scene->bvh ? &scene->bvh->meshes[given->mesh] : NULL;
}

const struct shape_kind SHAPE_KIND(mesh) = {prepare, intersect, occluded, surface_at, uv_at, NULL};
