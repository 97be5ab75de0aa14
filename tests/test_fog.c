/* Fog: the share that passes it against numerical integration, and pictures against the oracle, by each arithmetic and
 * by the vector units. */
#include "check.h"
#include "common/corpus/corpus_rays.h"
#include "random.h"
#include "render/trace/fog.h"
#include "simd_frames_all.h"

#include <math.h>

#ifdef TIA_HAVE_F64
#include "against_scenes.h"
#endif

static double density(const struct tia_fog *fog, long double h)
{
    long double u = h * 65536 / fog->height;

    return fog->height == 0 || h <= 0 ? 1 : (double)(1 / (1 + u * u));
}

/* Integrates the density from height h on along a way `t`, by Gauss's rule of two points for each of many parts. */
static long double part_integral(const struct tia_fog *fog, long double h, long double slope, long double t)
{
    const int parts = 1000;
    const long double aside = sqrtl(3) / 6;
    long double sum = 0;

    for (int i = 0; i < parts; i++)
        sum += density(fog, h + slope * t * (i + 0.5L - aside) / parts) +
               density(fog, h + slope * t * (i + 0.5L + aside) / parts);
    return sum * t / parts / 2;
}

/* Integrates in two parts if the ray crosses the level, where the density bends. */
static long double integral(const struct tia_fog *fog, long double h, long double slope, long double t)
{
    long double crossing = slope != 0 && -h / slope > 0 && -h / slope < t ? -h / slope : t;

    return part_integral(fog, h, slope, crossing) + part_integral(fog, h + slope * crossing, slope, t - crossing);
}

static tia_q16 some_length(double least, double most)
{
    return (tia_q16)(65536 * least * pow(most / least, fabs(random_double())));
}

static struct tia_fog some_fog(int i)
{
    return (struct tia_fog){.distance = some_length(0.001, 30000),
                            .height = i % 4 ? some_length(i % 3 ? 0.1 : 0.001, 30000) : 0,
                            .level = (tia_q16)(65536 * 10 * random_double())};
}

/* The rule is exact to 1e-9 where the density bends little between its points, so the ray rises by at most a hundred
 * heights. */
TEST(shares_are_integrals)
{
    double worst = 0;

    for (int i = 0; i < 2000; i++) {
        const struct tia_fog fog = some_fog(i);
        struct ray ray = {.origin = {0, num_length_of((tia_q16)(65536 * 20 * random_double())), 0}};
        double y = i % 5 ? random_double() : random_double() / 4096, t = some_length(0.01, 30000) / 65536.0;
        t = fog.height && fabs(y) * t > fog.height / 655.36 ? fog.height / 655.36 / fabs(y) : t;
        ray.direction = (struct num_dir){0, (num_unit)(y * 0x1p62), 0};
        struct hit hit = {.t = (num_length)(t * 0x1p45), .light = TIA_NO_OBJECT};
        long double h = ray.origin.y / 0x1p45L - fog.level / 65536.0L;
        double want =
            (double)expl(-integral(&fog, h, ray.direction.y / 0x1p62L, hit.t / 0x1p45L) * 65536 / fog.distance);
        double off = fabs((double)(ray_fog_share(&fog, &ray, &hit) / 0x1p62L) - want);
        worst = off > worst ? off : worst;
        CHECK_MSG(off < 1e-7, "fog %d: %g off from %g", i, off, want);
    }
    printf("# the largest error of a share is %g\n", worst);
}

static double endless(const struct tia_fog *fog, double h, num_unit y)
{
    struct ray ray = {.origin = {0, (num_length)(h * 0x1p45) + num_length_of(fog->level), 0}, .direction = {0, y, 0}};
    struct hit none = {.t = NUM_LENGTH_MAX, .object = TIA_NO_OBJECT, .light = TIA_NO_OBJECT};

    return (double)(ray_fog_share(fog, &ray, &none) / 0x1p62L);
}

/* The integral of 1/(1 + u^2) from 0 to infinity is pi/2, from 1 on pi/4. */
TEST(rays_without_an_end)
{
    const struct tia_fog even = {.distance = TIA_Q16(3)}, ground = {.distance = TIA_Q16(3), .height = TIA_Q16(2)};
    const double half_pi = acos(0);

    CHECK(endless(&even, 5, NUM_UNIT_ONE) == 0 && endless(&ground, 5, 0) == 0 && endless(&ground, 5, -1) == 0);
    CHECK(fabs(endless(&ground, 0, NUM_UNIT_ONE) - exp(-half_pi * 2 / 3)) < 1e-12);
    CHECK(fabs(endless(&ground, 2, NUM_UNIT_ONE / 2) - exp(-half_pi * 2 / 3)) < 1e-12);
    CHECK(fabs(endless(&ground, -1, NUM_UNIT_ONE) - exp(-(half_pi * 2 + 1) / 3)) < 1e-12);
}

/* The largest lengths that a ray has, and the least heights: nothing overflows, the share is in 0..1. */
TEST(extreme_lengths)
{
    static const tia_q16 lengths[] = {64, 65536, INT32_MAX};
    static const num_unit slopes[] = {-NUM_UNIT_ONE, -1, 0, 1, NUM_UNIT_ONE};

    for (unsigned i = 0; i < 3 * 3 * 5 * 2 * 3; i++) {
        const struct tia_fog fog = {
            .distance = lengths[i % 3], .height = lengths[i / 3 % 3], .level = i / 45 % 2 ? INT32_MAX : INT32_MIN};
        struct ray ray = {.origin = {0, ((int)(i / 90) - 1) * NUM_LENGTH_FAR, 0},
                          .direction = {0, slopes[i / 9 % 5], 0}};
        struct hit hit = {.t = i % 2 ? NUM_LENGTH_MAX : NUM_LENGTH_LEAST, .light = TIA_NO_OBJECT};
        num_unit share = ray_fog_share(&fog, &ray, &hit);
        CHECK_MSG(share >= 0 && share <= NUM_UNIT_ONE, "case %u", i);
    }
}

TEST(vector_units_draw_the_same)
{
    for (unsigned i = 0; i < 4; i++) {
        struct corpus_rays c;
        corpus_random_rays(&c, 5, i);
        corpus_add_fog(&c, i);
        simd_frames_check_all(&c.scene, 40, 30, i);
    }
}

#ifdef TIA_HAVE_F64
TEST(pictures_are_those_of_the_oracle)
{
    against_scenes(&tia_core_f64, 4, 48, 36, corpus_add_fog, 1e-4, 99.99);
    against_scenes(&tia_core_q16, 4, 48, 36, corpus_add_fog, 1e-2, 99.9);
}
#endif

int main(void)
{
    RUN(shares_are_integrals);
    RUN(rays_without_an_end);
    RUN(extreme_lengths);
    RUN(vector_units_draw_the_same);
#ifdef TIA_HAVE_F64
    RUN(pictures_are_those_of_the_oracle);
#endif
    return check_status();
}
