/* Data gathered beside sums: guides, and squares for the standard error. */
#include "light_scene.h"
#include "random.h"

/* Included after light_scene.h, whose functions have parameters of the same names. */
#include "gathered.h"

static void gather(const struct tia_estimator *estimator, const struct tia_core *core, uint32_t first, uint32_t end,
                   const struct tia_gathered *to)
{
    struct world_view v = world_open(core, estimator, WIDE, HIGH);

    CHECK_EQ(v.estimator->gather(v.view, whole, first, end, to), TIA_OK);
    world_close(&v);
}

static void forget(void)
{
    memset(sums, 0, sizeof sums);
    memset(guides, 0, sizeof guides);
    memset(squares, 0, sizeof squares);
}

TEST(gathering_changes_no_sums_and_joins)
{
    static struct tia_guide once[PIXELS];
    static uint64_t squares_once[PIXELS];

    world_room();
    forget();
    gather(&tia_estimator_q16, &tia_core_q16, 0, 5, &all);
    gather(&tia_estimator_q16, &tia_core_q16, 5, 8, &all);
    memset(got, 0, sizeof got);
    struct world_view v = world_open(&tia_core_q16, &tia_estimator_q16, WIDE, HIGH);
    CHECK_EQ(v.estimator->sample(v.view, whole, 0, 8, got, WIDE), TIA_OK);
    world_close(&v);
    CHECK(!memcmp(sums, got, sizeof got));
    memset(got, 0, sizeof got);
    gather(&tia_estimator_q16, &tia_core_q16, 0, 8, &(struct tia_gathered){got, once, squares_once, WIDE});
    CHECK(!memcmp(guides, once, sizeof once) && !memcmp(squares, squares_once, sizeof squares));
}

/* Checks the middle pixel's guides, means of 4 samples: z of the normal, the depth and the albedo. In a mirror, they
 * are those of the mirrored surface, with the length of the whole path and the product of both colours. */
static void check_guide(double z, double depth, double albedo)
{
    const struct tia_guide *g = &guides[PIXELS / 2];

    forget();
    gather(&tia_estimator_q16, &tia_core_q16, 0, 4, &all);
    CHECK(fabs((double)g->normal[2] / ONE / 4 - z) < 1e-6 && llabs(g->normal[0]) < 64);
    CHECK(fabs((double)g->depth / 65536 / 4 - depth) < 1e-3);
    for (int c = 0; c < 3; c++)
        CHECK(fabs((double)g->albedo[c] / ONE / 4 - albedo) < 1e-6);
}

static void look_down(void)
{
    world_begin(TIA_PATHS);
    world_plane(0, 0, 0, 0, 0, 1);
    world.camera.eye.z = TIA_Q16(3);
    world.camera.window = (struct tia_window){-65, 65, -65, 65, 0};
}

TEST(guides_are_what_is_seen)
{
    look_down();
    check_guide(1, 3, 0.5);
    world.integration.integrator = TIA_OCCLUSION;
    check_guide(1, 3, 1);
    look_down();
    world_materials[1].mirror = GREY(0.5);
    world_shapes[0].material = 1;
    world_plane(0, 0, 5, 0, 0, -1);
    check_guide(-1, 8, 0.25);
    look_down();
    world_materials[0].emission = GREY(0.25);
    world_materials[0].mirror = GREY(0.125);
    check_guide(1, 3, 0.875);
    look_down();
    world.shape_count = 0;
    world.background = GREY(0.75);
    check_guide(0, 0, 0.75);
    look_down();
    struct tia_light *lamp = world_light(TIA_DISC_LIGHT, 0, 0, 1);
    lamp->radius = TIA_Q16(0.5);
    lamp->emission_bits = 2;
    check_guide(1, 2, 4);
}

TEST(guides_of_double_are_the_same)
{
#ifdef TIA_HAVE_F64
    static struct tia_guide real[PIXELS];
    static uint64_t squares_real[PIXELS];
    unsigned differ = 0;

    world_room();
    forget();
    memset(got, 0, sizeof got);
    gather(&tia_estimator_q16, &tia_core_q16, 0, 4, &all);
    gather(&tia_estimator_f64, &tia_core_f64, 0, 4, &(struct tia_gathered){got, real, squares_real, WIDE});
    for (int i = 0; i < PIXELS; i++)
        for (int c = 0; c < 3; c++)
            differ += llabs(guides[i].normal[c] - real[i].normal[c]) > 8 ||
                      llabs(guides[i].albedo[c] - real[i].albedo[c]) > 8 || llabs(guides[i].depth - real[i].depth) > 8;
    CHECK_MSG(differ == 0, "%u differ", differ);
#else
    SKIP("built without f64");
#endif
}

/* With independent random numbers the spread of the means is the size that the standard error must have. */
TEST(standard_errors_are_those_of_means)
{
    double spread = 0, told = 0, mean = 0;
    enum { ROUNDS = 4000 };

    for (int round = 0; round < ROUNDS; round++) {
        struct tia_sum sum = {{0, 0, 0}};
        uint64_t square = 0;
        for (int i = 0; i < COUNT; i++) {
            int64_t light = (int64_t)(random_bits() >> 38); /* in 0..4 */
            for (int c = 0; c < 3; c++)
                sum.rgb[c] += light;
            square += (uint64_t)(light * light) >> 16;
        }
        double is = (double)sum.rgb[1] / ONE / COUNT;
        mean += is;
        spread += is * is;
        told += pow(tia_standard_error(&sum, square, COUNT) / 65536.0, 2);
    }
    mean /= ROUNDS;
    spread = spread / ROUNDS - mean * mean;
    told /= ROUNDS;
    CHECK_MSG(fabs(told / spread - 1) < 0.1, "variance %f, not %f", told, spread);
    const struct tia_sum one = {{1 << 24, 1 << 24, 1 << 24}};
    CHECK_EQ(tia_standard_error(&one, (uint64_t)1 << 32, 1), 65536);
    const struct tia_sum same = {{3 << 24, 3 << 24, 3 << 24}};
    CHECK_EQ(tia_standard_error(&same, (uint64_t)3 << 32, 3), 0);
}

int main(void)
{
    RUN(gathering_changes_no_sums_and_joins);
    RUN(guides_are_what_is_seen);
    RUN(guides_of_double_are_the_same);
    RUN(standard_errors_are_those_of_means);
    return check_status();
}
