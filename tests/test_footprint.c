/* Textures filtered over the footprints of rays. Expected values are sums over the cells that a footprint overlaps, and
 * pictures of 256 samples per pixel in double precision, both computed here. */
#include <math.h>

#include "footprint_draw.h"

#include <tia/mip.h>

#define EVEN 0.875
#define ODD 0.125
#define SKY 0.5

static const struct tia_texture *replacement; /* of the scene's first texture */

#define FLOOR                                                                                                          \
    "background 0.5\ntexture tiles checker even 0.875 odd 0.125\nmaterial floor colour 1 texture tiles\n"              \
    "plane normal 0 1 0 material floor\nlight ambient emission 1\n"

static void draw(const struct tia_core *core, const char *text, double red[PIXELS])
{
    draw_red(core, text, replacement, red);
}

static double cell(double x, double z)
{
    return ((long)floor(x) + (long)floor(z)) % 2 ? ODD : EVEN;
}

static double (*pattern)(double x, double v) = cell; /* what the floor shows at x, v */

/* A camera at (0.25, 1, 0.4), turned to the right by `turn` and down by `tilt`, in degrees, with a field of view of
 * 50. */
struct eye {
    double turn, tilt;
};

/* Returns what the eye sees at a point of the image, -1..1 upwards. */
static double seen(const struct eye *eye, double x, double y)
{
    const double degree = acos(-1) / 180, half = tan(25 * degree);
    const double s = sin(eye->turn * degree), c = cos(eye->turn * degree);
    const double down = sin(eye->tilt * degree), level = cos(eye->tilt * degree);
    const double across = x * half, up = y * half, ahead = level + up * down, rise = up * level - down;

    if (rise >= 0)
        return SKY;
    return pattern(0.25 + (c * across + s * ahead) / -rise,
                   -0.4 - (s * across - c * ahead) / -rise); /* the v axis is -z */
}

/* Draws with n x n samples per pixel. */
static void brute(const struct eye *eye, int n, double red[PIXELS])
{
    for (int i = 0; i < PIXELS; i++) {
        red[i] = 0;
        for (int k = 0; k < n * n; k++) {
            double x = i % WIDTH + (k % n + 0.5) / n, y = i / WIDTH + (k / n + 0.5) / n;
            red[i] += seen(eye, (2 * x - WIDTH) / HEIGHT, (HEIGHT - 2 * y) / HEIGHT) / (n * n);
        }
    }
}

#define APART_TIMES 8

static double (*apart)(double x, double v); /* NULL, or 0 and SKY on two sides of a line that pixels are ignored on */
static bool on_line[PIXELS];                /* pixels on this line */
static const bool *ignored;                 /* NULL, or the pixels that are not compared */

static void mark_line(const struct eye *eye)
{
    static double side[PIXELS];
    double (*shown)(double x, double v) = pattern;

    pattern = apart;
    brute(eye, 16, side);
    pattern = shown;
    for (int i = 0; i < PIXELS; i++)
        on_line[i] = side[i] > 0.001 && side[i] < SKY - 0.001;
}

static double distance(const double a[PIXELS], const double b[PIXELS])
{
    double sum = 0;

    for (int i = 0; i < PIXELS; i++)
        sum += ignored && ignored[i] ? 0 : (a[i] - b[i]) * (a[i] - b[i]);
    return sqrt(sum / PIXELS);
}

static void draw_eye(const struct tia_core *core, const struct eye *eye, const char *more, double red[PIXELS])
{
    const double degree = acos(-1) / 180;
    char text[600];

    (void)snprintf(text, sizeof text, "camera eye 0.25 1 0.4 look %.6f %.6f %.6f fov 50\n" FLOOR "%s",
                   0.25 + 9 * sin(eye->turn * degree) * cos(eye->tilt * degree), 1 - 9 * sin(eye->tilt * degree),
                   0.4 - 9 * cos(eye->turn * degree) * cos(eye->tilt * degree), more);
    draw(core, text, red);
}

static void print_row(const struct eye *eye, double one, double sixteen, double filtered)
{
    (void)printf("| %.0f, %.0f | %.1f | %.1f | %.1f |\n", eye->turn, eye->tilt, one, sixteen, filtered);
}

static double truth[PIXELS], one[PIXELS], sixteen[PIXELS], filtered[PIXELS]; /* pictures of an eye */

/* One sample with footprints is nearer to 256 samples than 16 samples without, if it beats them, and `times` nearer
 * than one sample. */
static void compare(const struct eye *eye, bool prints, double times, bool beats_sixteen)
{
    double near = distance(filtered, truth), far = distance(sixteen, truth), single = distance(one, truth);

    if (prints && getenv("FIGURES"))
        print_row(eye, 255 * single, 255 * far, 255 * near);
    CHECK_MSG(near < far || !beats_sixteen, "eye %g %g: 1 sample with footprints %.5f, 16 without %.5f", eye->turn,
              eye->tilt, near, far);
    CHECK_MSG(single > times * near, "eye %g %g: 1 sample without %.5f", eye->turn, eye->tilt, single);
}

/* Compares pictures of the floor; where two parts are told apart, without the pixels on the line between them, too:
 * then one sample with footprints beats 16, and is APART_TIMES nearer than one. */
static void check_floor(const char *more, double times, bool beats_sixteen)
{
    static const struct eye eyes[] = {{0, 6}, {45, 8}, {30, 20}, {17, -3}};
    static const struct tia_core *const cores[] = {&tia_core_q16, &tia_core_f64};

    for (size_t i = 0; i < sizeof eyes / sizeof *eyes; i++) {
        brute(&eyes[i], 16, truth);
        if (apart)
            mark_line(&eyes[i]);
        for (int k = 0; k < 2; k++) {
            char all[200];
            draw_eye(cores[k], &eyes[i], more, one);
            (void)snprintf(all, sizeof all, "samples 16\n%s", more);
            draw_eye(cores[k], &eyes[i], all, sixteen);
            (void)snprintf(all, sizeof all, "filter footprint\n%s", more);
            draw_eye(cores[k], &eyes[i], all, filtered);
            compare(&eyes[i], k == 0, times, beats_sixteen);
            if (apart) {
                ignored = on_line;
                compare(&eyes[i], k == 0, APART_TIMES, true);
                ignored = NULL;
            }
        }
    }
}

TEST(checkers_to_the_horizon)
{
    check_floor("", 4, true);
}

#define SIDE 16
#define MIRROR 3 /* the mirror's v */

static uint8_t texels[3 * SIDE * SIDE], mip_levels[SIDE * SIDE];

/* Returns the image's texel at x, v, in units of texels a quarter of a unit wide. */
static double nearest(double x, double v)
{
    int i = (int)floor(4 * x) & (SIDE - 1), j = (int)floor(4 * v) & (SIDE - 1);

    return texels[3 * ((SIDE - 1 - j) * SIDE + i)] / 255.0;
}

static double bilinear(double x, double v)
{
    double u = 4 * x - 0.5, w = 4 * v - 0.5, right = u - floor(u), up = w - floor(w);
    double low = nearest(floor(u) / 4, floor(w) / 4) * (1 - right) + nearest(floor(u) / 4 + 0.25, floor(w) / 4) * right;
    double high = nearest(floor(u) / 4, floor(w) / 4 + 0.25) * (1 - right) +
                  nearest(floor(u) / 4 + 0.25, floor(w) / 4 + 0.25) * right;

    return low * (1 - up) + high * up;
}

static double side_of_mirror(double x, double v)
{
    (void)x;
    return v > MIRROR ? SKY : 0;
}

static double mirrored(double x, double v)
{
    return nearest(x, v > MIRROR ? 2 * MIRROR - v : v);
}

/* Draws the floor with an image of texels of any brightness, four per unit. Drawing again without the filter clears
 * `footprint`, as the reader does. */
static void check_image(double (*shown)(double x, double v), bool is_bilinear, const char *more, double times,
                        bool beats_sixteen)
{
    struct tia_texture image = {.kind = TIA_IMAGE,
                                .repeat = {TIA_Q16(0.25), TIA_Q16(0.25)},
                                .bilinear = is_bilinear,
                                .width = SIDE,
                                .height = SIDE,
                                .texels = texels,
                                .mip_levels = mip_levels};

    for (int i = 0; i < SIDE * SIDE; i++)
        texels[3 * i] = texels[3 * i + 1] = texels[3 * i + 2] = (uint8_t)((uint32_t)i * UINT32_C(2654435761) >> 16);
    CHECK(tia_mip_size(&image) <= sizeof mip_levels);
    tia_mip_build(&image, mip_levels);
    pattern = shown;
    replacement = &image;
    check_floor(more, times, beats_sixteen);
    replacement = NULL;
    pattern = cell;
}

TEST(images_to_the_horizon)
{
    check_image(nearest, false, "", 8, true);
    check_image(bilinear, true, "", 7, true);
}

#define IN_A_MIRROR "material glass mirror 1\nplane point 0 0 -3 normal 0 0 1 material glass\n"

/* A wall that is a mirror shows the floor behind the eye, up to the horizon. Where it meets the floor, a footprint
 * continues beyond it: the pixels there, up to 64, are compared on their own. */
TEST(images_in_a_mirror)
{
    apart = side_of_mirror;
    check_image(mirrored, false, IN_A_MIRROR, 4, false);
    apart = NULL;
}

/* Returns the mean of the square wave, 1 in even cells and -1 in odd ones, over lo..hi: a sum over the cells. */
static double wave(double lo, double hi)
{
    double sum = 0;

    for (double n = floor(lo); n < hi; n++)
        sum += (fmin(hi, n + 1) - fmax(lo, n)) * (fmod(n, 2) == 0 ? 1 : -1);
    return sum / (hi - lo);
}

/* An orthographic camera over the floor: the footprints are the pixels, `size` cells wide and high, and the result is
 * exact. The windows' edges are no multiples of a cell. */
static void check_above(const struct tia_core *core, double edge)
{
    static double red[PIXELS];
    char text[600];
    double size = 2 * edge / HEIGHT;

    (void)snprintf(text, sizeof text,
                   "camera orthographic eye 0.25 5 0.125 look 0.25 0 0.125 up 0 0 -1 window 0 0 %.4f %.4f\n" FLOOR
                   "filter footprint\n",
                   -edge, edge);
    draw(core, text, red);
    for (int i = 0; i < PIXELS; i++) {
        double left = 0.25 + (i % WIDTH - WIDTH / 2) * size, v = -0.125 + (HEIGHT / 2 - i / WIDTH - 1) * size;
        double mean = wave(left, left + size) * wave(v, v + size);
        double want = (EVEN + ODD) / 2 + (EVEN - ODD) / 2 * mean;
        CHECK_MSG(fabs(red[i] - want) < 3e-5, "edge %.4f, pixel %d: %.6f, not %.6f", edge, i, red[i], want);
    }
}

TEST(boxes_exactly)
{
    static const double edges[] = {4.25, 17.125, 31.0625, 100.375, 999.5};

    for (size_t i = 0; i < sizeof edges / sizeof *edges; i++) {
        check_above(&tia_core_q16, edges[i]);
        check_above(&tia_core_f64, edges[i]);
    }
}

/* The statement applies to all textures of a scene, before and after it. */
TEST(statement)
{
    static double before[PIXELS], after[PIXELS], none[PIXELS], plain[PIXELS];
    const struct eye eye = {45, 8};

    draw_eye(&tia_core_q16, &eye, "", plain);
    draw_eye(&tia_core_q16, &eye, "filter none\n", none);
    CHECK(!memcmp(plain, none, sizeof plain));
    draw(&tia_core_q16, "camera eye 0 1 0\nfilter footprint\n" FLOOR, before);
    draw(&tia_core_q16, "camera eye 0 1 0\n" FLOOR "filter footprint\n", after);
    CHECK(!memcmp(before, after, sizeof before));
    draw(&tia_core_q16, "camera eye 0 1 0\n" FLOOR, none);
    CHECK(memcmp(before, none, sizeof before) != 0);
}

/* Of 16 samples, each stands for a 16th of the pixel: together they are nearer to the truth than one sample. */
TEST(samples)
{
    const struct eye eye = {45, 8};

    brute(&eye, 16, truth);
    draw_eye(&tia_core_q16, &eye, "filter footprint\n", one);
    draw_eye(&tia_core_q16, &eye, "filter footprint\nsamples 16\n", sixteen);
    CHECK_MSG(distance(sixteen, truth) < distance(one, truth), "%.5f, %.5f", distance(sixteen, truth),
              distance(one, truth));
}

int main(void)
{
    RUN(checkers_to_the_horizon);
    RUN(images_to_the_horizon);
    RUN(images_in_a_mirror);
    RUN(boxes_exactly);
    RUN(statement);
    RUN(samples);
    return check_status();
}
