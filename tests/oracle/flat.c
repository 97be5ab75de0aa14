/* flat.c - boxes, triangles, meshes and grids. */
#include "shape.h"

static double coordinate(struct oracle_vec v, int axis)
{
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

/* Returns the unit vector of an axis, times sign. */
static struct oracle_vec axis_vec(int axis, double sign)
{
    return (struct oracle_vec){axis == 0 ? sign : 0, axis == 1 ? sign : 0, axis == 2 ? sign : 0};
}

/* Returns the position of a point along a tangent of its face, 0..1 from edge to edge. */
static double share(const double part[3], struct oracle_vec tangent)
{
    double sum = 0;

    for (int i = 0; i < 3; i++) {
        double along = coordinate(tangent, i);
        sum += along > 0 ? along * part[i] : along < 0 ? -along * (1 - part[i]) : 0;
    }
    return sum;
}

/* Computes the hit on that face of a box whose outward normal is `sign` times the axis. Returns false if the ray does
 * not meet the face. */
static bool face_hit(struct ray ray, struct oracle_vec min, struct oracle_vec max, int axis, double sign,
                     struct hit *hit)
{
    double d = coordinate(ray.direction, axis), where = coordinate(sign > 0 ? max : min, axis);
    double t = (where - coordinate(ray.origin, axis)) / d;

    if (d == 0 || !(t >= 0))
        return false;
    struct oracle_vec p = at(ray, t);
    double part[3];
    for (int i = 0; i < 3; i++) {
        part[i] = (coordinate(p, i) - coordinate(min, i)) / (coordinate(max, i) - coordinate(min, i));
        if (i != axis && (part[i] < 0 || part[i] > 1))
            return false;
    }
    struct oracle_vec n = axis_vec(axis, sign), right, up;
    tangents(n, &right, &up);
    *hit = (struct hit){.t = t, .normal = n, .smooth = n};
    hit->part = 2u * (unsigned)axis + (sign > 0);
    hit->u = share(part, right);
    hit->v = share(part, up);
    return true;
}

bool shape_box(struct ray ray, struct oracle_vec min, struct oracle_vec max, struct hit *hit)
{
    struct hit face;
    bool met = false;

    for (int i = 0; i < 6; i++)
        if (face_hit(ray, min, max, i / 2, i % 2 ? 1 : -1, &face) && (!met || face.t < hit->t)) {
            *hit = face;
            met = true;
        }
    return met;
}

bool shape_triangle(struct ray ray, const struct oracle_vec corner[3], struct hit *hit)
{
    struct oracle_vec e1 = sub(corner[1], corner[0]), e2 = sub(corner[2], corner[0]), n = cross(e1, e2);
    double square = dot(n, n), t = dot(sub(corner[0], ray.origin), n) / dot(ray.direction, n);

    if (!(square > 0) || !(t >= 0) || isinf(t))
        return false;
    struct oracle_vec p = sub(at(ray, t), corner[0]);
    double u = dot(cross(p, e2), n) / square, v = dot(cross(e1, p), n) / square;
    if (u < 0 || v < 0 || u + v > 1)
        return false;
    n = unit(n);
    *hit = (struct hit){.t = t, .normal = n, .smooth = n, .u = u, .v = v};
    return true;
}

static void interpolate(const struct tia_mesh *mesh, const struct tia_corner corner[3], struct hit *hit)
{
    double weight[3] = {1 - hit->u - hit->v, hit->u, hit->v};
    struct oracle_vec n = {0, 0, 0};
    double u = 0, v = 0;

    for (int i = 0; i < 3; i++) {
        if (corner[i].normal != TIA_NO_INDEX)
            n = along(n, weight[i], direction(mesh->normals[corner[i].normal]));
        if (corner[i].uv != TIA_NO_INDEX) {
            u += weight[i] * q16(mesh->uvs[corner[i].uv].u);
            v += weight[i] * q16(mesh->uvs[corner[i].uv].v);
        }
    }
    if (length(n) > 0)
        hit->smooth = unit(n);
    if (corner[0].uv != TIA_NO_INDEX) {
        hit->u = u;
        hit->v = v;
    }
}

bool shape_mesh(struct ray ray, const struct tia_mesh *mesh, struct hit *hit)
{
    struct hit face;
    bool met = false;

    for (uint32_t i = 0; i < mesh->face_count; i++) {
        const struct tia_corner *c = mesh->faces[i].corner;
        struct oracle_vec corner[3];
        for (int k = 0; k < 3; k++)
            corner[k] = position(mesh->vertices[c[k].vertex]);
        if (!shape_triangle(ray, corner, &face) || (met && face.t >= hit->t))
            continue;
        met = true;
        interpolate(mesh, c, &face);
        face.part = i;
        *hit = face;
    }
    return met;
}

/* True if the ray meets the face before t. */
static bool meets_before(struct ray ray, const struct tia_mesh *mesh, uint32_t face, double t)
{
    struct oracle_vec corner[3];
    struct hit hit;

    for (int k = 0; k < 3; k++)
        corner[k] = position(mesh->vertices[mesh->faces[face].corner[k].vertex]);
    return shape_triangle(ray, corner, &hit) && hit.t < t;
}

unsigned shape_mesh_groups(struct ray ray, const struct tia_mesh *mesh, double t)
{
    unsigned count = 0;

    for (uint32_t i = 0; i < mesh->face_count; i++) {
        bool counts = meets_before(ray, mesh, i, t);
        for (uint32_t k = 0; k < i && counts; k++)
            counts = mesh->groups[k] != mesh->groups[i] || !meets_before(ray, mesh, k, t);
        count += counts;
    }
    return count;
}

static size_t cell_index(const struct tia_grid *grid, const int at[3])
{
    return ((size_t)at[2] * grid->size[1] + (size_t)at[1]) * grid->size[0] + (size_t)at[0];
}

/* Returns the contents of cell (x, y, z); 0 if it is empty or outside. */
static unsigned cell(const struct tia_grid *grid, const int at[3])
{
    for (int i = 0; i < 3; i++)
        if (at[i] < 0 || at[i] >= grid->size[i])
            return 0;
    return grid->cells[cell_index(grid, at)];
}

/* Computes the nearest hit on the faces of a filled cell. A face is met on its front if the neighbouring cell differs,
 * and on its back only if that cell is empty. */
static bool cell_hit(struct ray ray, const struct tia_grid *grid, const int at[3], struct hit *hit)
{
    struct oracle_vec corner = position(grid->corner);
    double edge = q16(grid->cell);
    struct oracle_vec min = {corner.x + at[0] * edge, corner.y + at[1] * edge, corner.z + at[2] * edge};
    struct oracle_vec max = {corner.x + (at[0] + 1) * edge, corner.y + (at[1] + 1) * edge,
                             corner.z + (at[2] + 1) * edge};
    struct hit face;
    bool met = false;

    for (int i = 0; i < 6; i++) {
        int beyond[3] = {at[0], at[1], at[2]}, axis = i / 2, step = i % 2 ? 1 : -1;
        beyond[axis] += step;
        unsigned inside = cell(grid, at), outside = cell(grid, beyond);
        bool front = coordinate(ray.direction, axis) * step < 0;
        if (outside == inside || (!front && outside != 0) || !face_hit(ray, min, max, axis, step, &face))
            continue;
        if (!met || face.t < hit->t)
            *hit = face;
        met = true;
    }
    return met;
}

bool shape_grid(struct ray ray, const struct tia_grid *grid, struct hit *hit)
{
    struct hit found;
    bool met = false;
    int at[3];

    for (at[2] = 0; at[2] < grid->size[2]; at[2]++)
        for (at[1] = 0; at[1] < grid->size[1]; at[1]++)
            for (at[0] = 0; at[0] < grid->size[0]; at[0]++) {
                unsigned filled = cell(grid, at);
                if (filled == 0 || !cell_hit(ray, grid, at, &found) || (met && found.t >= hit->t))
                    continue;
                met = true;
                *hit = found;
                hit->material = filled - 1;
                hit->part += 6 * (uint32_t)cell_index(grid, at);
            }
    return met;
}
