/* Surfaces, their light and the rays that they spawn, in src/simd/rays: each step by itself, at the far end of its
 * bound (see ray_steps.h). */
#include "one_lane.h"

#include "float_modes.h"
#include "ray_steps.h"
#include "simd/rays/walk_paths_tmpl.h"

enum { TRIES = 20000 };
#define WITHIN .9999L /* used part of a bound */

static const struct real nowhere = {{0, 0, 0}};

/* ---- surfaces ---- */

static void try_side(struct used *u)
{
    struct real viewer = real_random(), normal = real_aside(viewer);
    struct shade h = {.eg = some_size(6, 30), .ev = some_size(6, 30)};
    double bound = h.eg + h.ev;
    long double side = 1.5L * random_real() * bound, theirs = side + bound * WITHIN * (long double)some_sign();

    h.viewer = v3_of(viewer);
    h.geometric = h.normal = v3_of(real_along(normal, viewer, side));
    turn(&h);
    if (h.unsure)
        u->open++;
    else
        use(u, h.back == (theirs < 0) ? 0 : 2, 1);
}

static void try_start(struct used *u)
{
    const struct sure_scene scene = {.bias = P2M(13)};
    struct real off = real_random(), point = real_random(), normal = real_random();
    struct shade h = {.point = v3_of(point), .geometric = v3_of(normal), .ep = some_size(20, 40)};
    vd eo;

    h.eg = some_size(4, 30);
    struct v3 from = off_surface(&scene, &h, scene.bias, &eo);
    point = real_along(real_of(h.point), off, h.ep * WITHIN);
    use(u, real_gap(real_along(point, real_along(real_of(h.geometric), off, h.eg * WITHIN), scene.bias), from), eo);
}

/* Tests rays that certainly leave their start, or certainly return to it. */
static void try_leaving(struct used *u)
{
    struct real way = real_random(), normal = real_aside(way);
    struct shade h = {.eg = some_size(6, 30), .id = 3};
    double ed = some_size(6, 30), bound = h.eg + ed, sign = some_sign();
    long double side = 1.5L * random_real() * bound, theirs = side + bound * WITHIN * (long double)some_sign();

    h.geometric = v3_of(real_along(normal, way, side));
    struct origin from = leaving_or_not(&h, v3_of(way), ed, sign, P2M(13));
    if (from.object < 0)
        u->open++;
    else
        use(u, (from.side < 0) == (theirs * (long double)sign < 0) ? 0 : 2, 1);
}

/* Returns the corners' mean normal, weighted by areas projected along axis `main`; areas below 0 count as 0. */
static struct real smoothed(const struct smooth_faces *f, struct real at, int main)
{
    int a = (main + 1) % 3, b = (main + 2) % 3;
    struct real sum = {{0, 0, 0}};
    long double all = 0, part[3];

    for (int i = 0; i < 3; i++) {
        const double(*p)[LANES] = f->at[(i + 1) % 3], (*q)[LANES] = f->at[(i + 2) % 3];
        part[i] = (*p[a] - at.v[a]) * (*q[b] - at.v[b]) - (*p[b] - at.v[b]) * (*q[a] - at.v[a]);
    }
    long double sign = part[0] + part[1] + part[2] < 0 ? -1 : 1;
    for (int i = 0; i < 3; i++) {
        part[i] = part[i] * sign < 0 ? 0 : part[i] * sign;
        all += part[i];
    }
    for (int i = 0; i < 3; i++)
        sum = real_along(sum, (struct real){{*f->normal[i][0], *f->normal[i][1], *f->normal[i][2]}}, part[i] / all);
    return real_unit(sum);
}

/* Makes a face across the z axis, with corner 0 at the origin. */
static void make_face(struct smooth_faces *f)
{
    const struct real up = {{0, 0, 1}};
    const double at[3][3] = {{0, 0, 0.1}, {1, 0.1 * random_double(), 0.1}, {0.6 * random_double(), 1, 0.1}};

    memcpy(f->at, at, sizeof at);
    *f->extent = fmax(1 + fabs(at[1][1]), 1 + fabs(at[2][0]));
    for (int i = 0; i < 3; i++) {
        struct real n = i == 1 + (int)(random_bits() % 2) ? real_turned(up, real_aside(up), 0.4L) : up;
        for (int k = 0; k < 3; k++)
            *f->normal[i][k] = (double)n.v[k];
    }
}

/* Tests points in the face, on its edges or at its corners; the fixed-point one may be outside. */
static void try_smooth(struct used *u, bool inside)
{
    struct smooth_faces f;
    int edge = (int)(random_bits() % 3);
    long double part[3], sum = 0;
    struct real at = nowhere, off = real_random();

    make_face(&f);
    for (int i = 0; i < 3; i++) {
        part[i] = inside ? some_part() + 0.3 : i != edge && random_bits() % 3 ? some_part() : 0;
        sum += part[i];
    }
    if (sum == 0)
        return;
    for (int i = 0; i < 3; i++)
        at = real_along(at, (struct real){{*f.at[i][0], *f.at[i][1], *f.at[i][2]}}, part[i] / sum);
    off.v[2] = 0;
    off = real_unit(off);
    struct shade h = {.local = v3_of(at), .elocal = some_size(7, 30), .geometric = {0, 0, 1}};
    smooth_normals(&h, &f, 1);
    if (h.unsure)
        u->open++;
    else
        use(u, real_gap(smoothed(&f, real_along(at, off, h.elocal * WITHIN), 2), h.normal), h.en);
}

TEST(surfaces)
{
    struct used sides = {.name = "side of a surface"}, starts = {.name = "origin of a ray"},
                away = {.name = "way off a surface, or back"}, smooth = {.name = "smooth normal"},
                edges = {.name = "smooth normal at an edge"};

    for (int i = 0; i < TRIES; i++) {
        try_side(&sides);
        try_start(&starts);
        try_leaving(&away);
        try_smooth(&smooth, true);
        try_smooth(&edges, false);
    }
    check_used(&sides);
    check_used(&starts);
    check_used(&away);
    check_used(&smooth);
    check_used(&edges);
}

/* ---- the light of surfaces and rays ---- */

struct one_ray {
    struct sure_scene scene;
    struct sure_block block;
    struct work work;
    struct rays rays;
};

/* Returns a ray with an error of its throughput; *theirs receives the fixed-point throughput minus that of the ray. */
static struct one_ray *some_ray(double *theirs)
{
    static struct one_ray one;
    double weight = some_part();

    one.scene = (struct sure_scene){.depth = 5, .bias = P2M(13), .brightest = {1}, .generations = 6};
    one.block = (struct sure_block){.scene = &one.scene};
    one.work.block = &one.block;
    one.work.queue.count = 0;
    one.work.rays[0] = 0;
    one.rays = (struct rays){.weight = {weight, weight, weight}, .ew = some_size(4, 40)};
    *theirs = one.rays.ew * (double)WITHIN * some_sign();
    return &one;
}

#define FIRST(column) one->work.queue.number[column][0] /* of the first queued ray */

static void try_own(struct used *u)
{
    double theirs;
    struct one_ray *one = some_ray(&theirs);
    struct shade h = {.flat = {1, 1, 1}, .facing = some_part(), .efacing = some_size(4, 40)};
    unsigned lanes = 1;

    add_own(&one->work, &lanes, &h, &one->rays, NULL);
    u->open += !lanes; /* the error is large: the fixed-point path follows the ray */
    if (!lanes)
        return;
    long double facing = h.facing + h.efacing * WITHIN * (theirs < 0 ? -1 : 1);
    use(u, (facing > 0 ? facing : 0) * (one->rays.weight[0] + theirs) - one->block.colour[0][0], one->block.error[0]);
}

static void try_sky(struct used *u)
{
    double theirs;
    struct one_ray *one = some_ray(&theirs);
    struct query q = {.t = INFINITE, .id = -1};
    unsigned lanes = 1;

    one->scene.background[0] = some_part();
    add_far(&one->work, &lanes, &q, &one->rays);
    use(u, one->scene.background[0] * (one->rays.weight[0] + (long double)theirs) - one->block.colour[0][0],
        one->block.error[0]);
}

/* Tests an undecided ray that is dropped: the fixed-point light may be anything from 0 to all that is possible. */
static void try_given_up(struct used *u)
{
    double theirs;
    struct one_ray *one = some_ray(&theirs);
    const struct sure_block *b = &one->block;

    give_up(&one->work, 1, &one->rays, P2M(9));
    if (b->unsure[0]) {
        u->open++;
        return;
    }
    use(u, b->colour[0][0], b->error[0]);
    use(u, fmaxl(one->rays.weight[0] * P2M(9) + (long double)theirs, 0) - b->colour[0][0], b->error[0]);
}

/* Tests rays that may be too faint: below 2^-16. */
static void try_faint(struct used *u)
{
    double theirs, around = P2M(16);
    struct one_ray *one = some_ray(&theirs);

    one->rays.ew = around * some_size(2, 20);
    one->rays.weight[0] = one->rays.weight[1] = one->rays.weight[2] =
        around + 1.5 * one->rays.ew * random_double() + P2M(42) * random_double();
    theirs = one->rays.weight[0] + (one->rays.ew + P2M(43)) * (double)WITHIN * some_sign();
    push(&one->work, 1, &one->rays, false, false);
    if (one->block.unsure[0] || one->block.error[0] > 0)
        u->open++;
    else
        use(u, (one->work.queue.count == 1) == (theirs >= around) ? 0 : 2, 1);
}

TEST(colours)
{
    struct used own = {.name = "own light"}, sky = {.name = "background"}, up = {.name = "rays given up"},
                faint = {.name = "faint rays"};

    for (int i = 0; i < TRIES; i++) {
        try_own(&own);
        try_sky(&sky);
        try_given_up(&up);
        try_faint(&faint);
    }
    check_used(&own);
    check_used(&sky);
    check_used(&up);
    check_used(&faint);
}

/* ---- refraction ---- */

/* Returns Fresnel's reflectance for eta = n2/n1 and the cosine c; -1: total. *root: eta times the refracted cosine. */
static long double fresnel_of(long double eta, long double c, long double *root)
{
    long double inside = eta * eta - 1 + c * c;

    if (inside <= 0)
        return -1;
    *root = sqrtl(inside);
    long double s = (c - *root) / (c + *root), p = (eta * eta * c - *root) / (eta * eta * c + *root);
    return (s * s + p * p) / 2;
}

/* Returns a cosine, mostly at grazing angles, or close to total reflection; *ec receives the bound of its error. */
static long double some_cosine(double eta, double *ec)
{
    long double edge = sqrtl(fmaxl(1 - (long double)(eta * eta), 0));
    long double c = random_bits() % 2 && edge > 0 ? edge + ldexpl(1 - edge, -(int)(random_bits() % 12)) * some_part()
                                                  : ldexpl(some_part(), -(int)(random_bits() % 12));

    *ec = (double)c * some_size(1, 30);
    return c;
}

static void try_refraction(struct used *directions, struct used *parts, struct used *totals)
{
    double eta = random_bits() % 2 ? 1 + 1.5 * some_part() : 1 / (1 + 1.5 * some_part()), part = 0.25, ec;
    long double c = some_cosine(eta, &ec), s = sqrtl(fmaxl(1 - c * c, 0)), turn = WITHIN * (long double)some_sign(),
                theirs = c + ec * turn, root = 0;
    struct real normal = real_random(), aside = real_aside(normal);
    struct real viewer = real_along(real_along(nowhere, normal, c), aside, s);
    struct real other = real_along(real_along(nowhere, normal, theirs), aside, sqrtl(fmaxl(1 - theirs * theirs, 0)));
    struct shade h = {
        .normal = v3_of(normal), .viewer = v3_of(viewer), .facing = (double)c, .efacing = ec, .fresnel = 1};
    struct refraction f = {.straight = 0};

    h.ev = (double)real_gap(other, h.viewer);
    refract(&h, 1, eta * part, part, &f);
    if (f.unsure || theirs > 1 || theirs <= 0) {
        parts->open++;
        return;
    }
    long double fresnel = fresnel_of(eta, theirs, &root);
    use(totals, (fresnel < 0) == f.total ? 0 : 2, 1);
    if (fresnel < 0 || f.total)
        return;
    use(parts, fresnel - f.fresnel, f.efresnel);
    other = real_unit(real_along(real_along(nowhere, normal, theirs - root), other, -1));
    use(directions, real_gap(other, f.to), f.eto);
}

/* Tests spawned rays with the largest value of each part: only the products matter here. */
static void try_spawned(struct used *through, struct used *back)
{
    double theirs;
    struct one_ray *one = some_ray(&theirs);
    struct shade h = {.refraction = {1, 1, 1}, .geometric = {0, 0, 1}, .normal = {0, 0, 1}, .viewer = {0, 0, 1}};
    struct refraction f = {.to = {0, 0, -1}, .bends = 1, .fresnel = some_part(), .efresnel = some_size(4, 40)};
    const vd mirror = some_part(), both = mirror + f.fresnel, reflects[3] = {both, both, both};
    long double weight = one->rays.weight[0] + (long double)theirs,
                fresnel = f.fresnel + f.efresnel * WITHIN * (theirs < 0 ? -1 : 1);

    if (fresnel < 0 || fresnel > 1 || weight > 1 || weight < 0)
        return;
    push_reflected(&one->work, &h, 1, &one->rays, reflects, f.efresnel);
    if (one->work.queue.count == 1)
        use(back, weight * (mirror + fresnel) - FIRST(6), FIRST(11));
    fresnel = f.fresnel - f.efresnel * WITHIN * (theirs < 0 ? -1 : 1);
    one->work.queue.count = 0;
    if (fresnel < 0)
        return;
    push_refracted(&one->work, &h, 1, &one->rays, &f);
    if (one->work.queue.count == 1)
        use(through, weight * (1 - fresnel) - FIRST(6), FIRST(11));
}

static void try_straight(struct used *u)
{
    double theirs;
    struct one_ray *one = some_ray(&theirs);
    struct real point = real_random(), viewer = real_random(), off = real_random();
    struct shade h = {.refraction = {1, 1, 1}, .point = v3_of(point), .viewer = v3_of(viewer), .ep = some_size(20, 40)};
    struct refraction f = {.straight = 1};

    h.ev = some_size(4, 30);
    one->rays.weight[0] = 1;
    push_refracted(&one->work, &h, 1, &one->rays, &f);
    if (one->work.queue.count != 1)
        return;
    viewer = real_along(real_of(h.viewer), off, h.ev * WITHIN);
    point = real_along(real_of(h.point), off, -h.ep * WITHIN);
    struct real start = real_along(point, viewer, -(long double)one->scene.bias);
    use(u, real_gap(start, (struct v3){FIRST(0), FIRST(1), FIRST(2)}), FIRST(9));
}

/* Tests the straight rays of a path, which start less far behind the point. */
static void try_pass(struct used *u)
{
    static const struct sure_scene scene = {.bias = P2M(26)};
    static const struct media none[LANES];
    static struct sure_gather gather = {.scene = &scene};
    static struct path_state f = {.gather = &gather};
    struct real point = real_random(), viewer = real_random(), off = real_random();
    struct shade h = {.point = v3_of(point), .viewer = v3_of(viewer), .ep = some_size(20, 40)};
    struct paths p = {.specular = 0}, next;
    const double *n = f.ray[0].number;

    h.ev = some_size(4, 30);
    p.r.p.d = v3_neg(h.viewer);
    p.r.weight[0] = 1;
    next = p;
    pass_straight(&f, 1, &p, &next, &h, none);
    CHECK_EQ(path_pop(&f, &p), 1);
    viewer = real_along(real_of(h.viewer), off, h.ev * WITHIN);
    point = real_along(real_of(h.point), off, -h.ep * WITHIN);
    use(u, real_gap(real_along(point, viewer, -(long double)scene.bias), (struct v3){n[0], n[1], n[2]}), n[9]);
}

TEST(bounces)
{
    struct used directions = {.name = "refracted direction"}, parts = {.name = "Fresnel's part"},
                totals = {.name = "total reflection"}, through = {.name = "throughput of refracted rays"},
                back = {.name = "throughput of reflected rays"}, straight = {.name = "origin of rays straight on"},
                passed = {.name = "origin of paths straight on"};

    for (int i = 0; i < 3 * TRIES; i++) {
        try_refraction(&directions, &parts, &totals);
        try_spawned(&through, &back);
        try_straight(&straight);
        try_pass(&passed);
    }
    check_used(&directions);
    check_used(&parts);
    check_used(&totals);
    check_used(&through);
    check_used(&back);
    check_used(&straight);
    check_used(&passed);
}

int main(void)
{
    (void)trace;
    (void)occlude;
    (void)walk_paths;
    float_mode_of_simd();
    RUN(surfaces);
    RUN(colours);
    RUN(bounces);
    return check_status();
}
