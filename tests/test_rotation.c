/* Sine, cosine and rotations against long double. */
#include "math/rotation.h"

#include <math.h>

#include "check.h"
#include "random.h"

#define ONE (INT64_C(1) << 62)
#define RIGHT (90 * 65536)

static const long double pi = 3.14159265358979323846264338327950288L;

static tia_q16 any_angle(void)
{
    return (tia_q16)random_u32();
}

/* Returns the absolute error of got/ONE. */
static long double error(int64_t got, long double want)
{
    return fabsl((long double)got / ONE - want);
}

/* Compares sine and cosine with those of an angle that is reduced exactly; long double may have too few bits to judge
 * 2^-59. */
static void check_angle(tia_q16 degrees)
{
    long double radians = (long double)(degrees % (4 * RIGHT)) / 65536 * (pi / 180);
    const long double bound = ldexpl(1, sizeof(long double) > 8 ? -59 : -49);
    int64_t s, c;

    tia_sincos(degrees, &s, &c);
    CHECK_MSG(error(s, sinl(radians)) < bound, "sin of %d/65536", (int)degrees);
    CHECK_MSG(error(c, cosl(radians)) < bound, "cos of %d/65536", (int)degrees);
}

TEST(sine_and_cosine)
{
    for (int i = 0; i < 200000; i++)
        check_angle(any_angle());
    for (int32_t near = -16; near <= 16; near++)
        for (int32_t eighth = -700; eighth <= 700; eighth++)
            check_angle(eighth * (RIGHT / 2) + near);
    check_angle(INT32_MAX);
    check_angle(INT32_MIN);
}

TEST(right_angles_are_exact)
{
    for (int32_t turns = -364; turns <= 364; turns++) {
        int64_t s, c;
        const int64_t sines[4] = {0, ONE, 0, -ONE};

        tia_sincos(turns * RIGHT, &s, &c);
        CHECK_EQ(s, sines[turns & 3]);
        CHECK_EQ(c, sines[(turns + 1) & 3]);
    }
}

TEST(symmetry)
{
    for (int i = 0; i < 100000; i++) {
        tia_q16 x = any_angle() / 2;
        int64_t s, c, s2, c2;

        tia_sincos(x, &s, &c);
        tia_sincos(-x, &s2, &c2);
        CHECK(s2 == -s && c2 == c);
        tia_sincos(RIGHT - x, &s2, &c2);
        CHECK(s2 == c && c2 == s);
        tia_sincos(x + RIGHT, &s2, &c2);
        CHECK(s2 == c && c2 == -s);
    }
}

/* Rotates the vector about one axis after the other. */
static void turn(long double v[3], const tia_q16 angle[3])
{
    for (int axis = 0; axis < 3; axis++) {
        long double a = (long double)(angle[axis] % (4 * RIGHT)) / 65536 * (pi / 180);
        long double *y = &v[(axis + 1) % 3], *z = &v[(axis + 2) % 3], y0 = *y;
        *y = cosl(a) * y0 - sinl(a) * *z;
        *z = sinl(a) * y0 + cosl(a) * *z;
    }
}

TEST(axes)
{
    const long double bound = ldexpl(1, sizeof(long double) > 8 ? -57 : -48);

    for (int n = 0; n < 20000; n++) {
        const tia_q16 angle[3] = {any_angle(), any_angle(), any_angle()};
        int64_t axes[3][3];

        tia_rotation_axes((struct tia_vec3){angle[0], angle[1], angle[2]}, axes);
        for (int i = 0; i < 3; i++) {
            long double v[3] = {i == 0, i == 1, i == 2};
            turn(v, angle);
            for (int k = 0; k < 3; k++)
                CHECK_MSG(error(axes[i][k], v[k]) < bound, "axis %d, component %d", i, k);
        }
    }
}

/* A quarter turn about x takes y to z; then one about z takes x to y. */
TEST(axes_by_hand)
{
    const int64_t want[3][3] = {{0, ONE, 0}, {0, 0, ONE}, {ONE, 0, 0}};
    int64_t axes[3][3];

    tia_rotation_axes((struct tia_vec3){RIGHT, 0, RIGHT}, axes);
    CHECK(!memcmp(axes, want, sizeof want));
    tia_rotation_axes((struct tia_vec3){0, 0, 0}, axes);
    for (int i = 0; i < 9; i++)
        CHECK_EQ(axes[i / 3][i % 3], i % 4 ? 0 : ONE);
}

static void check_angles(struct tia_vec3 rotation)
{
    const long double unit = pi / 180 / 65536;
    int64_t axes[3][3], again[3][3];
    struct tia_vec3 found;

    tia_rotation_axes(rotation, axes);
    tia_rotation_angles((const int64_t(*)[3])axes, &found);
    tia_rotation_axes(found, again);
    /* half a unit from each angle, and an eighth more at the poles, where two angles merge */
    for (int i = 0; i < 9; i++)
        CHECK_MSG(error(again[i / 3][i % 3], (long double)axes[i / 3][i % 3] / ONE) < 1.625L * unit,
                  "%d %d %d: %d %d %d", (int)rotation.x, (int)rotation.y, (int)rotation.z, (int)found.x, (int)found.y,
                  (int)found.z);
    CHECK(found.y >= -RIGHT && found.y <= RIGHT);
}

/* Axes are random, or closer and closer to where the angle about y is a right one. */
TEST(angles_of_axes)
{
    for (int i = 0; i < 20000; i++) {
        tia_q16 near = (i % 2 ? RIGHT : -RIGHT) + any_angle() % (2 << i % 20);
        check_angles((struct tia_vec3){any_angle(), i % 4 < 2 ? any_angle() : near, any_angle()});
    }
    for (int i = 0; i < 64; i++)
        check_angles((struct tia_vec3){i % 4 * RIGHT, i / 4 % 4 * RIGHT, i / 16 * RIGHT});
}

TEST(angles_by_hand)
{
    const struct tia_vec3 rotation = {20 * 65536 + 1, -70 * 65536 - 3, 170 * 65536 + 7};
    int64_t axes[3][3];
    struct tia_vec3 found;

    tia_rotation_axes(rotation, axes);
    tia_rotation_angles((const int64_t(*)[3])axes, &found);
    CHECK(!memcmp(&found, &rotation, sizeof found));
    tia_rotation_axes((struct tia_vec3){0, RIGHT, 0}, axes);
    tia_rotation_angles((const int64_t(*)[3])axes, &found);
    CHECK(found.x == 0 && found.y == RIGHT && found.z == 0);
}

int main(void)
{
    RUN(sine_and_cosine);
    RUN(right_angles_are_exact);
    RUN(symmetry);
    RUN(axes);
    RUN(axes_by_hand);
    RUN(angles_of_axes);
    RUN(angles_by_hand);
    return check_status();
}
