/* How rounding errors grow from mirror to mirror: chains of rays among mirroring balls in fixed point, in single and in
 * double precision, against the same chains in 113 bits. Each mirror costs 2 to 3 bits in every arithmetic, so
 * that double precision, whose coordinates here are multiples of 2^-50, stays some 2^5 times as exact as fixed point.
 *
 *     test_mirrors [SCENES [SEED]]    default 4 and 1
 *     test_mirrors FILE...            of scenes in files, as if all their objects were mirrors
 *     test_mirrors hits SCENE         prints a scene and its chains in 113 and 53 bits, for tests/quick/mirrors
 */
#include "check.h"

#ifdef TIA_HAVE_F128
#include <math.h>
#include <tia/debug.h>

#include "common/corpus/dice.h"
#include "common/scene/scene_load.h"
#include "mirrors/mirrors.h"

enum { BALLS = 40, SIDE = 96, HITS = 6, LENGTH_BITS = 45, MOST = 1 << 19, ARITHMETICS = 3 };

/* The arithmetics that are compared, and after them the reference. */
static const struct arithmetic {
    const struct tia_core *core;
    mirror_chain *follow;
} arithmetics[ARITHMETICS + 1] = {{&tia_core_q16, mirror_chain_q16},
                                  {&tia_core_f64, mirror_chain_f64},
                                  {&tia_core_f32, mirror_chain_f32},
                                  {&tia_core_f128, mirror_chain_f128}};

static unsigned scene_count = 4;
static uint64_t seed = 1;

struct mirrors {
    struct tia_scene scene;
    struct tia_sphere balls[BALLS];
};

static const struct tia_material silver = {.mirror = TIA_RGB(0.9, 0.9, 0.9)};

static bool is_apart(const struct tia_sphere *a, const struct tia_sphere *b)
{
    int64_t x = (int64_t)a->centre.x - b->centre.x, y = (int64_t)a->centre.y - b->centre.y,
            z = (int64_t)a->centre.z - b->centre.z, r = (int64_t)a->radius + b->radius + TIA_Q16(1.0 / 64);

    return x * x + y * y + z * z > r * r;
}

static bool fits(const struct mirrors *m, const struct tia_sphere *ball)
{
    for (uint32_t i = 0; i < m->scene.sphere_count; i++)
        if (!is_apart(&m->balls[i], ball))
            return false;
    return true;
}

/* Fills a scene: balls of radii from 1/2 to 2, apart from each other, in a cube of side 12 before the eye. */
static void make_mirrors(struct mirrors *m, uint64_t number)
{
    static const struct tia_vec3 low = TIA_VEC3(-6, -6, -15), high = TIA_VEC3(6, 6, -3);
    uint64_t dice = number * 1000003 + 7;

    *m = (struct mirrors){.scene = {.materials = &silver, .material_count = 1, .camera.fov = TIA_Q16(90)}};
    m->scene.spheres = m->balls;
    while (m->scene.sphere_count < BALLS) {
        struct tia_sphere ball = {.centre = dice_vec3(&dice, low, high)};
        ball.radius = dice_between(&dice, TIA_Q16(0.5), TIA_Q16(2));
        if (fits(m, &ball))
            m->balls[m->scene.sphere_count++] = ball;
    }
}

struct views {
    struct tia_view *view[ARITHMETICS + 1];
    void *memory[ARITHMETICS + 1];
};

static void make_views(struct views *v, const struct tia_scene *scene)
{
    const uint32_t lights = scene->light_count;

    for (unsigned i = 0; i <= ARITHMETICS; i++) {
        const struct tia_core *core = arithmetics[i].core;
        size_t size = core->view_size(core, scene, lights);
        v->memory[i] = malloc(size);
        if (!v->memory[i] || core->view_init(core, &v->view[i], v->memory[i], size, scene, lights, SIDE, SIDE, NULL))
            exit(1);
    }
}

static void free_views(struct views *v)
{
    for (unsigned i = 0; i <= ARITHMETICS; i++)
        free(v->memory[i]);
}

/* The distances from the reference's points, as binary logarithms of units of fixed point. */
struct errors {
    unsigned count[HITS], strays[HITS]; /* a stray meets another ball than the reference, or none */
    float log[HITS][MOST];
};

static struct errors errors[ARITHMETICS];

static double distance(const struct mirror_hit *a, const struct mirror_hit *b)
{
    double x = (double)(a->at[0] - b->at[0]), y = (double)(a->at[1] - b->at[1]), z = (double)(a->at[2] - b->at[2]);

    return ldexp(sqrt(x * x + y * y + z * z), LENGTH_BITS);
}

static void add_chain(struct errors *e, const struct mirror_hit want[], unsigned count, const struct mirror_hit got[],
                      unsigned got_count)
{
    for (unsigned i = 0; i < count; i++) {
        if (i >= got_count || got[i].object != want[i].object) {
            e->strays[i]++;
            return;
        }
        if (e->count[i] < MOST)
            e->log[i][e->count[i]++] = (float)log2(fmax(distance(&want[i], &got[i]), 0x1p-99));
    }
}

static void measure(const struct tia_scene *scene)
{
    struct views v;
    struct mirror_hit want[HITS], got[HITS];

    make_views(&v, scene);
    for (int i = 0; i < SIDE * SIDE; i++) {
        const int x = i % SIDE, y = i / SIDE;
        const unsigned count = mirror_chain_f128(v.view[ARITHMETICS], x, y, HITS, want);
        for (unsigned k = 0; k < ARITHMETICS; k++)
            add_chain(&errors[k], want, count, got, arithmetics[k].follow(v.view[k], x, y, HITS, got));
    }
    free_views(&v);
}

static int ascending(const void *a, const void *b)
{
    const float x = *(const float *)a, y = *(const float *)b;

    return (x > y) - (x < y);
}

static double part_of(const struct errors *e, unsigned hit, double part)
{
    return e->count[hit] ? (double)e->log[hit][(unsigned)(part * (e->count[hit] - 1))] : -99;
}

static void report(void)
{
    printf("# binary logarithm of a hit's distance from that of f128, in units of 2^-%d\n", LENGTH_BITS);
    printf("#      reflections    hits  median    90 %%  largest  strays\n");
    for (unsigned k = 0; k < ARITHMETICS; k++)
        for (unsigned i = 0; i < HITS; i++) {
            qsort(errors[k].log[i], errors[k].count[i], sizeof errors[k].log[i][0], ascending);
            printf("# %-4s %11u %7u %7.1f %7.1f %8.1f %7u\n", arithmetics[k].core->name, i, errors[k].count[i],
                   part_of(&errors[k], i, 0.5), part_of(&errors[k], i, 0.9), part_of(&errors[k], i, 1),
                   errors[k].strays[i]);
        }
}

/* Upper bounds of the medians without a reflection, as logarithms. Each reflection adds at most 3. */
static const double nearest[ARITHMETICS] = {0.5, -3.5, 25.5};

TEST(errors_grow_from_mirror_to_mirror)
{
    static struct mirrors m;

    for (unsigned i = 0; i < scene_count; i++) {
        make_mirrors(&m, seed + i);
        measure(&m.scene);
    }
    report();
    for (unsigned i = 0; i < HITS; i++)
        for (unsigned k = 0; k < ARITHMETICS; k++) {
            double median = part_of(&errors[k], i, 0.5), most = nearest[k] + 3 * i;
            CHECK_MSG(median < most && median > most - 4 - i, "%s: 2^%g after %u reflections, not some 2^%g",
                      arithmetics[k].core->name, median, i, most);
        }
}

static int measure_files(int count, char **paths)
{
    struct scene_file file;

    for (int i = 0; i < count; i++) {
        if (scene_open(&file, paths[i], scene_format_of(paths[i]), false)) {
            (void)fprintf(stderr, "test_mirrors: %s\n", file.why);
            return 1;
        }
        measure(&file.scene);
        scene_close(&file);
    }
    report();
    return 0;
}

static void print_real(mirror_real x)
{
    const mirror_real size = (x < 0 ? -x : x) * 1125899906842624;
    const uint64_t high = (uint64_t)size;

    printf(" %s%" PRIx64 "%014" PRIx64, x < 0 ? "-" : "", high,
           (uint64_t)((size - (mirror_real)high) * (mirror_real)(UINT64_C(1) << 56)));
}

static void print_chain(const struct tia_view *view, const struct arithmetic *a, int x, int y)
{
    struct mirror_hit hits[HITS];
    const unsigned count = a->follow(view, x, y, HITS, hits);

    printf("%s %d %d", a->core->name, x, y);
    for (unsigned i = 0; i < count; i++) {
        printf(" %" PRIu32, hits[i].object);
        for (int c = 0; c < 3; c++)
            print_real(hits[i].at[c]);
    }
    printf("\n");
}

/* Prints the balls in Q16.16, and then the chains: the arithmetic, the pixel, and for each hit the ball and the point,
 * in hexadecimal units of 2^-106. */
static int print_hits(uint64_t number)
{
    static struct mirrors m;
    struct views v;

    make_mirrors(&m, number);
    make_views(&v, &m.scene);
    printf("size %d bits 106\n", SIDE);
    for (unsigned i = 0; i < BALLS; i++)
        printf("ball %" PRId32 " %" PRId32 " %" PRId32 " %" PRId32 "\n", m.balls[i].centre.x, m.balls[i].centre.y,
               m.balls[i].centre.z, m.balls[i].radius);
    for (int i = 0; i < SIDE * SIDE; i += 5) {
        print_chain(v.view[1], &arithmetics[1], i % SIDE, i / SIDE);
        print_chain(v.view[ARITHMETICS], &arithmetics[ARITHMETICS], i % SIDE, i / SIDE);
    }
    free_views(&v);
    return 0;
}

int main(int argc, char **argv)
{
    if (argc == 3 && strcmp(argv[1], "hits") == 0)
        return print_hits(strtoull(argv[2], NULL, 10));
    if (argc > 1 && strchr(argv[1], '.'))
        return measure_files(argc - 1, argv + 1);
    scene_count = (unsigned)check_number(argc, argv, 1, scene_count);
    seed = check_number(argc, argv, 2, seed);
    RUN(errors_grow_from_mirror_to_mirror);
    return check_status();
}
#else
TEST(chains_of_mirrors)
{
    SKIP("built without f128");
}

int main(void)
{
    RUN(chains_of_mirrors);
    return check_status();
}
#endif
