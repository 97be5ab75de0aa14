/* The Cornell box: the scene is its published measurements, its light that of an oracle in double precision, by either
 * strategy and by both; and the error falls fast enough.
 *
 *     test_cornell [TIMES]    with TIMES times the samples; 1 takes seconds */
#include <math.h>
#include <stdlib.h>

#include <tia/tia.h>

#include "check.h"
#include "oracle/cornell.h"
#include "reading.h"

static unsigned times = 1;

static struct reading box;

static void read_box(void)
{
    size_t length = 0;
    char *text = load_file("scenes/cornell.tia", &length);

    CHECK(text != NULL);
    box = (struct reading){.reader = {.format = TIA_FORMAT_TIA, .text = text, .length = length}};
    read_begin(&box);
    CHECK_EQ(box.status, TIA_OK);
    free(text);
}

/* ---- measurements ---- */

static void check_rgb(const struct tia_rgb *got, unsigned bits, const double want[3])
{
    const tia_q30 rgb[3] = {got->r, got->g, got->b};

    for (int c = 0; c < 3; c++)
        CHECK_MSG(fabs(rgb[c] / 1073741824.0 * (1u << bits) - want[c]) < 1e-7, "%f, not %f", rgb[c] / 1073741824.0,
                  want[c]);
}

/* True if the vertex is the corner, within the scene's last digit. */
static bool is_corner(const struct tia_vec3 *v, const double want[3])
{
    const double unit = 65536.0 * (1u << box.scene.scale_bits);

    return fabs(v->x / unit - want[0]) < 2e-5 && fabs(v->y / unit - want[1]) < 2e-5 &&
           fabs(v->z / unit - want[2]) < 2e-5;
}

/* True if one of the scene's meshes has a triangle with those corners. */
static bool has_triangle(const double *a, const double *b, const double *c, const double colour[3])
{
    const double *const want[3] = {a, b, c};

    for (uint32_t i = 0; i < box.scene.shape_count; i++) {
        const struct tia_mesh *mesh = &box.scene.meshes[box.scene.shapes[i].mesh];
        const struct tia_rgb *shown = &box.scene.materials[box.scene.shapes[i].material].colour;
        for (uint32_t f = 0; f < mesh->face_count && fabs(shown->r / 1073741824.0 - colour[0]) < 1e-7; f++) {
            unsigned found = 0;
            for (int w = 0; w < 3; w++)
                for (int k = 0; k < 3; k++)
                    found += is_corner(&mesh->vertices[mesh->faces[f].corner[k].vertex], want[w]);
            if (found == 3)
                return true;
        }
    }
    return false;
}

TEST(measurements_are_those_published)
{
    const double *low = oracle_box_lamp[0], *high = oracle_box_lamp[1];
    const struct tia_light *lamp = &box.scene.lights[0];
    struct tia_vec3 half = {lamp->side[0].x + lamp->side[1].x, 0, lamp->side[0].z + lamp->side[1].z};
    struct tia_vec3 across = {lamp->centre.x - half.x, lamp->centre.y, lamp->centre.z - half.z};
    struct tia_vec3 opposite = {lamp->centre.x + half.x, lamp->centre.y, lamp->centre.z + half.z};

    CHECK_EQ(box.scene.light_count, 1);
    check_rgb(&lamp->emission, lamp->emission_bits, oracle_box_colours[3]);
    CHECK(is_corner(&across, low) && is_corner(&opposite, high));
    for (int i = 0; i < 15; i++) {
        const double(*p)[3] = oracle_box_polygons[i], *colour = oracle_box_colours[i == 3 ? 2 : i == 4 ? 1 : 0];
        bool one = has_triangle(p[0], p[1], p[2], colour) && has_triangle(p[0], p[2], p[3], colour);
        bool other = has_triangle(p[1], p[2], p[3], colour) && has_triangle(p[1], p[3], p[0], colour);
        CHECK_MSG(one || (other && i != 4), "polygon %d is not in the scene", i);
    }
}

/* ---- means ---- */

enum { SIDE = 16, BLOCKS = 4, NUMBERS = SIDE * SIDE * 3, MEANS = BLOCKS * BLOCKS * 3 + 3 };

/* A view of the box for one seed. */
struct drawing {
    struct tia_view *view;
    void *memory;
};

static struct drawing open_box(struct tia_integration how, unsigned side)
{
    struct drawing d;

    box.scene.integration = how;
    size_t size = tia_view_size(&box.scene, 1);
    d.memory = malloc(size);
    CHECK_EQ(tia_view_init(&d.view, d.memory, size, &box.scene, 1, side, side, NULL), TIA_OK);
    return d;
}

static void sample_box(const struct drawing *d, unsigned side, uint32_t first, uint32_t end, struct tia_sum *sums)
{
    CHECK_EQ(tia_estimator_q16.sample(d->view, (struct tia_tile){0, 0, (uint16_t)side, (uint16_t)side}, first, end,
                                      sums, side),
             TIA_OK);
}

static void draw_box(struct tia_integration how, unsigned spp, double rgb[NUMBERS])
{
    static struct tia_sum sums[SIDE * SIDE];
    struct drawing d = open_box(how, SIDE);

    memset(sums, 0, sizeof sums);
    sample_box(&d, SIDE, 0, spp, sums);
    for (unsigned i = 0; i < NUMBERS; i++)
        rgb[i] = (double)sums[i / 3].rgb[i % 3] / 16777216 / spp;
    free(d.memory);
}

/* Sums over seeds: means of blocks of the picture and of all of it, and their squares. */
struct tally {
    double sum[MEANS], square[MEANS];
    unsigned count;
};

static void count_picture(struct tally *tally, const double rgb[NUMBERS])
{
    double mean[MEANS] = {0};

    for (unsigned i = 0; i < SIDE * SIDE; i++) {
        unsigned block = i / SIDE / (SIDE / BLOCKS) * BLOCKS + i % SIDE / (SIDE / BLOCKS);
        for (unsigned c = 0; c < 3; c++) {
            mean[3 * block + c] += rgb[3 * i + c] * BLOCKS * BLOCKS / SIDE / SIDE;
            mean[MEANS - 3 + c] += rgb[3 * i + c] / SIDE / SIDE;
        }
    }
    for (unsigned i = 0; i < MEANS; i++) {
        tally->sum[i] += mean[i];
        tally->square[i] += mean[i] * mean[i];
    }
    tally->count++;
}

/* Returns mean number i; *variance receives its squared standard error. */
static double mean_of(const struct tally *tally, unsigned i, double *variance)
{
    double n = tally->count, mean = tally->sum[i] / n;

    *variance = (tally->square[i] / n - mean * mean) / (n - 1);
    return mean;
}

/* Compares means: the whole picture's must be within three standard errors, those of its many blocks within four. The
 * whole picture's relative standard error must be below `most`/sqrt(TIMES). */
static void compare(const char *name, const struct tally *got, const struct tally *want, double most)
{
    for (unsigned i = 0; i < MEANS; i++) {
        double a, b, x = mean_of(got, i, &a), y = mean_of(want, i, &b), error = sqrt(a + b);
        bool whole = i >= MEANS - 3;
        if (whole)
            printf("# %s: %.6f, oracle %.6f: relative %+.1e, standard errors %.1e and %.1e\n", name, x, y, (x - y) / y,
                   sqrt(a) / y, sqrt(b) / y);
        CHECK_MSG(fabs(x - y) <= (whole ? 3 : 4) * error, "%s: mean %u is %f, not %f, standard error %f", name, i, x, y,
                  error);
        CHECK_MSG(!whole || error < most / sqrt(times) * y, "standard error %f of %f", error, y);
    }
}

TEST(means_are_those_of_the_oracle)
{
    static double rgb[NUMBERS];
    static struct tally oracle, both, lights, scattering;
    const unsigned seeds = 8 * times;

    for (uint32_t seed = 1; seed <= seeds; seed++) {
        memset(rgb, 0, sizeof rgb);
        oracle_box(SIDE, seed, 8, rgb);
        count_picture(&oracle, rgb);
        draw_box((struct tia_integration){.integrator = TIA_PATHS, .seed = seed}, 32, rgb);
        count_picture(&both, rgb);
        draw_box((struct tia_integration){TIA_PATHS, .seed = seed, .without = TIA_STRATEGY_SCATTERING}, 32, rgb);
        count_picture(&lights, rgb);
        draw_box((struct tia_integration){TIA_PATHS, .seed = seed, .without = TIA_STRATEGY_LIGHTS}, 32, rgb);
        count_picture(&scattering, rgb);
    }
    compare("both strategies", &both, &oracle, 0.012);
    compare("lights alone", &lights, &oracle, 0.012);
    compare("scattering alone", &scattering, &oracle, 0.03);
}

/* ---- convergence of the error ---- */

enum { PIXELS_MAX = 32 * 32, STEPS = 7, LEAST = 16 };

/* Returns the width of a picture. With few pixels and few seeds, slopes are off by up to 0.1, or 0.05. */
static unsigned side_of_slopes(void)
{
    return times > 2 ? 32 : times > 1 ? 16 : 8;
}

/* Returns the number of steps, which are 16, 32 ... 1024 samples, or up to 512 in make check-quick. */
static unsigned steps_of_slopes(void)
{
    return check_is_quick() ? STEPS - 1 : STEPS;
}

/* Sums over seeds of the numbers of each step, and of their squares. The root of their mean variance is the RMSE of an
 * estimate without bias. */
struct spread {
    double sum[STEPS][PIXELS_MAX * 3], square[STEPS][PIXELS_MAX * 3];
};

static struct spread spread;
static struct tia_sum slope_sums[PIXELS_MAX];

static void count_step(unsigned step, unsigned numbers, uint32_t spp)
{
    for (unsigned i = 0; i < numbers; i++) {
        double value = (double)slope_sums[i / 3].rgb[i % 3] / 16777216 / spp;
        spread.sum[step][i] += value;
        spread.square[step][i] += value * value;
    }
}

static double rmse(unsigned step, unsigned numbers, unsigned seeds)
{
    double sum = 0;

    for (unsigned i = 0; i < numbers; i++) {
        double mean = spread.sum[step][i] / seeds;
        sum += (spread.square[step][i] / seeds - mean * mean) * seeds / (seeds - 1);
    }
    return sqrt(sum / numbers);
}

/* Measures the RMSE of each step. */
static void measure(struct tia_integration how, unsigned seeds, double result[STEPS])
{
    const unsigned side = side_of_slopes(), numbers = side * side * 3;

    memset(&spread, 0, sizeof spread);
    for (how.seed = 1; how.seed <= seeds; how.seed++) {
        struct drawing d = open_box(how, side);
        memset(slope_sums, 0, sizeof slope_sums);
        for (unsigned step = 0; step < steps_of_slopes(); step++) {
            uint32_t spp = (uint32_t)LEAST << step;
            sample_box(&d, side, step ? spp / 2 : 0, spp, slope_sums);
            count_step(step, numbers, spp);
        }
        free(d.memory);
    }
    for (unsigned step = 0; step < steps_of_slopes(); step++)
        result[step] = rmse(step, numbers, seeds);
}

/* Returns the slope of the line through log RMSE over log samples. */
static double slope(const char *name, const double result[STEPS])
{
    const int steps = (int)steps_of_slopes();
    double sum = 0, weight = 0;

    printf("# %s: RMSE", name);
    for (int step = 0; step < steps; step++) {
        double x = step - (steps - 1) / 2.0;
        printf(" %.5f", result[step]);
        sum += x * log2(result[step]);
        weight += x * x;
    }
    printf(", slope %.3f\n", sum / weight);
    return sum / weight;
}

static void check_slope(const char *name, struct tia_integration how, double most)
{
    double result[STEPS], off = times > 2 ? 0 : times > 1 ? 0.05 : 0.1;

    measure(how, times > 1 ? 8 : 4, result);
    double s = slope(name, result);
    CHECK_MSG(s <= most + off, "%s: slope %f", name, s);
}

/* The error converges. It falls with -3/4 at edges between light and dark that are slanted in the pixel or in the lamp,
 * whatever the points: the mean square discrepancy of half-planes is at least n^(-3/2) (Alexander 1990). Elsewhere it
 * falls faster. */
TEST(direct_light_converges)
{
    check_slope("direct light", (struct tia_integration){.integrator = TIA_PATHS, .bounces = 1}, -0.8);
}

TEST(occlusion_converges)
{
    check_slope("occlusion", (struct tia_integration){.integrator = TIA_OCCLUSION, .distance = TIA_Q16(200)}, -0.6);
}

/* Returns the RMSE of plain random numbers: sample 0 of each seed is independent of all others. */
static double rmse_of_plain_numbers(struct tia_integration how, unsigned count)
{
    const unsigned side = side_of_slopes();

    memset(&spread, 0, sizeof spread);
    for (how.seed = 1; how.seed <= count; how.seed++) {
        struct drawing d = open_box(how, side);
        memset(slope_sums, 0, sizeof slope_sums);
        sample_box(&d, side, 0, 1, slope_sums);
        count_step(0, side * side * 3, 1);
        free(d.memory);
    }
    return rmse(0, side * side * 3, count) / sqrt(LEAST << (steps_of_slopes() - 1));
}

TEST(paths_converge_faster_than_plain_numbers)
{
    double result[STEPS], plain;
    struct tia_integration how = {.integrator = TIA_PATHS};

    measure(how, times > 1 ? 8 : 4, result);
    (void)slope("paths", result);
    plain = rmse_of_plain_numbers(how, check_count(1024));
    printf("# with plain random numbers: RMSE %.5f\n", plain);
    CHECK_MSG(result[steps_of_slopes() - 1] <= 0.8 * plain, "%f, plain numbers %f", result[steps_of_slopes() - 1],
              plain);
}

int main(int argc, char **argv)
{
    times = (unsigned)check_number(argc, argv, 1, 1);
    read_box();
    RUN(measurements_are_those_published);
    RUN_LONG(means_are_those_of_the_oracle);
    RUN(direct_light_converges);
    RUN(occlusion_converges);
    RUN_LONG(paths_converge_faster_than_plain_numbers);
    read_end(&box);
    return check_status();
}
