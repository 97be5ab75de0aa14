#include "float_world.h"

#include <stdlib.h>

enum { LEAF = 4, DEPTH = 128 };

static struct vec least(struct vec a, struct vec b)
{
    return (struct vec){fminf(a.x, b.x), fminf(a.y, b.y), fminf(a.z, b.z)};
}

static struct vec most(struct vec a, struct vec b)
{
    return (struct vec){fmaxf(a.x, b.x), fmaxf(a.y, b.y), fmaxf(a.z, b.z)};
}

static void enclose(struct float_node *node, const struct float_item *item)
{
    struct vec r = {item->radius, item->radius, item->radius}, a = item->corner;
    struct vec b = vec_along(a, 1, item->side[0]), c = vec_along(a, 1, item->side[1]);

    node->low = least(node->low, least(vec_sub(a, r), least(b, c)));
    node->high = most(node->high, most(vec_along(a, 1, r), most(b, c)));
}

static float middle(const struct float_item *item, int axis)
{
    struct vec c = vec_along(vec_along(item->corner, 1.0F / 3, item->side[0]), 1.0F / 3, item->side[1]);

    return axis == 0 ? c.x : axis == 1 ? c.y : c.z;
}

#define BY_AXIS(name, axis)                                                                                            \
    static int name(const void *a, const void *b)                                                                      \
    {                                                                                                                  \
        float x = middle(a, axis), y = middle(b, axis);                                                                \
        return (x > y) - (x < y);                                                                                      \
    }
BY_AXIS(by_x, 0)
BY_AXIS(by_y, 1)
BY_AXIS(by_z, 2)

static const struct float_node nothing = {{1e30F, 1e30F, 1e30F}, {-1e30F, -1e30F, -1e30F}, 0, 0, 0};

static float half_area(const struct float_node *n)
{
    struct vec size = vec_sub(n->high, n->low);

    return size.x * size.y + size.y * size.z + size.z * size.x;
}

static int (*const orders[3])(const void *, const void *) = {by_x, by_y, by_z};

/* Finds the best cut of the items, sorted along `axis`, by the surface-area heuristic; returns its cost. `areas` is
 * memory for `count` areas. */
static float best_cut(struct float_item *items, uint32_t count, int axis, float *areas, uint32_t *cut)
{
    struct float_node grown = nothing;
    float least_cost = 1e30F;

    qsort(items, count, sizeof *items, orders[axis]);
    for (uint32_t i = count; i-- > 1;) {
        enclose(&grown, &items[i]);
        areas[i] = half_area(&grown) * (float)(count - i);
    }
    grown = nothing;
    for (uint32_t i = 1; i < count; i++) {
        enclose(&grown, &items[i - 1]);
        float cost = areas[i] + half_area(&grown) * (float)i;
        if (cost < least_cost) {
            least_cost = cost;
            *cut = i;
        }
    }
    return least_cost;
}

static void split(struct float_world *world, uint32_t at, uint32_t first, uint32_t count, float *areas)
{
    struct float_node *node = &world->nodes[at];
    uint32_t cut = 0, cuts[3];
    float costs[3];

    *node = nothing;
    node->first = first;
    node->count = count;
    for (uint32_t i = first; i < first + count; i++)
        enclose(node, &world->items[i]);
    if (count <= LEAF)
        return;
    for (int axis = 0; axis < 3; axis++)
        costs[axis] = best_cut(&world->items[first], count, axis, areas, &cuts[axis]);
    node->axis = costs[0] < costs[1] ? (costs[0] < costs[2] ? 0 : 2) : (costs[1] < costs[2] ? 1 : 2);
    cut = cuts[node->axis];
    qsort(&world->items[first], count, sizeof *world->items, orders[node->axis]);
    node->first = world->node_count;
    node->count = 0;
    world->node_count += 2;
    split(world, node->first, first, cut, areas);
    split(world, node->first + 1, first + cut, count - cut, areas);
}

static void add_mesh(struct float_world *world, const struct tia_mesh *mesh, uint32_t material)
{
    for (uint32_t i = 0; i < mesh->face_count; i++) {
        struct vec p[3];
        for (int k = 0; k < 3; k++)
            p[k] = float_place(mesh->vertices[mesh->faces[i].corner[k].vertex]);
        world->items[world->count++] =
            (struct float_item){p[0], {vec_sub(p[1], p[0]), vec_sub(p[2], p[0])}, 0, material};
    }
}

static size_t count_items(const struct tia_scene *scene)
{
    size_t count = scene->sphere_count;

    for (uint32_t i = 0; i < scene->shape_count; i++) {
        if (scene->shapes[i].kind != TIA_MESH || scene->shapes[i].transform)
            return 0;
        count += scene->meshes[scene->shapes[i].mesh].face_count;
    }
    return count;
}

bool float_world_build(struct float_world *world, const struct tia_scene *scene)
{
    size_t count = count_items(scene);

    *world = (struct float_world){.items = malloc((count + 1) * sizeof *world->items),
                                  .nodes = malloc((2 * count + 1) * sizeof *world->nodes)};
    if (!count || !world->items || !world->nodes)
        return false;
    for (uint32_t i = 0; i < scene->sphere_count; i++)
        world->items[world->count++] = (struct float_item){.corner = float_place(scene->spheres[i].centre),
                                                           .radius = (float)scene->spheres[i].radius / 65536,
                                                           .material = scene->spheres[i].material};
    for (uint32_t i = 0; i < scene->shape_count; i++)
        add_mesh(world, &scene->meshes[scene->shapes[i].mesh], scene->shapes[i].material);
    float *areas = malloc(world->count * sizeof *areas);
    world->node_count = 1;
    if (!areas)
        return false;
    split(world, 0, 0, world->count, areas);
    free(areas);
    return true;
}

void float_world_free(struct float_world *world)
{
    free(world->items);
    free(world->nodes);
}

static bool meets_sphere(const struct float_item *item, const struct float_ray *ray, float *t)
{
    struct vec l = vec_sub(item->corner, ray->origin);
    float tca = vec_dot(l, ray->direction);
    struct vec rest = vec_along(l, -tca, ray->direction);
    float square = item->radius * item->radius - vec_dot(rest, rest);

    if (square < 0)
        return false;
    float root = sqrtf(square), first = tca - root > 0 ? tca - root : tca + root;
    if (first <= 0 || first >= *t)
        return false;
    *t = first;
    return true;
}

/* Intersects a triangle by the method of Moeller and Trumbore 1997. True for a hit nearer than *t, which is then
 * updated. */
static bool meets_triangle(const struct float_item *item, const struct float_ray *ray, float *t)
{
    struct vec p = vec_cross(ray->direction, item->side[1]), s = vec_sub(ray->origin, item->corner);
    float over = 1 / vec_dot(item->side[0], p), u = over * vec_dot(s, p);
    struct vec q = vec_cross(s, item->side[0]);
    float v = over * vec_dot(ray->direction, q), first = over * vec_dot(item->side[1], q);

    if (!(u >= 0 && v >= 0 && u + v <= 1 && first > 0 && first < *t))
        return false;
    *t = first;
    return true;
}

static bool passes(const struct float_node *node, struct vec origin, struct vec over, float t)
{
    float x0 = (node->low.x - origin.x) * over.x, x1 = (node->high.x - origin.x) * over.x;
    float y0 = (node->low.y - origin.y) * over.y, y1 = (node->high.y - origin.y) * over.y;
    float z0 = (node->low.z - origin.z) * over.z, z1 = (node->high.z - origin.z) * over.z;
    float near = fmaxf(fmaxf(fminf(x0, x1), fminf(y0, y1)), fmaxf(fminf(z0, z1), 0));
    float far = fminf(fminf(fmaxf(x0, x1), fmaxf(y0, y1)), fminf(fmaxf(z0, z1), t));

    return near <= far * 1.00001F;
}

void float_world_meet(const struct float_world *world, const struct float_ray *ray, bool any, struct float_hit *hit)
{
    const struct vec over = {1 / ray->direction.x, 1 / ray->direction.y, 1 / ray->direction.z};
    const bool down[3] = {ray->direction.x < 0, ray->direction.y < 0, ray->direction.z < 0};
    uint32_t stack[DEPTH], top = 0, at = 0;

    for (;;) {
        const struct float_node *node = &world->nodes[at];
        if (passes(node, ray->origin, over, hit->t)) {
            for (uint32_t i = node->first; i < node->first + node->count; i++) {
                const struct float_item *item = &world->items[i];
                if (item->radius > 0 ? meets_sphere(item, ray, &hit->t) : meets_triangle(item, ray, &hit->t))
                    hit->item = item;
            }
            if (any && hit->item)
                return;
            if (!node->count) {
                stack[top++] = node->first + !down[node->axis];
                at = node->first + down[node->axis];
                continue;
            }
        }
        if (!top)
            return;
        at = stack[--top];
    }
}
