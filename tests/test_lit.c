/* The lights that reach each pixel, in tia_debug.lit, against points and boxes computed in double precision from the
 * equations in tia/light.h; and the pixels that plain z-pass lights wrongly. */
#include "reading.h"
#include <math.h>
#include <tia/debug.h>
#include <tia/tia.h>

#define SIDE 16
#define PIXELS (SIDE * SIDE)

/* The scene: pixel (i, j) shows the ground at x = -4 + (i + 1/2)/2, z = -4 + (j + 1/2)/2, or the box. */
static const char scene_text[] = "camera orthographic eye 0 10 0 look 0 0 0 up 0 0 -1 window -4 4 -4 4\n"
                                 "material m colour 0.5\n"
                                 "light ambient emission 0.1\n"
                                 "light at 3.1 4.3 0.2\n"
                                 "light directional direction -1 -2 0.3\n"
                                 "light rectangle at 0.3 5 -5 sides 0.6 0 0 0 0 0.6 samples 4\n"
                                 "plane point 0 0 0 normal 0 1 0 material m\n"
                                 "box min -1 0 -1 max 1 1 1 material m\n";

#define BITS 6

struct picture {
    tia_rgb565 pixels[PIXELS];
    uint32_t object[PIXELS];
    uint64_t lit[PIXELS];
};

static void draw(const struct tia_scene *scene, enum tia_shadows shadows, struct picture *p)
{
    const struct tia_tile all = {0, 0, SIDE, SIDE};
    const struct tia_surface surface = {.pixels = p->pixels, .step = 2, .pitch = 2 * SIDE};
    const struct tia_options options = {.debug = &(struct tia_debug){.lit = p->lit}};
    struct tia_scene drawn = *scene;
    struct tia_view *view;
    struct tia_hits *hits;

    drawn.shadows = shadows;
    size_t view_size = tia_view_size(&drawn, drawn.light_count), hits_size = tia_hits_size(&drawn, all);
    void *view_memory = malloc(view_size), *hits_memory = malloc(hits_size);
    memset(p->lit, 0x5a, sizeof p->lit);
    CHECK_EQ(tia_view_init(&view, view_memory, view_size, &drawn, drawn.light_count, SIDE, SIDE, NULL), TIA_OK);
    CHECK_EQ(tia_hits_init(&hits, hits_memory, hits_size, view, all), TIA_OK);
    CHECK_EQ(tia_view_draw(view, hits, all, &surface, &options), TIA_OK);
    for (unsigned i = 0; i < PIXELS; i++)
        p->object[i] = tia_hits_object(hits, i % SIDE, i / SIDE);
    free(view_memory);
    free(hits_memory);
}

/* Samples of the lights: positions have w = 1, directions w = 0. The rectangle's have u = (i + 1/2)/4 and v = 0, 1/2,
 * 1/4, 3/4. */
static const double from[BITS][4] = {{3.1, 4.3, 0.2, 1},           {1, 2, -0.3, 0},
                                     {0.3 - 0.45, 5, -5 - 0.6, 1}, {0.3 - 0.15, 5, -5, 1},
                                     {0.3 + 0.15, 5, -5 - 0.3, 1}, {0.3 + 0.45, 5, -5 + 0.3, 1}};

/* True if the segment from p along d, `end` times d long, passes through the box. */
static bool is_blocked(const double p[3], const double d[3], double end)
{
    static const double low[3] = {-1, 0, -1}, high[3] = {1, 1, 1};
    double enter = 1e-9, leave = end;

    for (int k = 0; k < 3; k++) {
        double a = (low[k] - p[k]) / d[k], b = (high[k] - p[k]) / d[k];
        enter = fmax(enter, fmin(a, b));
        leave = fmin(leave, fmax(a, b));
    }
    return enter < leave;
}

static uint64_t want(unsigned i)
{
    double p[3] = {-4 + (i % SIDE + 0.5) / 2, 0, -4 + (i / SIDE + 0.5) / 2};
    uint64_t bits = 0;

    p[1] = fabs(p[0]) < 1 && fabs(p[2]) < 1 ? 1 : 0;
    for (unsigned k = 0; k < BITS; k++) {
        double d[3];
        for (int n = 0; n < 3; n++)
            d[n] = from[k][n] - from[k][3] * p[n];
        bits |= (uint64_t)!is_blocked(p, d, from[k][3] > 0 ? 1 : 1e9) << k;
    }
    return bits;
}

static void check_bits(const struct tia_scene *scene, enum tia_shadows shadows, uint64_t mask)
{
    static struct picture p;
    uint64_t dark = mask, lit = mask;

    draw(scene, shadows, &p);
    for (unsigned i = 0; i < PIXELS; i++) {
        CHECK_MSG((p.lit[i] & mask) == (want(i) & mask), "%s, pixel %u: %llx, not %llx", tia_shadows_name(shadows), i,
                  (unsigned long long)p.lit[i], (unsigned long long)want(i));
        CHECK_EQ(p.lit[i] >> BITS, 0);
        dark &= p.lit[i];
        lit &= ~p.lit[i];
    }
    CHECK_EQ(dark | lit, 0); /* each light reaches some pixels, and not others */
}

/* Traced area lights have different samples from pixel to pixel. */
TEST(samples_that_arrive)
{
    struct reading r;

    read_string(&r, TIA_FORMAT_TIA, scene_text);
    CHECK_EQ(r.status, TIA_OK);
    check_bits(&r.scene, TIA_SHADOWS_TRACED, 3);
    check_bits(&r.scene, TIA_SHADOWS_ZPASS, (1 << BITS) - 1);
    check_bits(&r.scene, TIA_SHADOWS_ZFAIL, (1 << BITS) - 1);
    check_bits(&r.scene, TIA_SHADOWS_ZPASS_PLAIN, (1 << BITS) - 1);
    read_end(&r);
}

/* There are 70 lights above, 8 x 8 pixels of background in the middle, and four samples in each pixel. */
TEST(samples_without_a_bit)
{
    static struct picture p;
    char text[4000] = "camera orthographic eye 0 10 0 look 0 0 0 up 0 0 -1 window -4 4 -4 4\nsamples 4\n"
                      "material m colour 0.5\nlight ambient\nbox min -4 0 -4 max -2 1 4 material m\n";
    struct reading r;

    for (int i = 0; i < 70; i++)
        strcat(text, "light directional direction 0 -1 0\n");
    read_string(&r, TIA_FORMAT_TIA, text);
    CHECK_EQ(r.status, TIA_OK);
    draw(&r.scene, TIA_SHADOWS_TRACED, &p);
    for (unsigned i = 0; i < PIXELS; i++)
        CHECK(p.lit[i] == (i % SIDE < SIDE / 4 ? UINT64_MAX : 0));
    read_end(&r);
}

/* Checks the shadow of a box between the eye and a light behind it. If the eye is in the shadow volume (`inside`),
 * plain z-pass counts one too few: points in no volume are dark, and points in one are lit. */
static void check_plain(const char *box, bool inside)
{
    static struct picture right, plain;
    char text[400];
    unsigned dark = 0;
    struct reading r;

    (void)snprintf(text, sizeof text,
                   "camera eye 0 1 0 look 0 0 -4 fov 60\nmaterial m colour 0.5\n"
                   "light directional direction 0 -1 -4\n"
                   "plane point 0 0 0 normal 0 1 0 material m\n%s",
                   box);
    read_string(&r, TIA_FORMAT_TIA, text);
    CHECK_EQ(r.status, TIA_OK);
    draw(&r.scene, TIA_SHADOWS_ZPASS, &right);
    draw(&r.scene, TIA_SHADOWS_ZPASS_PLAIN, &plain);
    for (unsigned i = 0; i < PIXELS; i++) {
        CHECK_EQ(right.object[i], plain.object[i]);
        CHECK(plain.lit[i] == (right.object[i] == 0 ? right.lit[i] ^ (uint64_t)inside : right.lit[i]));
        dark += right.object[i] == 0 && !right.lit[i];
    }
    CHECK(dark > 5);
    read_end(&r);
}

TEST(plain_z_pass)
{
    check_plain("box min -2 1.5 3 max 2 2.5 4 material m\n", true);
    check_plain("box min -4 1.4 -4 max 4 1.8 -0.5 material m\n", false);
}

int main(void)
{
    RUN(samples_that_arrive);
    RUN(samples_without_a_bit);
    RUN(plain_z_pass);
    return check_status();
}
