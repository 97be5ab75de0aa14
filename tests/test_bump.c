/* Bumps: pictures of N.V from above against gradients by the formulas, and what holds for every normal. */
#include <math.h>

#include "check.h"
#include "common/corpus/corpus_rays.h"
#include "oracle/rays.h"
#include "reading.h"
#include "red_picture.h"
#include "simd_frames_all.h"

#define SIZE 48
#define PIXELS (SIZE * SIZE)

#define ABOVE "camera orthographic eye 0.5 5 -0.5 look 0.5 0 -0.5 up 0 0 -1 window -0.5 0.5 -0.5 0.5\n"
#define FLOOR "\nmaterial m facing 1 bump t\nplane normal 0 1 0 material m\n"

static const struct tia_texture *replacement; /* of the scene's first texture */

/* Draws a scene; `red` receives each pixel's red, 0..1. */
static void draw(const struct tia_core *core, const char *text, double red[PIXELS])
{
    struct reading r;

    read_string(&r, TIA_FORMAT_TIA, text);
    CHECK_MSG(r.status == TIA_OK, "%u: %s", (unsigned)r.reader.error.line, r.reader.error.text);
    if (replacement)
        r.scene.textures = replacement;
    if (r.status)
        abort();
    red_picture(core, &r.scene, SIZE, SIZE, red);
    read_end(&r);
}

/* Returns N.V of the height h(x, z) over the plane, seen from above; slopes are taken over `step`. */
static double cosine(double (*height)(double x, double z), double x, double z, double step)
{
    double dx = (height(x + step, z) - height(x - step, z)) / (2 * step);
    double dz = (height(x, z + step) - height(x, z - step)) / (2 * step);

    return 1 / sqrt(1 + dx * dx + dz * dz);
}

static void check_heights(const char *text, double (*height)(double x, double z), double step, double near)
{
    static double red[PIXELS];
    static const struct tia_core *const cores[] = {&tia_core_q16, &tia_core_f64};
    double least = 1;

    for (int k = 0; k < 2; k++) {
        draw(cores[k], text, red);
        for (int i = 0; i < PIXELS; i++) {
            double x = (i % SIZE + 0.5) / SIZE, z = (i / SIZE + 0.5) / SIZE - 1;
            double want = cosine(height, x, z, step);
            CHECK_MSG(fabs(red[i] - want) < near, "pixel %d: %.5f, not %.5f", i, red[i], want);
            least = fmin(least, want);
        }
    }
    CHECK_MSG(least < 0.95, "the least is %g", least);
}

static struct tia_texture noise;

static double noise_height(double x, double z)
{
    return 0.125 * oracle_noise(&noise, (struct oracle_vec){x, 0, z});
}

TEST(noise_from_above)
{
    noise = (struct tia_texture){.repeat = {TIA_Q16(4), TIA_Q16(4)}, .octaves = 1};
    check_heights(ABOVE "texture t noise repeat 4 octaves 1 depth 0.125" FLOOR, noise_height, 1e-4, 1e-3);
    noise.octaves = 3;
    check_heights(ABOVE "texture t noise repeat 4 octaves 3 depth 0.125" FLOOR, noise_height, 1e-4, 2e-3);
}

static double between(double a, double b, double part)
{
    return a + part * (b - a);
}

static const uint8_t heights[3 * 16] = {0,   0,   0,   30,  60,  90, 250, 250, 250, 9,  9,   9,   1,  1,  1,  200,
                                        200, 200, 90,  90,  90,  40, 10,  10,  77,  77, 77,  5,   5,  5,  99, 99,
                                        99,  128, 128, 128, 255, 0,  0,   12,  12,  12, 180, 180, 10, 60, 60, 60};

/* The mean of three channels of a texel, counted from the lower left; the image repeats. */
static double texel(int x, int y)
{
    const uint8_t *p = heights + 3 * (4 * (3 - (y & 3)) + (x & 3));

    return (p[0] + p[1] + p[2]) / 765.0;
}

static double image_height(double x, double z)
{
    double u = 4 * x - 0.5, v = -4 * z - 0.5;
    int i = (int)floor(u), j = (int)floor(v);

    return 0.25 * between(between(texel(i, j), texel(i + 1, j), u - i),
                          between(texel(i, j + 1), texel(i + 1, j + 1), u - i), v - j);
}

/* Slopes of an image are differences over two texels. */
TEST(images_from_above)
{
    const struct tia_texture image = {.kind = TIA_IMAGE,
                                      .repeat = {TIA_Q16_ONE, TIA_Q16_ONE},
                                      .width = 4,
                                      .height = 4,
                                      .texels = heights,
                                      .depth = TIA_Q16(0.25)};

    replacement = &image;
    check_heights(ABOVE "texture t checker" FLOOR, image_height, 0.25, 2e-4);
    replacement = NULL;
}

/* Returns the square wave's mean over 1/8, by its cells. */
static double wave(double x)
{
    double part = x - floor(x), edge = fmin(part, 1 - part);

    return fmin(1, 16 * edge) * (fmod(floor(x), 2) == 0 ? 1 : -1);
}

static double checker_height(double x, double z)
{
    return 0.0625 * (1 - wave(4 * x) * wave(-4 * z)) / 2;
}

TEST(checkers_from_above)
{
    check_heights(ABOVE "texture t checker repeat 4 depth 0.0625" FLOOR, checker_height, 1.0 / 64, 2e-4);
}

/* A bump whose depth is negated is a dent: lit from the left, it looks like the bump lit from the right. */
TEST(light_falls_on_slopes)
{
    static double bump[PIXELS], dent[PIXELS];
    static const char format[] =
        "camera orthographic eye 0.5 5 -0.5 look 0.5 0 -0.5 up 0 0 -1 window -0.5 0.5 -0.5 0.5\n"
        "texture t noise repeat 4 octaves 2 depth %s\n"
        "material m colour 1 bump t\nplane normal 0 1 0 material m\n"
        "light directional direction %s emission 0.9\n";
    char text[600];

    (void)snprintf(text, sizeof text, format, "0.1", "1 -2 0.5");
    draw(&tia_core_q16, text, bump);
    (void)snprintf(text, sizeof text, format, "-0.1", "-1 -2 -0.5");
    draw(&tia_core_q16, text, dent);
    for (int i = 0; i < PIXELS; i++)
        CHECK_MSG(fabs(bump[i] - dent[i]) < 1e-4, "pixel %d: %g, %g", i, bump[i], dent[i]);
}

/* However deep the bump, the normal stays on the seen side, at least 1/64 before it is normalised, and the sphere's
 * outline keeps it. */
TEST(normals_are_seen)
{
    static double red[PIXELS];
    static const char *const textures[] = {"noise octaves 8 repeat 30", "checker repeat 8", "noise octaves 1"};
    char text[400];

    for (size_t k = 0; k < 3; k++) {
        (void)snprintf(text, sizeof text,
                       "camera eye 0 0 4 look 0 0 0 fov 28\ntexture t %s depth 50\nmaterial m facing 1 bump t\n"
                       "sphere centre 0 0 0 radius 1.5 material m\n",
                       textures[k]);
        draw(&tia_core_q16, text, red);
        for (int i = 0; i < PIXELS; i++)
            CHECK_MSG(red[i] > 1.0 / 80, "%s, pixel %d: %g", textures[k], i, red[i]);
    }
}

/* Where u goes from 1 to 0, a noise and a checker of 8 cells go on. */
TEST(no_seam)
{
    static double seam[PIXELS], opposite[PIXELS];
    char text[400];

    for (int side = 0; side < 2; side++) {
        (void)snprintf(text, sizeof text,
                       "camera eye %d 0 0 look 0 0 0 fov 20\ntexture t checker repeat 8 depth 0.05\n"
                       "material m facing 1 bump t\nsphere centre 0 0 0 radius 1.5 material m\n",
                       side ? 8 : -8);
        draw(&tia_core_q16, text, side ? opposite : seam);
    }
    for (int i = 0; i < PIXELS; i++)
        CHECK_MSG(fabs(seam[i] - opposite[i]) < 1e-3, "pixel %d: %g, %g", i, seam[i], opposite[i]);
}

TEST(vector_units_draw_the_same)
{
    for (unsigned i = 0; i < 6; i++) {
        static struct corpus_rays c;
        corpus_random_rays(&c, 5, i);
        corpus_add_noise(&c, i);
        if (i % 2)
            corpus_add_opacity(&c, i);
        corpus_add_bumps(&c, i);
        simd_frames_check_all(&c.scene, 40, 30, i);
    }
}

int main(void)
{
    RUN(noise_from_above);
    RUN(images_from_above);
    RUN(checkers_from_above);
    RUN(light_falls_on_slopes);
    RUN(normals_are_seen);
    RUN(no_seam);
    RUN(vector_units_draw_the_same);
    return check_status();
}
