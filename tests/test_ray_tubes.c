/* src/simd/rays, cylinders: intersections of lines with the side when they are moved by all that the bound allows, by
 * formula; and by the fixed-point code where only the rounding of either side differs. */
#include "float_modes.h"
#include "ray_edges.h"

#include "ray_steps.h"

enum { TRIES = 40000 };
#define WITHIN .9999L /* used part of a bound */

/* ---- moved rays ---- */

/* A ray that meets the side of radius 1 around the z axis, and the fixed-point ray beside it. */
struct passing {
    struct real o, d;
    double eo, ed;
    struct real theirs[2];
    long double start, half; /* start: position of the ray's start on the chord, from the chord's middle; half: half the
                                chord; both across the axis */
};

static long double power_of_two(unsigned bits)
{
    return ldexpl(1 + (long double)some_part(), -1 - (int)(random_bits() % bits));
}

/* Returns a start outside the chord, close to either end of it, or anywhere on it. */
static long double some_start(long double half)
{
    switch (random_bits() % 4) {
    case 0:
        return -half - 4 * (long double)some_part();
    case 1:
        return -half * (1 + power_of_two(20));
    case 2:
        return -half * (1 - power_of_two(20));
    default:
        return half * random_real();
    }
}

/* Returns a unit vector: random, along y or along -y; projected onto the plane across `d` unless `d` is NULL. */
static struct real some_way(const struct real *d)
{
    struct real way = random_bits() % 2 ? real_random() : (struct real){{0, 1, 0}};

    if (d)
        way = real_unit(real_along(way, *d, -real_dot(way, *d)));
    return random_bits() % 2 ? way : real_along((struct real){{0, 0, 0}}, way, -1);
}

static void some_passing(struct passing *p)
{
    long double f = power_of_two(5), aside;
    double size;

    p->half = power_of_two(9);
    p->start = some_start(p->half);
    aside = sqrtl(1 - p->half * p->half);
    p->d = real_unit((struct real){{f, 0, sqrtl(1 - f * f)}});
    p->o = (struct real){{p->start, aside * (long double)some_sign(), 0}};
    size = (double)(p->half * f);
    p->eo = size * size * some_size(2, 20);
    p->ed = random_bits() % 2 ? size * some_size(2, 12) : 0;
    p->theirs[0] = real_along(p->o, some_way(NULL), p->eo * WITHIN);
    p->theirs[1] = real_turned(p->d, some_way(&p->d), p->ed * WITHIN);
}

static void meet_tube(const struct passing *p, struct packet *packet, struct query *q)
{
    static const struct sure_round round = {.axis = {0, 0, 1},
                                            .across = {{1, 0, 0}, {0, 1, 0}},
                                            .base = {0, 0, -512},
                                            .reach = 1025,
                                            .length = 1024,
                                            .base_radius = 1,
                                            .top_radius = 1,
                                            .cosine = 1};

    *packet = (struct packet){.o = v3_of(p->o), .d = v3_of(p->d), .eo = p->eo, .ed = p->ed, .from = {-1, 0, 0}};
    *q = (struct query){
        .p = packet, .active = 1, .limit = INFINITE, .t = INFINITE, .low = INFINITE, .id = -1, .element = -1};
    meet_cylinder(q, &round);
}

static void try_tube(struct used *ends, struct used *points)
{
    struct passing p;
    struct packet packet;
    struct query q;

    some_passing(&p);
    meet_tube(&p, &packet, &q);
    if (q.t >= INFINITE || !(q.t + q.e < q.low)) {
        ends->open++;
        return;
    }
    const long double *o = p.theirs[0].v, *d = p.theirs[1].v;
    long double square = d[0] * d[0] + d[1] * d[1], cross = o[0] * d[1] - o[1] * d[0], root = square - cross * cross;
    CHECK_MSG(root > 0, "a line surely meets the side, and does not");
    bool first = q.t < -p.start / p.d.v[0];
    long double t = (-(o[0] * d[0] + o[1] * d[1]) + (first ? -1 : 1) * sqrtl(root)) / square;
    use(ends, t - q.t, q.e);
    use(points, real_gap(real_along(p.theirs[0], p.theirs[1], t), v3_along(packet.o, packet.d, q.t)), q.ep);
}

TEST(moved_rays)
{
    struct used ends = {.name = "distance of a side"}, points = {.name = "point of a side"};

    for (int i = 0; i < 10 * TRIES && !check_failed; i++)
        try_tube(&ends, &points);
    check_used(&ends);
    check_used(&points);
}

/* ---- roundings ---- */

/* A random cylinder, and a distant object, so that the unit of length is no smaller than the file's. */
struct given {
    const char *name;
    double far, length, radius; /* far: largest coordinate of the cylinder's base */
    long double away;           /* largest distance of a ray's start from the cylinder */
};

struct thin {
    struct real base, axis, across[2];
    long double radius;
};

static void open_thin(const struct given *given, struct thin *c)
{
    struct real way = real_random();
    struct world world = {"thin cylinder", NULL};
    char text[400];
    double at[2][3];

    for (int i = 0; i < 3; i++) {
        at[0][i] = round(65536 * given->far * random_double()) / 65536;
        at[1][i] = at[0][i] + round(65536 * given->length * (double)way.v[i]) / 65536;
        c->base.v[i] = at[0][i];
        way.v[i] = at[1][i] - at[0][i];
    }
    (void)snprintf(text, sizeof text,
                   "cylinder base %.16f %.16f %.16f top %.16f %.16f %.16f radius %.16f material plain\n"
                   "sphere centre 0 0 -20000 radius 1 material plain\n",
                   at[0][0], at[0][1], at[0][2], at[1][0], at[1][1], at[1][2], given->radius);
    world.text = text;
    open_world(&world);
    c->radius = given->radius;
    c->axis = way;
    c->across[0] = real_aside(real_unit(way));
    c->across[1] = real_cross(real_unit(way), c->across[0]);
}

/* Returns the fixed-point ray, which passes the axis at nearly the radius, from a distance of `away` at most; its start
 * is exact in doubles. */
static struct ray grazing_ray(const struct thin *c, long double away)
{
    long double turn = 3.2L * random_real(), aside = c->radius * (1 - ldexpl(1, -(int)(random_bits() % 36)));
    struct real n =
        real_along(real_along((struct real){{0, 0, 0}}, c->across[0], cosl(turn)), c->across[1], sinl(turn));
    struct real y = real_cross(real_unit(c->axis), n), d, o;

    d = real_unit(real_along(y, c->axis, 100 * random_real()));
    o = real_along(real_along(c->base, c->axis, some_part()), n, aside);
    o = real_along(o, d, -away * some_part());
    return (struct ray){place((struct real3){{(double)o.v[0], (double)o.v[1], (double)o.v[2]}}),
                        towards((struct real3){{d.v[0], d.v[1], d.v[2]}})};
}

/* Tests the ray in doubles, which have its exact origin and its rounded direction. */
static void try_exact(const struct ray *ray, struct used *ends, struct used *points)
{
    struct packet p = {.ed = SURE_EPS, .from = {-1, 0, 0}};
    double at[3];
    struct query q;
    struct hit hit;

    sure_point(at, ray->origin);
    p.o = v3_set(at);
    sure_dir(at, ray->direction);
    p.d = v3_set(at);
    find_nearest(scene, &lights.room, &q, &p, 1);
    if (q.id < 0 || !(q.t + q.e < q.low)) {
        ends->open++;
        return;
    }
    meet(ray, &hit);
    CHECK_MSG(hit.object == (uint32_t)q.id, "a line surely meets the side, and does not");
    if (hit.object != (uint32_t)q.id)
        return;
    use(ends, sure_length(hit.t) - q.t, q.e);
    sure_point(at, num_point_at(ray->origin, ray->direction, hit.t));
    use(points, real_gap((struct real){{at[0], at[1], at[2]}}, v3_along(p.o, p.d, q.t)),
        q.ep + (v3_sum(p.o) + q.t) * P2M(51)); /* as in find_surfaces() */
}

static void try_thin(const struct given *given)
{
    struct used ends = {.name = given->name}, points = {.name = given->name};
    struct thin c;

    for (int i = 0; i < 100 && !check_failed; i++) {
        open_thin(given, &c);
        for (int k = 0; k < 400; k++) {
            struct ray ray = grazing_ray(&c, given->away);
            try_exact(&ray, &ends, &points);
        }
        close_world();
    }
    check_used(&ends);
    check_used(&points);
}

TEST(roundings)
{
    static const struct given given[] = {{"thin cylinder close by", 0.03, 0.03, 0.015625, 0.02L},
                                         {"thin cylinder from afar", 0.03, 0.03, 0.015625, 1000},
                                         {"thin cylinder far out", 10000, 0.03, 0.015625, 0.02L},
                                         {"long cylinder", 0.03, 10000, 0.5, 1}};

    for (size_t i = 0; i < sizeof given / sizeof *given; i++)
        try_thin(&given[i]);
}

int main(void)
{
    (void)trace;
    (void)edge_ray;
    (void)moved;
    (void)random_size;
    (void)worlds;
    float_mode_of_simd();
    RUN(moved_rays);
    RUN(roundings);
    return check_status();
}
