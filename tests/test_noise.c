/* Noise textures: values known from the formula, its range and mean, and pictures against the oracle, by each
 * arithmetic and by the vector units. */
#include "against_scenes.h"
#include "check.h"
#include "common/corpus/corpus_rays.h"
#include "oracle/rays.h"
#include "random.h"
#include "render/trace/noise.h"
#include "simd_frames_all.h"

#define HALF 0x1p44 /* Q18.45 */

static struct noise_place place_of(struct oracle_vec p)
{
    return (struct noise_place){{(int32_t)((int64_t)floor(p.x) & INT32_MAX), (int32_t)((int64_t)floor(p.y) & INT32_MAX),
                                 (int32_t)((int64_t)floor(p.z) & INT32_MAX)},
                                {(num_length)((p.x - floor(p.x)) * 2 * HALF),
                                 (num_length)((p.y - floor(p.y)) * 2 * HALF),
                                 (num_length)((p.z - floor(p.z)) * 2 * HALF)}};
}

static struct oracle_vec some_point(double size)
{
    return (struct oracle_vec){size * random_double(), size * random_double(), size * random_double()};
}

/* At integer points every octave is 0. */
TEST(corners)
{
    for (int i = 0; i < 1000; i++) {
        struct oracle_vec p = some_point(1000);
        p = (struct oracle_vec){floor(p.x), floor(p.y), floor(p.z)};
        const struct noise_place at = place_of(p);
        CHECK_EQ(noise_value(&at, 1 + (unsigned)i % TIA_OCTAVES_MAX, 0), NUM_LENGTH_ONE / 2);
    }
}

TEST(values_are_those_of_the_oracle)
{
    double worst = 0;

    for (int i = 0; i < 20000; i++) {
        struct tia_texture t = {.repeat = {TIA_Q16_ONE, TIA_Q16_ONE}, .octaves = (uint8_t)(1 + i % TIA_OCTAVES_MAX)};
        const struct oracle_vec p = some_point(i % 3 ? 4 : 30000);
        const struct noise_place at = place_of(p);
        double off = fabs((double)noise_value(&at, t.octaves, 0) / (2 * HALF) - oracle_noise(&t, p));
        worst = off > worst ? off : worst;
    }
    printf("# the largest error of a value is %g\n", worst);
    CHECK_MSG(worst < 1e-8, "%g", worst);
}

/* The limits that tia/material.h gives. */
TEST(range_and_mean)
{
    const int n = 400000;
    double sum = 0, squares = 0, most = 0;

    for (int i = 0; i < n; i++) {
        double value = oracle_octave(some_point(30000), (uint32_t)i % TIA_OCTAVES_MAX);
        sum += value;
        squares += value * value;
        most = fmax(most, fabs(value));
    }
    printf("# mean %g, deviation %g, most %g\n", sum / n, sqrt(squares / n), most);
    CHECK(fabs(sum / n) < 2e-3);
    CHECK(most < 1.04);
}

/* The twelve gradients are equally frequent, within four deviations: just beside a corner, the noise is g.d. */
TEST(gradients_are_equally_frequent)
{
    const int n = 12000;
    int count[12] = {0};

    for (int i = 0; i < n; i++) {
        struct oracle_vec c = some_point(1e6), p;
        int found = 0;
        c = (struct oracle_vec){floor(c.x), floor(c.y), floor(c.z)};
        double g[3];
        for (int k = 0; k < 3; k++) {
            p = c;
            *(k == 0 ? &p.x : k == 1 ? &p.y : &p.z) += 0x1p-16;
            const struct noise_place at = place_of(p);
            g[k] = ((double)noise_value(&at, 1, 0) / (2 * HALF) - 0.5) / 0.75 * 0x1p16;
        }
        for (int k = 0; k < 3; k++)
            found = fabs(g[k]) < 0.1 ? 4 * k : found;
        double a = g[found / 4 == 0 ? 1 : 0], b = g[found / 4 == 2 ? 1 : 2];
        CHECK_MSG(fabs(fabs(a) - 1) < 1e-3 && fabs(fabs(b) - 1) < 1e-3, "%g %g %g", g[0], g[1], g[2]);
        count[found + (a < 0) + 2 * (b < 0)]++;
    }
    for (int i = 0; i < 12; i++)
        CHECK_MSG(abs(count[i] - n / 12) < 4 * 31, "gradient %d: %d", i, count[i]);
}

/* Octaves fade from half their unit to all of it; what is left is the mean. */
TEST(wide_octaves_fade)
{
    for (int i = 0; i < 1000; i++) {
        const struct noise_place at = place_of(some_point(100));
        double one = (double)noise_value(&at, 1, 0) - HALF, two = (double)noise_value(&at, 2, 0) - HALF;
        CHECK(noise_value(&at, 8, NUM_LENGTH_ONE) == NUM_LENGTH_ONE / 2);
        CHECK(noise_value(&at, 8, 0) == noise_value(&at, 8, NUM_LENGTH_ONE / 256));
        CHECK(fabs((double)noise_value(&at, 8, NUM_LENGTH_ONE / 2) - HALF - one) < 8);
        CHECK(fabs((double)noise_value(&at, 8, 3 * NUM_LENGTH_ONE / 4) - HALF - one / 2) < 8);
        CHECK(fabs((double)noise_value(&at, 8, 3 * NUM_LENGTH_ONE / 8) - HALF - (one + two) / 2) < 8);
    }
}

TEST(vector_units_draw_the_same)
{
    for (unsigned i = 0; i < check_count(6); i++) {
        static struct corpus_rays c;
        corpus_random_rays(&c, 5, i);
        corpus_add_noise(&c, i);
        simd_frames_check_all(&c.scene, 40, 30, i);
    }
}

#ifdef TIA_HAVE_F64
TEST(pictures_are_those_of_the_oracle)
{
    against_scenes(&tia_core_f64, check_count(12), 48, 36, corpus_add_noise, 1e-4, 99.99);
    against_scenes(&tia_core_q16, check_count(12), 48, 36, corpus_add_noise, 1e-2, 99.9);
}
#endif

int main(void)
{
    RUN(corners);
    RUN(values_are_those_of_the_oracle);
    RUN(range_and_mean);
    RUN(gradients_are_equally_frequent);
    RUN(wide_octaves_fade);
    RUN(vector_units_draw_the_same);
#ifdef TIA_HAVE_F64
    RUN(pictures_are_those_of_the_oracle);
#endif
    return check_status();
}
