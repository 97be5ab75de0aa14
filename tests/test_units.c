/* A scene in metres, decimetres, centimetres, millimetres and kilometres gives the same picture, by every renderer. */
#include "random.h"
#include "scaled.h"

/* A street: the ground is unbounded, so there is a horizon; no length is exact in any of the units. */
#define STREET                                                                                                         \
    "background 0.5 0.7 1\nmaterial grey colour 0.5\nmaterial red colour 0.8 0.2 0.1\ntexture bricks checker odd "     \
    "0.25 "                                                                                                            \
    "scale 0.25\nmaterial brick colour 0.75 0.5 0.25 texture bricks\nmaterial mirror colour 0.2 mirror 0.5\n"          \
    "plane point @0 @0 @0 normal 0 1 0 material grey\n"                                                                \
    "box min @-1.1 @0 @-1.1 max @1.1 @2.3 @1.1 rotate 0 30 0 at @-0.9 @0 @-1.3 material brick\n"                       \
    "sphere centre @2.3 @0.9 @-1.7 radius @0.9 material mirror\n"                                                      \
    "cone base @0.3 @0 @1.7 top @0.3 @1.1 @1.9 radii @0.4 @0.1 capped material red\n"                                  \
    "triangle a @-4.3 @0.1 @-5.1 b @4.7 @0.1 @-7.3 c @0.2 @4.9 @-6.1 material red\n"
#define LAMP "light at @4.1 @6.3 @5.2 emission 0.8\nlight directional direction 2 -3 -1 emission 0.3\n"
#define FADES "light at @4.1 @6.3 @5.2 attenuation 0.5 ~0.043 ^0.0017\n"
#define FRUSTUM "camera frustum eye @0.1 @1.6 @8.3 look @0 @1.6 @0 window @-0.53 @0.61 @-0.37 @0.41 near @0.9\n"
#define ORTHOGRAPHIC "camera orthographic eye @0.1 @3.6 @8.3 look @0 @1.1 @0 window @-5.3 @5.1 @-3.9 @3.7\n"
#define PERSPECTIVE "camera eye @0.1 @1.6 @8.3 look @0 @1.6 @0 fov 40\n"

static const char *const cameras[] = {PERSPECTIVE, FRUSTUM, ORTHOGRAPHIC};
static const char *const renderers[] = {"",
                                        "shadows rays\n",
                                        "shadows zpass\n",
                                        "shadows zfail tessellated @0.013\n",
                                        "shadows map size 256\n",
                                        "shadows map size 256 bias constant @0.03125 filter pcss\n",
                                        "shadows map-exact\n",
                                        "integrator ao @3.3\nspp 4\n",
                                        "integrator path\nspp 4\n"};

/* Draws the text's scene in a unit into `pixels`. Returns the number of pixels that are equal to the old ones; gives
 * the scene's scale_bits. */
static unsigned drawn(const char *text, double scale, tia_rgb565 *pixels, int *scale_bits)
{
    struct reading r;
    unsigned same = 0;

    read_scaled(&r, text, scale, "");
    tia_rgb565 *own = malloc(WIDTH * HEIGHT * sizeof *own);
    *scale_bits = r.scene.scale_bits;
    if (!r.status)
        draw(&r, own);
    for (unsigned i = 0; !r.status && i < WIDTH * HEIGHT; i++)
        same += own[i] == pixels[i];
    memcpy(pixels, own, r.status ? 0 : WIDTH * HEIGHT * sizeof *own);
    free(own);
    read_end(&r);
    return same;
}

/* Checks the picture in a unit against that in metres. Lengths are rounded to 2^-18 m or less. So a point 5 m away,
 * with 65 pixels to a metre there, moves by 2^-12 of a pixel: of some 1000 pixels at edges of objects, bricks and
 * shadows, less than one changes. A path may pass three such edges. */
static void check_unit(const char *text, double scale, int apart)
{
    static tia_rgb565 pixels[WIDTH * HEIGHT];
    int metres, bits;

    (void)drawn(text, 1, pixels, &metres);
    unsigned same = drawn(text, scale, pixels, &bits);
    CHECK_MSG(same + 3 >= WIDTH * HEIGHT, "%u pixels differ in units of 1/%g m, with 2^%d, not 2^%d: %s",
              WIDTH * HEIGHT - same, scale, bits, metres, text);
    CHECK_MSG(bits == metres - apart || apart == 99, "2^%d and 2^%d in units of 1/%g m", metres, bits, scale);
    CHECK_MSG(same == WIDTH * HEIGHT || apart == 99, "%u pixels differ by a power of two: %s", WIDTH * HEIGHT - same,
              text);
}

static void check_units(const char *text)
{
    static const double decimal[] = {10, 100, 1000, 0.001};

    for (unsigned i = 0; i < sizeof decimal / sizeof *decimal; i++)
        check_unit(text, decimal[i], 99);
    check_unit(text, 1 / 64.0, -6);
    check_unit(text, 8, 3);
    check_unit(text, 512, 9);
}

TEST(five_units_are_the_same_picture)
{
    char text[4000];

    for (unsigned c = 0; c < sizeof cameras / sizeof *cameras; c++)
        for (unsigned i = 0; i < sizeof renderers / sizeof *renderers; i++) {
            if (check_is_quick() && (c + i) % 2) /* make check-quick: every second one */
                continue;
            (void)snprintf(text, sizeof text, "%s%s" STREET LAMP, cameras[c], renderers[i]);
            if (!strstr(renderers[i], "constant")) {
                check_units(text);
            } else { /* with a small bias, rounded lengths decide self-shadowing */
                check_unit(text, 8, 3);
                check_unit(text, 1 / 4096.0, -12);
            }
        }
}

/* Scenes of more than 32768 mm, and planes seen from a great height. */
TEST(large_scenes_in_small_units)
{
    check_units("camera eye @0.3 @41.7 @90.1 look @0 @20.3 @0 fov 40\n" STREET LAMP);
    check_units("camera eye @0.3 @1.7 @9.1 look @0 @1.3 @0 fov 40\n" STREET LAMP
                "sphere centre @10.3 @200.7 @-900.1 radius @90.3 material red\n");
    check_units("camera eye @0.3 @900.7 @9000.1 look @0 @100.3 @0 fov 10\n" STREET LAMP
                "box min @-300 @0 @-500 max @700 @800 @900 material brick\n");
}

/* Planes with textures of squares; the planes end before the horizon, where squares would be finer than pixels. */
TEST(textures_on_planes)
{
    static const char *const given[] = {"scale @1.7 @0.9 offset @0.37 @-1.3", "repeat ~0.31",
                                        "repeat ~2.3 ~0.7 offset @31.7 @0", "scale @0.013"};
    char text[2000];

    for (unsigned i = 0; i < sizeof given / sizeof *given; i++) {
        (void)snprintf(text, sizeof text,
                       "camera eye @0.1 @%s look @0 @0 @0 fov 40\ntexture tiles checker even 0.9 odd 0.3 %s\n"
                       "material floor colour 1 texture tiles\nlight at @4.1 @6.3 @5.2 emission 0.8\n"
                       "plane point @0.2 @0 @0 normal 0.1 1 0 material floor\n",
                       i == 3 ? "0.2 @0.05" : "6.6 @1.3", given[i]);
        check_units(text);
    }
}

/* Attenuations are read with at least 11 significant bits. */
TEST(lights_that_fade)
{
    static const double scales[] = {10, 100, 1000, 0.001, 0.125, 512};

    for (unsigned i = 0; i < sizeof scales / sizeof *scales; i++)
        check_unit(PERSPECTIVE STREET FADES, scales[i], 99);
}

static double random_between(double low, double high)
{
    return low + (high - low) * (random_u32() / 4294967296.0);
}

/* Writes random boxes, balls and lights over a ground, seen from random heights. */
static void random_text(char *text)
{
    char *to = text;

    to += sprintf(to, "camera eye @%.3f @%.3f @%.3f look @0 @%.3f @0 fov %d\n", random_between(-9, 9),
                  random_between(0.5, 30), random_between(8, 40), random_between(0, 2), 20 + (int)(random_u32() % 50));
    to += sprintf(to,
                  "background 0.5 0.7 1\nmaterial a colour 0.8 0.2 0.1\nmaterial b colour 0.4 mirror 0.4\n%s"
                  "plane point @0 @0 @0 normal 0 1 0 material a\n",
                  renderers[random_u32() % 5]);
    for (unsigned i = 0, count = 1 + random_u32() % 6; i < count; i++) {
        double x = random_between(-6, 6), z = random_between(-20, 5), size = random_between(0.3, 2);
        to += random_u32() % 2
                  ? sprintf(to, "sphere centre @%.3f @%.3f @%.3f radius @%.3f material b\n", x, size, z, size)
                  : sprintf(to, "box min @%.3f @0 @%.3f max @%.3f @%.3f @%.3f material a\n", x, z, x + size, size + 0.5,
                            z + size);
    }
    (void)sprintf(to, "light at @%.3f @%.3f @%.3f\n", random_between(-9, 9), random_between(3, 20),
                  random_between(2, 9));
}

TEST(random_scenes_in_other_units)
{
    static const double scales[] = {10, 100, 1000, 0.001};

    for (unsigned i = 0; i < check_count(60); i++) {
        char text[4000];
        random_text(text);
        check_unit(text, scales[i % 4], 99);
    }
}

int main(void)
{
    RUN_LONG(five_units_are_the_same_picture);
    RUN(large_scenes_in_small_units);
    RUN(textures_on_planes);
    RUN(lights_that_fade);
    RUN(random_scenes_in_other_units);
    return check_status();
}
