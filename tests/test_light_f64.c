/* Samples in fixed point and in double precision: the same paths, and the same sums. */
#include "light_scene.h"

#ifdef TIA_HAVE_F64
enum { SIDE = 64, ROUNDS = 16 };

/* Draws one sample of each pixel, and its path. */
static void draw(const struct tia_core *core, const struct tia_estimator *estimator, struct tia_sum sums[SIDE * SIDE],
                 uint32_t hashes[SIDE * SIDE])
{
    static tia_rgb565 pixels[SIDE * SIDE];
    struct world_view v = world_open(core, estimator, SIDE, SIDE);

    memset(sums, 0, SIDE * SIDE * sizeof *sums);
    CHECK_EQ(estimator->sample(v.view, (struct tia_tile){0, 0, SIDE, SIDE}, 0, 1, sums, SIDE), TIA_OK);
    world_draw(core, &v, SIDE, SIDE, pixels, hashes);
    world_close(&v);
}

/* Compares the samples: at least 99.99 % of the paths, and of the samples at 2^-24, are the same. */
static void compare(void)
{
    static struct tia_sum sums[2][SIDE * SIDE];
    static uint32_t hashes[2][SIDE * SIDE];
    unsigned paths = 0, samples = 0, all = ROUNDS * SIDE * SIDE;

    world.integration.spp = 1;
    for (uint32_t seed = 0; seed < ROUNDS; seed++) {
        world.integration.seed = seed;
        draw(&tia_core_q16, &tia_estimator_q16, sums[0], hashes[0]);
        draw(&tia_core_f64, &tia_estimator_f64, sums[1], hashes[1]);
        for (int i = 0; i < SIDE * SIDE; i++) {
            paths += hashes[0][i] != hashes[1][i];
            samples += memcmp(&sums[0][i], &sums[1][i], sizeof sums[0][i]) != 0;
        }
    }
    printf("# of %u: %u paths and %u samples differ\n", all, paths, samples);
    CHECK_MSG(paths <= all / 10000, "%u paths", paths);
    CHECK_MSG(samples <= all / 10000, "%u samples", samples);
}
#endif

TEST(paths_are_those_of_double)
{
#ifdef TIA_HAVE_F64
    world_room();
    compare();
#else
    SKIP("built without f64");
#endif
}

TEST(occlusion_is_that_of_double)
{
#ifdef TIA_HAVE_F64
    world_room();
    world.integration.integrator = TIA_OCCLUSION;
    world.integration.distance = TIA_Q16(0.75);
    compare();
#else
    SKIP("built without f64");
#endif
}

int main(void)
{
    RUN_LONG(paths_are_those_of_double);
    RUN(occlusion_is_that_of_double);
    return check_status();
}
