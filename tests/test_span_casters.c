/* The casters of spheres: those that are left out block no light by the formulas of docs/definition.md, in 64 bits of
 * precision, and pictures are the same with all spheres as casters.
 *
 *     test_span_casters [N]    N scenes of each kind, by default 300 */
#include "check.h"

#include <math.h>
#include <tia/debug.h>
#include <tia/simd.h>

#include "random.h"
#include "render/span/span.h"

#define SPHERES 80
#define LIGHTS 70
enum { W = 97, H = 41 };

typedef long double real;

static struct tia_material materials[4];
static struct tia_sphere spheres[SPHERES];
static struct tia_light lights[LIGHTS];
static struct tia_scene scene;
static unsigned scenes = 300;

/* ---- scenes ---- */

static int32_t below(int32_t most)
{
    return (int32_t)(random_u32() % (uint32_t)most);
}

/* Returns a number from 2^least to 2^most in last bits, of any magnitude alike. */
static int32_t size(int least, int most)
{
    return (int32_t)exp2(least + (most - least) * fabs(random_double()));
}

static struct tia_vec3 near(const struct tia_vec3 *p, int32_t reach)
{
    int32_t x = below(2 * reach) - reach, y = below(2 * reach) - reach, z = below(2 * reach) - reach;
    return (struct tia_vec3){p->x + x, p->y + y, p->z + z};
}

static void begin(uint32_t sphere_count, uint32_t light_count, bool tinted)
{
    static const struct tia_rgb white = TIA_RGB(.9, .9, .9);

    for (int i = 0; i < 4; i++)
        materials[i] = (struct tia_material){.colour = {TIA_Q30(.3) + i * TIA_Q30(.2), TIA_Q30(.8), TIA_Q30(.5)}};
    materials[1].transmission = tinted ? (struct tia_rgb)TIA_RGB(.5, .7, .2) : (struct tia_rgb)TIA_RGB(0, 0, 0);
    materials[2].colour = white;
    scene = (struct tia_scene){.materials = materials,
                               .spheres = spheres,
                               .lights = lights,
                               .material_count = 4,
                               .sphere_count = sphere_count,
                               .light_count = light_count,
                               .background = TIA_RGB(.2, .3, .4)};
    scene.camera.fov = TIA_Q16(20) + below(TIA_Q16(70));
    for (uint32_t l = 0; l < light_count; l++)
        lights[l] = (struct tia_light){.radius = 0, .emission = TIA_RGB(.4, .4, .3)};
}

/* A ground with balls, a few of them large or tiny, and lights among them; in some scenes in balls. */
static void crowd(uint32_t sphere_count, uint32_t light_count, bool tinted)
{
    const struct tia_vec3 middle = {0, TIA_Q16(1), TIA_Q16(-20)};

    begin(sphere_count, light_count, tinted);
    spheres[0] = (struct tia_sphere){{0, TIA_Q16(-1002), TIA_Q16(-20)}, TIA_Q16(1000), 0};
    for (uint32_t i = 1; i < sphere_count; i++) {
        int32_t radius = i % 16 ? size(12, 17) : size(6, 19);
        spheres[i] = (struct tia_sphere){near(&middle, TIA_Q16(8)), radius, i % 4};
    }
    for (uint32_t l = 0; l < light_count; l++)
        lights[l].centre = l % 5 == 4 ? near(&spheres[1 + l % (sphere_count - 1)].centre, TIA_Q16(1))
                                      : near(&middle, l % 2 ? TIA_Q16(12) : TIA_Q16(40));
}

/* Spheres of any magnitude that touch the cone of the first sphere and the first light, from either side by a few last
 * bits, at any place along it. */
static void tangents(void)
{
    const struct tia_vec3 far = {0, 0, -size(14, 28)};
    int32_t reach = size(8, 27), radius = size(7, 26);

    begin(12, 1, false);
    spheres[0] = (struct tia_sphere){near(&far, reach), radius, 0};
    lights[0].centre = near(&spheres[0].centre, reach);
    const struct tia_vec3 *l = &spheres[0].centre, *q = &lights[0].centre;
    real g[3] = {q->x - l->x, q->y - l->y, q->z - l->z}, length = sqrtl(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
    for (uint32_t i = 1; i < 12; i++) {
        real s = fabsl(random_real()) * (i % 3 ? 1 : 1.5L) - (i % 3 ? 0 : .25L), side[3], dot = 0, square = 0;
        int32_t own = size(6, 24);
        for (int k = 0; k < 3; k++)
            dot += (side[k] = random_real()) * g[k];
        for (int k = 0; k < 3; k++)
            side[k] -= dot * g[k] / (length * length), square += side[k] * side[k];
        /* the cone's surface is (1 - s) r sin(a) from the axis, along it by as much */
        real sine = fminl(1, radius / length), away = (1 - s) * radius + own + (real)(below(64) - 32);
        away = i % 2 ? away * sqrtl(1 - sine * sine * .999L) + 8 : away;
        spheres[i].centre = (struct tia_vec3){(int32_t)(l->x + s * g[0] + side[0] / sqrtl(square) * away),
                                              (int32_t)(l->y + s * g[1] + side[1] / sqrtl(square) * away),
                                              (int32_t)(l->z + s * g[2] + side[2] / sqrtl(square) * away)};
        spheres[i].radius = own;
        spheres[i].material = i % 4;
    }
}

/* ---- the definition ---- */

struct point {
    real x, y, z;
};

static struct point plus(struct point a, real s, struct point b)
{
    return (struct point){a.x + s * b.x, a.y + s * b.y, a.z + s * b.z};
}

static real dot(struct point a, struct point b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static struct point unit(struct point a)
{
    return plus((struct point){0, 0, 0}, 1 / sqrtl(dot(a, a)), a);
}

static struct point place(struct tia_vec3 p)
{
    const struct tia_vec3 *eye = &scene.camera.eye;
    return (struct point){(real)p.x - eye->x, (real)p.y - eye->y, (real)p.z - eye->z};
}

/* True if sphere j blocks light l at the point L + r n of sphere i, which faces the light. All lengths are in last
 * bits, where the bias is 8. */
static bool blocks(uint32_t i, uint32_t l, uint32_t j, struct point n)
{
    struct point centre = place(spheres[i].centre), light = place(lights[l].centre), other = place(spheres[j].centre);
    real r = spheres[i].radius, big = spheres[j].radius, inside = dot(centre, centre) < r * r ? -1 : 1;
    struct point p = plus(centre, r, n), w = plus(light, -1, p), out = plus(other, -1, light);
    if (inside * dot(n, w) <= 0)
        return false;
    struct point a = plus(plus(other, -1, p), -8 * inside, n);
    real toward = dot(a, w), square = dot(w, w);
    /* |A|^2 - (A.w)^2/|w|^2 from the part of A across w, without cancellation */
    struct point across = plus(a, -toward / square, w);
    return toward > 0 && dot(across, across) <= big * big && (dot(out, out) <= big * big || square > toward);
}

/* Tries points of sphere i in the plane of the light and sphere j, where it is nearest to being a caster, or of all of
 * the sphere; returns true if it blocks at one of them. */
static bool blocks_somewhere(uint32_t i, uint32_t l, uint32_t j)
{
    struct point centre = place(spheres[i].centre), d = plus(place(spheres[j].centre), -1, centre);
    struct point g = plus(place(lights[l].centre), -1, centre);

    if (dot(d, d) == 0 || dot(g, g) == 0)
        return false;
    struct point x = unit(g), y = plus(d, -dot(d, x), x);
    if (dot(y, y) == 0)
        return false;
    y = unit(y);
    for (int k = 0; k < 48; k++) {
        real angle = k * 3.14159265358979L / 24;
        if (blocks(i, l, j, plus(plus(x, cosl(angle) - 1, x), sinl(angle), y)))
            return true;
    }
    for (int k = 0; k < 16; k++)
        if (blocks(i, l, j, unit((struct point){random_real(), random_real(), random_real()})))
            return true;
    return false;
}

/* ---- lists ---- */

static uint64_t view_memory[16000], all_memory[16000];
static unsigned long left_out, kept, kept_in_vain;

static struct tia_view *open_view(uint64_t *memory, size_t bytes)
{
    struct tia_view *view;

    if (tia_scene_check(&scene, NULL))
        return NULL;
    CHECK(tia_view_size(&scene, scene.light_count) <= bytes);
    CHECK_EQ(tia_view_init(&view, memory, bytes, &scene, scene.light_count, W, H, NULL), TIA_OK);
    return view;
}

static void try_lists(const char *what, unsigned number)
{
    const struct tia_view *view = open_view(view_memory, sizeof view_memory);

    for (uint32_t i = 0; view && i < scene.sphere_count; i++)
        for (uint32_t l = 0; l < scene.light_count; l++)
            for (uint32_t j = 0; j < scene.sphere_count; j++) {
                const struct span_lit lit = {.casters = &span_view_of(view)->casters, .object = i};
                bool listed = span_next_caster(&lit, l, j) == j;
                if (span_view_of(view)->spheres[j].c < 0) {
                    CHECK_MSG(listed, "%s %u: %u, around the eye, is left out of %u, %u", what, number, j, i, l);
                    continue;
                }
                bool blocking = i != j && blocks_somewhere(i, l, j);
                CHECK_MSG(listed || !blocking, "%s %u: %u blocks light %u of %u", what, number, j, l, i);
                CHECK(!listed || i != j);
                left_out += !listed;
                kept += listed;
                kept_in_vain += listed && !blocking;
            }
}

/* Of the casters that touch the cone, as many are left out as kept, more or less. */
TEST(what_is_left_out_blocks_nothing)
{
    random_state = 1;
    left_out = kept = kept_in_vain = 0;
    for (unsigned i = 0; i < check_count(scenes); i++) {
        tangents();
        try_lists("tangents", i);
    }
    CHECK_MSG(left_out > kept, "%lu left out, %lu kept, %lu of them in vain", left_out, kept, kept_in_vain);
}

/* In a crowd few casters are kept in vain. */
TEST(crowds)
{
    random_state = 2;
    left_out = kept = kept_in_vain = 0;
    for (unsigned i = 0; i < check_count(scenes) / 12; i++) {
        crowd(20 + i % 9, 1 + i % 4, i & 1);
        scene.camera.eye = i % 3 ? (struct tia_vec3){0, 0, 0} : spheres[3].centre;
        try_lists("crowd", i);
    }
    CHECK_MSG(left_out > 4 * kept && kept_in_vain < left_out / 8, "%lu left out, %lu kept, %lu of them in vain",
              left_out, kept, kept_in_vain);
}

/* Points in a ball: spheres that are passed over block the light at none of them. A sphere of the scene takes the place
 * of the points' ball: it lies in that, up to a last bit. */
TEST(points_in_a_ball)
{
    unsigned long passed = 0;

    random_state = 3;
    for (unsigned i = 0; i < check_count(scenes); i++) {
        crowd(12, 2, false);
        const struct tia_view *view = open_view(view_memory, sizeof view_memory);
        for (uint32_t n = 1; view && n < 12; n++) {
            struct span_lit lit = {.casters = &span_view_of(view)->casters, .object = 0, .surrounded = true};
            lit.around = span_view_of(view)->casters.coarse[n];
            for (uint32_t j = 0; j < 12; j++) {
                struct span_lit whole = {.casters = &span_view_of(view)->casters, .object = 0};
                bool listed = span_next_caster(&whole, 1, j) == j, tried = span_next_caster(&lit, 1, j) == j;
                CHECK(!tried || listed);
                if (!listed || tried || n == j)
                    continue;
                passed++;
                CHECK_MSG(!blocks_somewhere(n, 1, j), "%u: %u blocks the light at %u", i, j, n);
            }
        }
    }
    CHECK(passed > check_count(scenes) * 8ul);
}

/* ---- pictures ---- */

static tia_rgb565 want[W * H], got[W * H];
static uint32_t want_paths[W * H], got_paths[W * H];
static uint64_t hits_memory[W * H + 64];

static void draw(struct tia_view *view, tia_rgb565 *pixels, uint32_t *paths)
{
    const struct tia_tile tile = {0, 0, W, H};
    const struct tia_surface surface = {pixels, sizeof *pixels, W * sizeof *pixels};
    const struct tia_options options = {.debug = &(struct tia_debug){.path_hash = paths}};
    struct tia_hits *hits;

    CHECK_EQ(tia_hits_init(&hits, hits_memory, sizeof hits_memory, view, tile), TIA_OK);
    CHECK_EQ(tia_view_draw(view, hits, tile, &surface, paths ? &options : NULL), TIA_OK);
}

/* Puts all spheres into all lists, except for those seen from outside into their own. */
static void list_all(const struct tia_view *view)
{
    const struct span_view *spans = span_view_of(view);
    uint32_t count = scene.sphere_count, bytes = (count + 7) / 8;
    uint32_t rows = scene.light_count < CASTER_ROWS ? scene.light_count : CASTER_ROWS;

    memset(spans->casters.lists, 0xff, (size_t)(count * rows * bytes));
    for (uint32_t i = 0; i < count * rows; i++) {
        uint8_t *list = spans->casters.lists + i * bytes;
        list[bytes - 1] = (uint8_t)(0xffu >> (8 * bytes - count));
        if (spans->spheres[i / rows].c >= 0)
            list[i / rows / 8] &= (uint8_t) ~(1u << (i / rows & 7));
    }
}

/* Compares some pixels with exact ones, for which all spheres are tried. */
static void try_exact_pixels(const struct tia_view *view, const char *what, unsigned number)
{
    enum { STEP = 31, COUNT = W * H / STEP };
    struct tia_exact exact[COUNT];
    uint32_t first = number % STEP;

    CHECK_EQ(tia_view_exact(view, first, STEP, COUNT, false, exact), TIA_OK);
    for (uint32_t i = 0; i < COUNT; i++)
        CHECK_MSG(got[first + i * STEP] == exact[i].colour, "%s %u, pixel %u", what, number, first + i * STEP);
}

static void try_picture(const char *what, unsigned number)
{
    static uint64_t simd_memory[1 << 22];
    struct tia_view *view = open_view(view_memory, sizeof view_memory), *all = open_view(all_memory, sizeof all_memory);
    bool paths = number % 2;

    if (!view || !all)
        return;
    list_all(all);
    draw(all, want, paths ? want_paths : NULL);
    draw(view, got, paths ? got_paths : NULL);
    CHECK_MSG(!memcmp(got, want, sizeof got), "%s %u", what, number);
    CHECK_MSG(!paths || !memcmp(got_paths, want_paths, sizeof got_paths), "%s %u: paths", what, number);
    try_exact_pixels(view, what, number);
    const struct tia_simd *simd = tia_simd_best();
    CHECK_EQ(tia_view_set_simd(view, simd, simd_memory, sizeof simd_memory), TIA_OK);
    draw(view, got, NULL);
    CHECK_MSG(!memcmp(got, want, sizeof got), "%s %u, %s", what, number, tia_view_simd(view));
}

/* All spheres as casters, or those of the lists; with more lights than lists, and more than the vector units take. */
TEST(pictures)
{
    random_state = 4;
    for (unsigned i = 0; i < check_count(scenes) / 4; i++) {
        static const uint32_t lamps[] = {1, 2, 4, 5, 12};
        uint32_t count = i % 25 == 24 ? LIGHTS : lamps[i % 5];
        crowd(i % 10 == 9 ? SPHERES : 8 + i % 23, count, i % 3 == 0);
        scene.camera.eye = i % 7 ? scene.camera.eye : spheres[2].centre;
        try_picture("crowd", i);
        tangents();
        scene.camera.eye.z = spheres[0].centre.z + 2 * spheres[0].radius;
        try_picture("tangents", i);
    }
}

int main(int argc, char **argv)
{
    scenes = (unsigned)check_number(argc, argv, 1, scenes);
    RUN(what_is_left_out_blocks_nothing);
    RUN(crowds);
    RUN(points_in_a_ball);
    RUN(pictures);
    return check_status();
}
