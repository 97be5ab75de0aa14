/* Hierarchies and rays: few boxes are visited, and a walk in double precision finds the same as a test of all boxes. */
#include <math.h>

#include "hierarchy.h"

static double root_area;

static double area(const struct tia_bounds *b)
{
    double x = (double)b->max.x - b->min.x, y = (double)b->max.y - b->min.y, z = (double)b->max.z - b->min.z;
    return x * y + y * z + z * x;
}

/* Returns the cost of a random ray through the root: 1 for each pair of children and each item. */
static double cost(void)
{
    const struct tia_bvh_tree *tree = &bvh->objects;
    double sum = 0;

    root_area = area(&tree->nodes[0].bounds);
    for (uint32_t i = 0; i < tree->node_count; i++)
        sum += area(&tree->nodes[i].bounds) / root_area * (tree->nodes[i].count ? tree->nodes[i].count : 1);
    return sum;
}

/* A tree that only halves the items in their order would cost thousands here. */
TEST(few_items_a_ray)
{
    set_spheres(MOST);
    for (uint32_t i = 0; i < MOST; i++)
        spheres[i].radius = ONE / 2;
    build();
    CHECK_MSG(cost() < 75, "cost %.1f", cost());
    for (uint32_t i = 0; i < MOST; i++)
        spheres[i].centre = (struct tia_vec3){(tia_q16)i * ONE, 0, 0};
    build();
    CHECK_MSG(cost() < 30, "cost %.1f", cost());
}

/* Returns the distance at which the ray enters the box, or -1. */
static double enter(const struct tia_bounds *b, const double o[3], const double d[3])
{
    const double min[3] = {b->min.x, b->min.y, b->min.z}, max[3] = {b->max.x, b->max.y, b->max.z};
    double first = 0, last = 1e300;

    for (int k = 0; k < 3; k++) {
        double s = (min[k] - o[k]) / d[k], t = (max[k] - o[k]) / d[k];
        first = fmax(first, fmin(s, t));
        last = fmin(last, fmax(s, t));
    }
    return first <= last ? first : -1;
}

/* Returns the distance at which the ray enters the box of a mesh's face or, without a mesh, of an object; -1: it
 * misses. */
static double distance(const struct tia_mesh *mesh, uint32_t item, const double o[3], const double d[3])
{
    struct tia_bounds box = box_of(mesh, item);
    return enter(&box, o, d);
}

static double nearest_of_all(const struct tia_mesh *mesh, uint32_t count, const double o[3], const double d[3])
{
    double nearest = -1;

    for (uint32_t i = 0; i < count; i++) {
        double t = distance(mesh, i, o, d);
        nearest = t >= 0 && (nearest < 0 || t < nearest) ? t : nearest;
    }
    return nearest;
}

static double nearest_of_tree(const struct tia_bvh_tree *tree, const struct tia_mesh *mesh, const double o[3],
                              const double d[3])
{
    uint32_t stack[TIA_BVH_DEPTH_MAX + 1] = {0}, depth = tree->node_count ? 1 : 0;
    double nearest = -1;

    while (depth) {
        uint32_t index = stack[--depth];
        const struct tia_bvh_node *node = &tree->nodes[index];
        double t = enter(&node->bounds, o, d);
        if (t < 0 || (nearest >= 0 && t > nearest))
            continue;
        if (!node->count) {
            stack[depth++] = node->index;
            stack[depth++] = index + 1;
        }
        for (uint32_t i = 0; i < node->count; i++) {
            t = distance(mesh, tree->items[node->index + i], o, d);
            nearest = t >= 0 && (nearest < 0 || t < nearest) ? t : nearest;
        }
    }
    return nearest;
}

static void check_rays(const struct tia_bvh_tree *tree, const struct tia_mesh *mesh, int count, int32_t span)
{
    int hits = 0;

    for (int i = 0; i < count; i++) {
        struct tia_vec3 from = point(span), to = point(ONE);
        double o[3] = {from.x, from.y, from.z}, d[3] = {to.x + 0.5, to.y + 0.5, to.z + 0.5};
        double want = nearest_of_all(mesh, tree->item_count, o, d);
        CHECK(nearest_of_tree(tree, mesh, o, d) == want);
        hits += want >= 0;
    }
    CHECK(hits > count / 20);
}

TEST(rays)
{
    set_spheres(2000);
    build();
    check_rays(&bvh->objects, NULL, 1000, 150 * ONE);
    set_everything();
    for (uint32_t i = 0; i < 3000; i++) { /* faces, each of a random size */
        uint32_t near = (i * 7 + 1) % 3000;
        faces[i].corner[0].vertex = i;
        faces[i].corner[1].vertex = faces[i].corner[2].vertex = near;
        if (i % 2)
            vertices[near] = (struct tia_vec3){vertices[i].x + ONE, vertices[i].y + ONE / 2, vertices[i].z - ONE};
    }
    build();
    check_rays(&bvh->meshes[0], &meshes[0], 1000, 30 * ONE);
}

int main(void)
{
    RUN(few_items_a_ray);
    RUN(rays);
    free(memory);
    return check_status();
}
