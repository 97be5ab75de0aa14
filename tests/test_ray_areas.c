/* src/simd/rays, area lights as a whole: sums over samples, and the objects that their shadow rays may meet, beside
 * exact rays that are displaced as far as the errors allow. */
#include "one_lane.h"

#include "float_modes.h"
#include "ray_areas.h"

static const uint8_t class[1];

/* ---- sums ---- */

static void try_sum(struct used *cosines, struct used *highlights)
{
    const struct sure_scene scene = {.bias = 0};
    struct scenery c;
    struct shaft *f = &room.shaft;
    struct area_sum sum;
    struct area_terms t;
    long double lambert = 0, shine = 0;

    some_light(&c);
    some_view(&c);
    if (!c.area.fine)
        return;
    *f = (struct shaft){.area = &c.area, .shade = &c.shade, .lanes = 1};
    sum_clear(&scene, f, class, &sum);
    area_terms_of(&c.area, &c.shade, 1, &t);
    if (sum.unsure) {
        cosines->open++;
        return;
    }
    struct real n = real_of(c.shade.normal),
                to = real_unit((struct real){{c.light.at[0], c.light.at[1], c.light.at[2]}});
    struct real aside = real_unit(real_along(to, n, -real_dot(to, n)));
    long double turn = WITHIN * (long double)some_sign();
    struct real turned = real_turned(n, aside, turn * c.shade.en), p = real_of(c.shade.point);
    struct real off = real_unit(real_along(n, to, -real_dot(to, n)));
    p = real_along(p, off, -turn * c.shade.ep);
    for (int i = 0; i < SAMPLES; i++) {
        struct real way = real_unit(real_along(place_of(&c, i), p, -1));
        long double cosine = real_dot(turned, way), v = real_dot(real_of(c.shade.viewer), way);
        long double half = 2 * ((long double)c.shade.facing + turn * c.shade.efacing) * cosine - v;
        lambert += cosine > 0 ? cosine : 0;
        shine += cosine > 0 && half > 0 ? powl(half > 1 ? 1 : half, c.shade.exponent) : 0;
    }
    if (sum.count > 0) {
        use(cosines, lambert - sum.lambert[0], t.elambert * sum.count);
        use(highlights, shine - sum.shine[0], sum.eshine);
    }
}

TEST(sums)
{
    struct used cosines = {.name = "sum of cosines"}, highlights = {.name = "sum of highlights"};

    for (int i = 0; i < 2 * TRIES; i++)
        try_sum(&cosines, &highlights);
    check_used(&cosines);
    check_used(&highlights);
}

/* ---- objects in the way ---- */

/* The distance of the ray's nearest point to a centre; of its line if `whole`. */
static long double passes_at(const struct exact_ray *r, struct real centre, bool whole)
{
    struct real l = real_along(centre, r->o, -1);
    long double t = real_dot(l, r->d);

    t = whole ? t : t < 0 ? 0 : t > r->length ? r->length : t;
    struct real gap = real_along(l, r->d, -t);
    return sqrtl(real_dot(gap, gap));
}

/* Returns a radius with which a sample's ray nearly touches a ball, or any. */
static double near_touch(const struct scenery *c, struct real centre)
{
    struct exact_ray r = ray_to(c, (int)(random_bits() % SAMPLES), centre, 0);
    double exact = (double)passes_at(&r, centre, false);

    return random_bits() % 4 ? exact + c->shade.eoutside * 4 * random_double() : exact * (0.5 + some_part());
}

/* Begins a shaft from some point to some light; false if the light is not taken as a whole. */
static bool begin_shaft(struct scenery *c, struct sure_scene *scene, struct shaft *f)
{
    some_light(c);
    some_view(c);
    if (!c->area.fine)
        return false;
    *scene = (struct sure_scene){.extent = 16};
    *f = (struct shaft){.area = &c->area, .shade = &c->shade, .room = &room.room, .lanes = 1};
    f->rest = ~(unsigned)shaft_start(scene, f) & 1;
    c->shade.index[0] = 99;
    return true;
}

/* Returns some point about as far from the segment to the light's centre as `aside`. */
static struct real some_centre(const struct scenery *c, double aside)
{
    struct real way = real_along(real_of(c->shade.outside), real_of(c->area.out), 1.2L * (long double)random_double());

    return real_along(way, real_random(), (long double)(aside * some_part()));
}

/* Converts a vector to doubles, and returns it as these are. */
static struct real rounded(struct real v, double to[3])
{
    for (int i = 0; i < 3; i++)
        to[i] = (double)v.v[i];
    return (struct real){{to[0], to[1], to[2]}};
}

/* What the listed sphere decides of a sample: 1 met, 0 missed, -1 undecided. */
static int met_by_ball(const struct scenery *c, const struct shaft *f, int i, struct used *u, long double square)
{
    struct area_sample s = {.x = places[0][0][i], .y = places[0][1][i], .lit = 1};
    struct area_sum sum = {.unsure = 0};
    const struct ball *ball = &f->ball[0];
    double way = square_at(&c->area.shadow, s.x, s.y), along = affine_at(&ball->along, s.x, s.y);
    long double d = ((long double)along * along - (long double)ball->outside * way) / way;

    if (square > 0 && square < 0.001L)
        use(u, square - d, ball->error);
    pass_balls(f, &s, &sum);
    return sum.unsure ? -1 : !s.lit;
}

static void try_ball(struct used *u)
{
    static struct scenery c;
    struct sure_scene scene;
    struct shaft *f = &room.shaft;
    struct sure_object o = {.kind = SURE_SPHERE, .opaque = true};
    struct real centre;
    int wrong = 0;

    if (!begin_shaft(&c, &scene, f))
        return;
    centre = some_centre(&c, 2);
    o.radius = near_touch(&c, centre);
    centre = rounded(centre, o.at);
    shaft_ball(f, &o, 0, 1);
    for (int i = 0; i < SAMPLES; i++) {
        struct exact_ray r = ray_to(&c, i, centre, WITHIN * (long double)some_sign());
        long double line = passes_at(&r, centre, true), radius = o.radius;
        struct real from = real_along(centre, r.o, -1);
        bool inside = real_dot(from, from) < radius * radius;
        int met = !f->lanes ? 1 : f->balls ? met_by_ball(&c, f, i, u, radius * radius - line * line) : 0;
        if (f->others || met < 0)
            u->open++;
        else
            wrong += met != (inside || passes_at(&r, centre, false) < radius);
    }
    CHECK_MSG(wrong == 0, "a ball of radius %g: %d samples are wrong", o.radius, wrong);
}

TEST(balls)
{
    struct used u = {.name = "discriminant of a sphere"};

    for (int i = 0; i < 4 * TRIES; i++)
        try_ball(&u);
    check_used(&u);
}

/* A box, cylinder or cone passed by: its ball or its tube must be missed by each displaced ray. */
static void try_around(unsigned long *passed)
{
    static struct scenery c;
    struct sure_scene scene;
    struct shaft *f = &room.shaft;
    struct sure_round k = {.length = some_part()};
    struct sure_object o = {.kind = SURE_ROUND, .round = &k};
    struct real axis = real_random(), centre;

    if (!begin_shaft(&c, &scene, f))
        return;
    (void)rounded(axis, k.axis);
    centre = rounded(rounded(some_centre(&c, 1), o.at), k.anchor);
    struct exact_ray touch = ray_to(&c, 0, centre, 0);
    struct real across = real_unit(real_cross(touch.d, axis)), l = real_along(centre, touch.o, -1);
    k.base_radius = (double)fabsl(real_dot(across, l)) + 0x1p-20 * random_double();
    k.reach = random_bits() % 2 ? near_touch(&c, centre) : 8;
    shaft_other(f, &o, 0, 1);
    for (int i = 0; i < SAMPLES; i++) {
        vd x = places[0][0][i], y = places[0][1][i];
        struct exact_ray r = ray_to(&c, i, centre, WITHIN);
        struct real side = real_unit(real_cross(r.d, axis));
        bool by = !f->others || passes_around(&f->other[0], square_at(&c.area.shadow, x, y), x, y);
        bool near = passes_at(&r, centre, false) < k.reach &&
                    fabsl(real_dot(side, real_along(centre, r.o, -1))) < k.base_radius;
        *passed += by;
        CHECK_MSG(!by || !near || !f->others, "a tube of radius %g is met", k.base_radius);
    }
}

TEST(what_is_around_shapes)
{
    unsigned long passed = 0;

    for (int i = 0; i < 2 * TRIES; i++)
        try_around(&passed);
    printf("# %lu rays pass by\n", passed);
    CHECK_MSG(passed > 1000, "only %lu rays pass by", passed);
}

static void try_plane(unsigned long *missed)
{
    static struct scenery c;
    struct sure_scene scene;
    struct shaft *f = &room.shaft;
    struct sure_object o = {.kind = SURE_PLANE};
    struct real n = real_random(), at;

    if (!begin_shaft(&c, &scene, f))
        return;
    at = random_bits() % 2 ? real_of(c.shade.outside) : place_of(&c, 0);
    at = real_along(at, n, 4 * (long double)(c.shade.eoutside * random_double()));
    n = rounded(n, o.normal);
    at = rounded(at, o.at);
    if (!misses_plane(f, &o))
        return;
    struct real o1 = real_along(real_of(c.shade.outside), n, WITHIN * (long double)(some_sign() * c.shade.eoutside));
    long double height = real_dot(n, real_along(o1, at, -1));
    for (int i = 0; i < SAMPLES; i++) {
        long double end = real_dot(n, real_along(place_of(&c, i), at, -1));
        CHECK_MSG((end < 0) == (height < 0), "a plane between %Lg and %Lg", height, end);
    }
    ++*missed;
}

TEST(planes)
{
    unsigned long missed = 0;

    for (int i = 0; i < 2 * TRIES; i++)
        try_plane(&missed);
    printf("# %lu planes are missed\n", missed);
    CHECK_MSG(missed > 1000, "only %lu planes are missed", missed);
}

/* ---- faces ---- */

struct one_face {
    struct tia_vec3 vertices[3];
    struct tia_face face;
    struct tia_mesh mesh;
    struct sure_flat flat;
    struct sure_tree tree;
    struct sure_pair pair;
};

static void some_face(struct one_face *m)
{
    static const uint32_t items[1] = {0};
    static struct sure_node node = {.count = {1, 0}};

    memset(m, 0, sizeof *m);
    for (int i = 0; i < 3; i++) {
        m->face.corner[i] = (struct tia_corner){(uint32_t)i, TIA_NO_INDEX, TIA_NO_INDEX};
        m->vertices[i] = (struct tia_vec3){(tia_q16)(65536 * random_double()), (tia_q16)(65536 * random_double()),
                                           (tia_q16)(65536 * random_double())};
    }
    m->mesh = (struct tia_mesh){.vertices = m->vertices, .faces = &m->face};
    m->flat.extent = 1;
    m->tree = (struct sure_tree){
        .faces = &m->flat, .mesh = &m->mesh, .items = items, .node_count = 1, .extent = 3, .nodes = &node};
    (void)tia_sure_set_pairs(&m->pair, &node, &m->tree);
}

/* True if the line passes inside the face's edges. */
static bool is_inside(const struct one_face *m, const struct exact_ray *r)
{
    int over = 0, under = 0;

    for (int i = 0; i < 3; i++) {
        const struct tia_vec3 *v = &m->vertices[i], *w = &m->vertices[(i + 1) % 3];
        struct real a = {{v->x / 65536.0L, v->y / 65536.0L, v->z / 65536.0L}},
                    b = {{w->x / 65536.0L, w->y / 65536.0L, w->z / 65536.0L}};
        long double area = real_dot(r->d, real_cross(real_along(a, r->o, -1), real_along(b, r->o, -1)));
        over += area > 0;
        under += area < 0;
    }
    return over == 3 || under == 3;
}

static void try_face(unsigned long *passed)
{
    static struct scenery c;
    struct one_face m;
    struct sure_scene scene;
    struct shaft *f = &room.shaft;
    struct pair_test t;

    if (!begin_shaft(&c, &scene, f))
        return;
    some_face(&m);
    pair_test_of(f, &m.tree, &t);
    if (pair_may_be_met(&t, &m.pair) & 1)
        return;
    for (int i = 0; i < SAMPLES; i++) {
        struct real corner = {
            {m.vertices[i % 3].x / 65536.0L, m.vertices[i % 3].y / 65536.0L, m.vertices[i % 3].z / 65536.0L}};
        struct exact_ray r = ray_to(&c, i, corner, WITHIN);
        CHECK_MSG(!is_inside(&m, &r), "a face that is passed by is met by sample %d", i);
    }
    ++*passed;
}

TEST(faces)
{
    unsigned long passed = 0;

    for (int i = 0; i < 4 * TRIES; i++)
        try_face(&passed);
    printf("# %lu faces are passed by\n", passed);
    CHECK_MSG(passed > 1000, "only %lu faces are passed by", passed);
}

int main(void)
{
    (void)trace;
    float_mode_of_simd();
    RUN(sums);
    RUN(balls);
    RUN(what_is_around_shapes);
    RUN(planes);
    RUN(faces);
    return check_status();
}
