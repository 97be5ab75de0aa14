/* walk_cases.h - src/render/geometry/walk.c against boxes in long double, in whatever arithmetic it is compiled for. */
#include "mesh_made.h"
#include "render/geometry/walk.h"

/* The part of its distance by which a box that is missed may count as entered, and the slope below which a ray across
 * an axis enters too early, see num_slope. */
#ifdef TIA_NUM_F64
#define COARSE 0
#define LEVEL 0x1p-20L
#else
#define COARSE 0x1p-20L
#define LEVEL 0x1p-8L
#endif

static bool is_level(const struct ray *ray)
{
    real3 d = real3_dir(ray->direction);

    return fminl(fabsl(d.x), fminl(fabsl(d.y), fabsl(d.z))) < LEVEL;
}

/* By how far the ray misses a box before the limit, if it is nearer by `part` of its distance; below 0: it enters. */
static long double misses_by(const struct tia_bounds *b, const struct ray *ray, long double limit, long double part)
{
    real3 o = real3_of(ray->origin), d = real3_dir(ray->direction), min = real3_vec(b->min), max = real3_vec(b->max);
    const long double from[3] = {(min.x - o.x) / d.x, (min.y - o.y) / d.y, (min.z - o.z) / d.z};
    const long double to[3] = {(max.x - o.x) / d.x, (max.y - o.y) / d.y, (max.z - o.z) / d.z};
    long double near = 0, far = limit;

    for (int i = 0; i < 3; i++) {
        near = fmaxl(near, fminl(from[i], to[i]));
        far = fminl(far, fmaxl(from[i], to[i]));
    }
    return near * (1 - part) - far;
}

/* Each leaf once, and no other. */
static unsigned check_leaves(const struct made *m, const struct ray *ray, long double limit)
{
    static uint8_t times[2 * MADE_FACES];
    const struct tia_bvh_node *leaf;
    unsigned count = 0;
    struct walk walk;

    memset(times, 0, sizeof times);
    walk_start(&walk, &m->tree, ray);
    while ((leaf = walk_leaf(&walk, num_of(limit))) != NULL && count++ < MADE_FACES)
        times[leaf - m->nodes]++;
    for (uint32_t n = 0; n < m->tree.node_count; n++) {
        long double by = misses_by(&m->nodes[n].bounds, ray, limit, 0);
        if (m->nodes[n].count == 0)
            CHECK_EQ(times[n], 0);
        else if (by < 0)
            CHECK_MSG(times[n] == 1, "leaf %u: %u times, by %Lg", n, times[n], by);
        else if (!is_level(ray) && misses_by(&m->nodes[n].bounds, ray, limit, COARSE) > 1e-5L)
            CHECK_MSG(times[n] == 0, "leaf %u: %u times, by %Lg", n, times[n], by);
    }
    return count;
}

/* A leaf that lies beyond a limit that has become smaller is left out. */
static void check_shrinking(const struct made *m, const struct ray *ray, long double limit)
{
    const struct tia_bvh_node *leaf;
    struct walk walk;

    walk_start(&walk, &m->tree, ray);
    while ((leaf = walk_leaf(&walk, num_of(limit))) != NULL) {
        CHECK(is_level(ray) || misses_by(&leaf->bounds, ray, limit, COARSE) < 1e-5L);
        limit *= 0.9L;
    }
}

TEST(a_walk_finds_the_leaves_that_the_ray_enters)
{
    unsigned count = 0;

    for (int i = 0; i < 30; i++) {
        long double size = powl(2, 14 - (long double)(random_bits() % 20));
        struct made *m = made_disorder(size, 60);
        made_tree(m);
        for (int k = 0; k < 300; k++) {
            struct ray ray = ray_towards(random_real3(2 * size), random_real3(size));
            long double limit = size * (4 + 3 * random_real());
            count += check_leaves(m, &ray, limit < 131072 ? limit : 131072);
            check_shrinking(m, &ray, 3 * size);
        }
        made_free(m);
    }
    CHECK(count > 10000);
}

/* In a plane across an axis, seen from a point of that plane's neighbourhood: slopes that are nearly or exactly 0. */
TEST(level_rays_find_their_way_through_a_tree)
{
    struct made *m = made_sphere((struct tia_vec3){TIA_Q16(9000), 0, 0}, 4, 2);
    unsigned hits[2] = {0, 0};

    made_tree(m);
    struct shape with, without;
    prepare_mesh_alone(&with, &m->mesh, &m->tree);
    prepare_mesh_alone(&without, &m->mesh, NULL);
    for (int i = 0; i < 20000; i++) {
        num_unit tiny = NUM_UNIT_LEVEL / (1 + (num_unit)(random_bits() % 64)) * (int)(random_bits() % 3 - 1);
        struct intersection a, b;
        struct ray ray = {{num_of(random_real()), num_of(random_real() * 4), num_of(random_real() * 4)},
                          {NUM_UNIT_ONE, tiny, random_bits() % 2 ? 0 : -tiny}};
        bool met = without.kind->intersect(&without, &ray, NUM_LENGTH_MAX, &a);
        CHECK_EQ(with.kind->intersect(&with, &ray, NUM_LENGTH_MAX, &b), met);
        CHECK(!met || (a.t == b.t && a.element == b.element));
        hits[met]++;
    }
    CHECK(hits[0] > 1000 && hits[1] > 1000);
    made_free(m);
}

int main(void)
{
    RUN(a_walk_finds_the_leaves_that_the_ray_enters);
    RUN(level_rays_find_their_way_through_a_tree);
    return check_status();
}
