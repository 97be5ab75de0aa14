/* walk_cases.h - tests src/render/geometry/walk.c, in the arithmetic for which it is compiled, against boxes in long
 * double. */
#include "mesh_made.h"
#include "render/geometry/walk.h"

/* The walk's tolerance. COARSE: a box that is missed by less than this fraction of its distance may count as entered.
 * LEVEL: smaller slopes across an axis may count as this slope, see num_slope and clip of walk.c. The tolerance costs
 * time, but no leaf: every leaf that the ray enters must be found. */
#ifdef TIA_NUM_F64
#define COARSE 0
#define LEVEL 0x1p-20L
#else
#define COARSE 0x1p-20L
#define LEVEL 0x1p-8L
#endif

/* Clips the ray to the part between two planes across an axis. A ray with a slope below `least` enters as if the slope
 * were `least`, and leaves only if it would do so behind its origin. */
static void clip_to(long double min, long double max, long double o, long double d, long double least,
                    long double *near, long double *far)
{
    bool parallel = fabsl(d) < least;
    long double slope = parallel ? (d < 0 ? -least : least) : d, from = (min - o) / slope, to = (max - o) / slope;

    *near = fmaxl(*near, fminl(from, to));
    if (!parallel || fmaxl(from, to) < 0)
        *far = fminl(*far, fmaxl(from, to));
}

/* Returns the distance by which the ray misses a box before the limit; negative if the ray enters the box. With
 * `coarse`, the walk's tolerance is applied. */
static long double misses_by(const struct tia_bounds *b, const struct ray *ray, long double limit, bool coarse)
{
    real3 o = real3_of(ray->origin), d = real3_dir(ray->direction), min = real3_vec(b->min), max = real3_vec(b->max);
    long double near = 0, far = limit, least = coarse ? LEVEL : 0;

    clip_to(min.x, max.x, o.x, d.x, least, &near, &far);
    clip_to(min.y, max.y, o.y, d.y, least, &near, &far);
    clip_to(min.z, max.z, o.z, d.z, least, &near, &far);
    return near * (1 - (coarse ? COARSE : 0)) - far;
}

/* Returns a slope below 2 LEVEL, of either sign, or 0. */
static num_unit tiny_slope(void)
{
    long double size = ldexpl(LEVEL * (2 - fabsl(random_real())), -(int)(random_bits() % 40));

    return (num_unit)(size * (long double)NUM_UNIT_ONE) * (int)(random_bits() % 3 - 1);
}

/* Checks that the walk returns each entered leaf once, and no other leaf. Returns the number of leaves. */
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
        long double by = misses_by(&m->nodes[n].bounds, ray, limit, false);
        if (m->nodes[n].count == 0)
            CHECK_EQ(times[n], 0);
        else if (by < 0)
            CHECK_MSG(times[n] == 1, "leaf %u: %u times, by %Lg", n, times[n], by);
        else if (misses_by(&m->nodes[n].bounds, ray, limit, true) > 1e-5L)
            CHECK_MSG(times[n] == 0, "leaf %u: %u times, by %Lg", n, times[n], by);
    }
    return count;
}

/* Checks that a leaf beyond the limit is skipped after the limit has been reduced. */
static void check_shrinking(const struct made *m, const struct ray *ray, long double limit)
{
    const struct tia_bvh_node *leaf;
    struct walk walk;

    walk_start(&walk, &m->tree, ray);
    while ((leaf = walk_leaf(&walk, num_of(limit))) != NULL) {
        CHECK(misses_by(&leaf->bounds, ray, limit, true) < 1e-5L);
        limit *= 0.9L;
    }
}

/* Makes the ray nearly perpendicular to one axis or to two, and so nearly parallel to two or four faces of a box. */
static void level_out(struct ray *ray, int i)
{
    num_unit *d[3] = {&ray->direction.x, &ray->direction.y, &ray->direction.z};

    *d[i % 3] = tiny_slope();
    if (i % 2)
        *d[(i + 1) % 3] = tiny_slope();
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
            if (k % 3 == 0)
                level_out(&ray, k / 3);
            long double limit = size * (4 + 3 * random_real());
            count += check_leaves(m, &ray, limit < 131072 ? limit : 131072);
            check_shrinking(m, &ray, 3 * size);
        }
        made_free(m);
    }
    CHECK(count > 10000);
}

/* Rays run almost along the x axis to a distant tree: their slopes across its planes are nearly or exactly 0. */
TEST(level_rays_find_their_way_through_a_tree)
{
    struct made *m = made_sphere((struct tia_vec3){TIA_Q16(9000), 0, 0}, 4, 2);
    unsigned hits[2] = {0, 0};

    made_tree(m);
    struct shape with, without;
    prepare_mesh_alone(&with, &m->mesh, &m->tree);
    prepare_mesh_alone(&without, &m->mesh, NULL);
    for (int i = 0; i < 20000; i++) {
        num_unit tiny = tiny_slope();
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
