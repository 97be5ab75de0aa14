/* Single steps of shadow maps and exact shadow rays in doubles, src/simd/shadow, against the integers: distances at
 * texels of any plane, positions and limits of points on faces, and the sides of points on which casters' planes lie.
 */
#include "simd/isa/one.h"

#include "raster/distance.h"
#include "simd/shadow/kernels_tmpl.h"
#define any any_between /* any() is a template's */
#include "shadow_map_world.h"

enum { RUNS = 20000, WORLDS = 400, POINTS = 60 };

/* ---- distances ---- */

/* Returns a random number below 2^62 with any number of bits. */
static int64_t any_size(void)
{
    return (int64_t)(random_bits() >> (2 + random_bits() % 62));
}

/* A plane whose distances are of any size up to 2^35. */
static struct tia_map_plane some_plane(bool parallel)
{
    struct tia_map_plane p = {.factor = (int64_t)((random_bits() >> 3) | UINT64_C(1) << 61)};
    int64_t f = any_size() / 4 + 1;

    p.x = (random_bits() % 3 ? any_size() : f) / 200 * (random_bits() % 2 ? 1 : -1);
    p.y = any_size() / 300;
    p.c = parallel ? -f : f;
    p.places = (parallel ? 62 + bit_count(f) : 62 - bit_count(f)) - (int)(random_bits() % 36);
    return p;
}

TEST(distances_of_texels)
{
    uint32_t got[64 + LANES], least = 0;

    for (int n = 0; n < RUNS; n++) {
        struct tia_map map = {.parallel = n % 2};
        struct tia_map_plane p = some_plane(map.parallel);
        int i = (int)(random_bits() % 30), count = 1 + (int)(random_bits() % 64);
        keep_run(&map, &p, i, 3, count, got);
        for (int k = 0; k < count; k++) {
            uint32_t want = tia_map_distance(&map, &p, i + k, 3);
            CHECK_MSG(got[k] == want, "run %d: %u at texel %d, not %u", n, got[k], k, want);
            least += want > 0 && want < TIA_MAP_FAR;
        }
    }
    CHECK(least > RUNS);
    CHECK(shadow_kernels.keep && shadow_kernels.light && shadow_kernels.rays);
}

/* A distance halfway between two integers, and those next to it: a double cannot tell them apart. In half of the cases
 * the factor is a little above a power of two and the distance below one, so that the factor's rounding is the largest
 * part of the distance. */
TEST(distances_halfway)
{
    struct tia_map map = {.parallel = false};
    uint32_t got[64 + LANES];

    for (int n = 0; n < 2 * RUNS; n++) {
        bool far = n % 2;
        int64_t d = (INT64_C(1) << 31) + (int64_t)(random_bits() >> (far ? 38 : 33));
        int64_t odd = ((far ? INT64_C(1) << 61 : INT64_C(3) << 60) / d + (int64_t)(random_bits() % 1000)) | 1;
        struct tia_map_plane p = {.c = d << 20, .x = 1, .factor = odd * d + n % 3 - 1, .places = -19};
        keep_run(&map, &p, 0, 0, 16, got); /* plain C computes runs of few texels, and level ones */
        for (int k = 0; k < 16; k++) {
            uint32_t want = tia_map_distance(&map, &p, k, 0);
            CHECK_MSG(got[k] == want, "%lld/%lld: %u, not %u", (long long)p.factor, (long long)p.c, got[k], want);
        }
    }
}

/* ---- positions ---- */

static struct tia_shadow_view view;
static struct tia_map_lighting lighting;
static unsigned long sure, all;

static void check_point(struct spot_map *s, uint32_t face, int x, int y)
{
    int64_t place[3], distance = tia_plane_distance(&w.flat.planes[face], &w.flat.grid, x, y);
    struct tia_map_point want = {.map = &w.map, .world = &w.world};
    const struct lit_face *own = face_of(s, face);
    struct spot_bounds b;

    if (!own->turned || !own->known || !distance)
        return;
    tia_map_face(&want, &w.at, face);
    tia_world_seen(&w.world, x, y, distance, place);
    tia_map_place(&want, &w.look, place);
    find_bounds(s, own, x, y, &b);
    all++;
    sure += b.sure & 1;
    if (!(b.sure & 1))
        return;
    const double u = (double)want.spot.u / 65536, v = (double)want.spot.v / 65536;
    bool beyond = fabs(u) > BEYOND / 2 || fabs(v) > BEYOND / 2;
    CHECK(want.spot.view == &w.map.view[b.view[0]]);
    CHECK_MSG(beyond || (b.u[0][0] <= u && u <= b.u[1][0]), "u %.17g not in %.17g..%.17g", u, b.u[0][0], b.u[1][0]);
    CHECK_MSG(beyond || (b.v[0][0] <= v && v <= b.v[1][0]), "v %.17g not in %.17g..%.17g", v, b.v[0][0], b.v[1][0]);
    uint32_t least = tia_map_least(&w.map, want.limit);
    CHECK_MSG(beyond || (b.least[0][0] <= least && least <= b.least[1][0]), "bias %d: %u not in %lld..%lld",
              (int)w.look.bias, least, (long long)b.least[0][0], (long long)b.least[1][0]);
}

static void make_world(int round)
{
    static const enum tia_light_kind kinds[] = {TIA_POINT_LIGHT, TIA_SPOT_LIGHT, TIA_DIRECTIONAL_LIGHT};

    make_scene(round % 2 ? TIA_ORTHOGRAPHIC : TIA_PERSPECTIVE);
    make_light(kinds[round % 3], any(2, 29));
    make_map(1);
    view = (struct tia_shadow_view){.scene = &w.scene, .flat = w.flat, .sample_count = 1, .samples = {w.at}};
}

TEST(positions_and_limits)
{
    static const enum tia_bias biases[] = {TIA_BIAS_NONE, TIA_BIAS_CONSTANT, TIA_BIAS_SLOPE, TIA_BIAS_NORMAL};
    struct spot_map s;

    sure = all = 0;
    for (int round = 0; round < WORLDS; round++) {
        make_world(round);
        w.look = (struct tia_map_look){SIZE, biases[round / 6 % 4], (int64_t)random_bits() & 0x3ffff, TIA_FILTER_3X3};
        lighting = (struct tia_map_lighting){.view = &view, .look = &w.look, .world = w.world, .point.map = &w.map};
        lighting.world.flat = &view.flat;
        lighting.point.world = &lighting.world;
        open_map(&s, &lighting);
        for (int n = 0; n < POINTS; n++)
            check_point(&s, (uint32_t)(random_bits() % w.flat.face_count), (int)(random_bits() % 80),
                        (int)(random_bits() % 60));
        unmake();
    }
    CHECK_MSG(all > WORLDS && sure * 10 > all * 9, "%lu of %lu are certain", sure, all);
}

/* ---- rays ---- */

/* Compares the doubles of a caster's planes with the sums that the integers' filter forms, in long doubles. */
static void check_sums(const struct shaft_block *b, const struct shaft_caster *c, const struct tia_occluder *o,
                       const struct tia_seen *seen)
{
    long double s = ldexpl((long double)seen->nearness, seen->exponent);

    for (unsigned k = 0; k < c->ready && k < o->ready; k++) {
        const struct tia_occluder_plane *p = &o->plane[k];
        long double form = (long double)p->x * seen->x + (long double)p->y * seen->y + p->c;
        long double want = o->side * (ldexpl(form, p->unit) - ldexpl((long double)p->m, p->m_unit) * s);
        double got = (c->x[k] * b->x0 + (c->y[k] * b->y0 + c->c[k])) - c->m[k] * b->s[0][0];
        CHECK_MSG(fabsl(got - want) <= error_of(b, c, k), "plane %u: %g, not %Lg", k, got, want);
    }
}

/* True if the caster hides the light from a point of the face's plane. */
static bool hides_at(uint32_t caster, uint32_t face, int x, int y, struct tia_occluder *occluder, struct tia_seen *seen)
{
    struct tia_seen_face of;

    tia_seen_face_init(&of, &view.flat, face);
    tia_seen_init(seen, &of, x, y);
    return tia_occluder_init(occluder, &view.flat, &w.at, caster) && tia_occluder_hides(occluder, seen);
}

static void check_side(struct shaft_block *b, uint32_t face, uint32_t caster, unsigned long *open)
{
    const struct shaft_face *own = shaft_face_of(b, face);
    double error[PLANES] = {-1, -1, -1, -1, -1};
    struct tia_occluder occluder;
    struct tia_seen seen;
    unsigned unsure = 0;

    if (!own->turned || !own->known || face == caster)
        return;
    b->sum = 0;
    set_run(b, own, b->y0, b->x0, b->x0 + 1);
    struct shaft_caster *c = caster_of(b, caster);
    bool hidden = hidden_lanes(b, c, error, b->x0, b->y0, 1, &unsure);
    bool want = hides_at(caster, face, b->x0, b->y0, &occluder, &seen);
    check_sums(b, c, &occluder, &seen);
    all++;
    *open += unsure != 0;
    CHECK_MSG(!c->planes ? !want : unsure || hidden == want, "face %u, caster %u", face, caster);
}

static void open_block(struct shaft_block *b, struct tia_shadow_rays *rays)
{
    *rays = (struct tia_shadow_rays){.flat = &view.flat, .light = &w.at};
    *b = (struct shaft_block){.rays = rays, .last = TIA_NO_FACE};
    for (int i = 0; i < TIA_OCCLUDERS; i++)
        rays->occluder[i].face = TIA_NO_FACE;
    for (int i = 0; i < SHAFT_FACES; i++)
        b->caster[i].face = b->face[i].face = TIA_NO_FACE;
}

/* Checks random blocks of up to so many columns and rows, a visible face and a caster. Returns how many are special. */
static unsigned long try_blocks(void (*check)(struct shaft_block *, uint32_t, uint32_t, unsigned long *), int columns,
                                int rows)
{
    unsigned long special = 0;

    all = 0;
    for (int round = 0; round < WORLDS; round++) {
        make_world(round);
        struct tia_shadow_rays rays;
        struct shaft_block b;
        open_block(&b, &rays);
        for (int n = 0; n < POINTS; n++) {
            b.x0 = (int)(random_bits() % 80);
            b.y0 = (int)(random_bits() % 60);
            b.x1 = b.x0 + 1 + (int)(random_bits() % (unsigned)columns);
            b.y1 = b.y0 + 1 + (int)(random_bits() % (unsigned)rows);
            check(&b, (uint32_t)(random_bits() % w.flat.face_count), (uint32_t)(random_bits() % w.flat.face_count),
                  &special);
        }
        unmake();
    }
    return special;
}

TEST(sides_of_casters)
{
    unsigned long open = try_blocks(check_side, 1, 1);

    CHECK_MSG(all > WORLDS && open * 20 < all, "%lu of %lu are open", open, all);
}

/* Checks that a caster that is given up for a block hides the light from none of its corners. */
static void check_block(struct shaft_block *b, uint32_t face, uint32_t caster, unsigned long *given_up)
{
    const struct shaft_face *own = shaft_face_of(b, face);
    double error[PLANES] = {-1, -1, -1, -1, -1};
    struct tia_occluder occluder;
    struct tia_seen seen;

    if (!own->turned || !own->known || face == caster)
        return;
    b->sum = 0;
    b->seen = *own;
    b->only = true;
    for (int y = b->y0; y < b->y1; y++)
        set_run(b, own, y, b->x0, b->x1);
    all++;
    if (!hides_nothing(b, caster_of(b, caster), error))
        return;
    *given_up += 1;
    for (int i = 0; i < 4; i++) {
        int x = i % 2 ? b->x1 - 1 : b->x0, y = i / 2 ? b->y1 - 1 : b->y0;
        CHECK_MSG(!hides_at(caster, face, x, y, &occluder, &seen), "face %u, caster %u, pixel (%d, %d)", face, caster,
                  x, y);
    }
}

TEST(casters_that_hide_nothing)
{
    unsigned long given_up = try_blocks(check_block, SHAFT_COLUMNS, SHAFT_ROWS);

    CHECK_MSG(all > WORLDS && given_up * 2 > all, "%lu of %lu are given up", given_up, all);
}

int main(void)
{
    RUN(distances_of_texels);
    RUN(distances_halfway);
    RUN(positions_and_limits);
    RUN(sides_of_casters);
    RUN(casters_that_hide_nothing);
    return check_status();
}
