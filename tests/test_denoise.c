/* The denoiser against its formulas in double precision, and its pinned bits. */
#include <math.h>
#include <stdlib.h>
#include <tia/denoise.h>

#include "check.h"
#include "gathered.h"
#include "random.h"

/* ---- the oracle: tia/denoise.h word for word ---- */

struct pixel {
    double rgb[3], albedo[3], normal[3], depth, error;
};

static double luminance(const double rgb[3])
{
    return (rgb[0] + 2 * rgb[1] + rgb[2]) / 4;
}

static double error_of(const double means[3], double square)
{
    double mean = luminance(means), variance = (square / COUNT - mean * mean) / (COUNT - 1);

    return variance > 0 ? sqrt(variance) : 0;
}

static void take(struct pixel picture[PIXELS])
{
    for (int i = 0; i < PIXELS; i++) {
        struct pixel *p = &picture[i];
        double length = 0, means[3];

        for (int c = 0; c < 3; c++) {
            means[c] = (double)sums[i].rgb[c] / ONE / COUNT;
            p->albedo[c] = fmax((double)guides[i].albedo[c] / ONE / COUNT, 1.0 / 128);
            p->rgb[c] = means[c] / p->albedo[c];
            p->normal[c] = (double)guides[i].normal[c];
            length += p->normal[c] * p->normal[c];
        }
        for (int c = 0; c < 3; c++)
            p->normal[c] /= length > 0 ? sqrt(length) : 1;
        p->depth = (double)guides[i].depth / 65536 / COUNT;
        p->error = error_of(means, (double)squares[i] / 4294967296.0) / luminance(p->albedo);
    }
}

static const struct pixel *near(const struct pixel *picture, int x, int y)
{
    return x < 0 || y < 0 || x >= WIDE || y >= HIGH ? NULL : &picture[y * WIDE + x];
}

static double depth_near(const struct pixel *picture, int x, int y)
{
    x = x < 0 ? 0 : x >= WIDE ? WIDE - 1 : x;
    y = y < 0 ? 0 : y >= HIGH ? HIGH - 1 : y;
    return picture[y * WIDE + x].depth;
}

static double blurred_error(const struct pixel *picture, int x, int y)
{
    double sum = 0, weights = 0;

    for (int j = -1; j <= 1; j++)
        for (int i = -1; i <= 1; i++) {
            const struct pixel *q = near(picture, x + i, y + j);
            double w = (2 - abs(i)) * (2 - abs(j));
            if (q) {
                sum += w * q->error * q->error;
                weights += w;
            }
        }
    return sqrt(sum / weights);
}

/* Filters a pixel; with `stops` its weights depend on the light. */
static struct pixel oracle_pixel(const struct pixel *picture, int x, int y, int step, bool stops)
{
    static const double h[5] = {1, 4, 6, 4, 1};
    const struct pixel *p = near(picture, x, y);
    double across = (depth_near(picture, x + 1, y) - depth_near(picture, x - 1, y)) / 2;
    double down = (depth_near(picture, x, y + 1) - depth_near(picture, x, y - 1)) / 2;
    double slope = fmax(fabs(across), fabs(down));
    double spread = 3 * blurred_error(picture, x, y) + 16 / 65536.0, weights = 0;
    struct pixel sum = *p;

    sum.error = sum.rgb[0] = sum.rgb[1] = sum.rgb[2] = 0;
    for (int j = -2; j <= 2; j++)
        for (int i = -2; i <= 2; i++) {
            const struct pixel *q = near(picture, x + i * step, y + j * step);
            double dot = 0, a = 0, w = h[i + 2] * h[j + 2];
            if (!q)
                continue;
            for (int c = 0; c < 3; c++) {
                dot += p->normal[c] * q->normal[c];
                a += fabs(p->albedo[c] - q->albedo[c]);
            }
            double room = slope * (abs(i) + abs(j)) * step / 8 + p->depth / 512;
            double off = fabs(q->depth - p->depth - (across * i + down * j) * step);
            double exponent = (off > 0 ? off / room : 0) + 4 * a;
            exponent += stops ? fabs(luminance(p->rgb) - luminance(q->rgb)) / spread : 0;
            if (q != p)
                w *= pow(fmax(dot, 0), 8) * exp2(-exponent);
            weights += w;
            for (int c = 0; c < 3; c++)
                sum.rgb[c] += w * q->rgb[c];
            sum.error += w * q->error * w * q->error;
        }
    for (int c = 0; c < 3; c++)
        sum.rgb[c] /= weights;
    sum.error = sqrt(sum.error) / weights;
    return sum;
}

static void oracle_passes(struct pixel pictures[2][PIXELS], bool stop)
{
    for (int pass = 0; pass < 3; pass++)
        for (int i = 0; i < PIXELS; i++)
            pictures[~pass & 1][i] = oracle_pixel(pictures[pass & 1], i % WIDE, i / WIDE, 1 << pass, stop);
}

/* Runs three passes, then averages the removed light by three more and adds it. */
static const struct pixel *oracle(void)
{
    static struct pixel pictures[2][PIXELS], taken[2][PIXELS];

    take(pictures[0]);
    take(taken[0]);
    oracle_passes(pictures, true);
    for (int i = 0; i < 3 * PIXELS; i++)
        taken[0][i / 3].rgb[i % 3] -= pictures[1][i / 3].rgb[i % 3];
    oracle_passes(taken, false);
    for (int i = 0; i < 3 * PIXELS; i++)
        pictures[1][i / 3].rgb[i % 3] = fmax(pictures[1][i / 3].rgb[i % 3] + taken[1][i / 3].rgb[i % 3], 0);
    return pictures[1];
}

/* ---- pictures ---- */

/* Makes COUNT samples of light around `level`, on two walls that meet in the middle and differ; both are a little
 * rough. */
static void invent_pixel(int i, double level, double noise)
{
    bool right = i % WIDE > WIDE / 2;
    struct tia_guide *g = &guides[i];

    sums[i] = (struct tia_sum){{0, 0, 0}};
    squares[i] = 0;
    *g = (struct tia_guide){{0, 0, 0}, 0, {0, 0, 0}};
    for (int s = 0; s < COUNT; s++) {
        double light = level + noise * (double)random_real(), y = 0;
        for (int c = 0; c < 3; c++) {
            double albedo = (right ? 0.25 + 0.25 * c : 0.75) + 0.02 * sin(i), shown = fmax(light * albedo, 0);
            sums[i].rgb[c] += (int64_t)(shown * ONE);
            g->albedo[c] += (int64_t)(albedo * ONE);
            y += shown * (c == 1 ? 2 : 1) / 4;
        }
        squares[i] += (uint64_t)(y * y * 4294967296.0);
        g->normal[0] += (int64_t)((right ? 0.6 : 0.8) * ONE);
        g->normal[1] += (int64_t)(0.3 * cos(i) * ONE);
        g->normal[2] += (int64_t)((right ? 0.8 : 0.6) * ONE);
        g->depth += (int64_t)((5 + (right ? 0.02 : -0.03) * (i % WIDE) + 0.01 * (i / WIDE)) * 65536);
    }
}

static void invent(double noise)
{
    for (int i = 0; i < PIXELS; i++)
        invent_pixel(i, 0.5 + 0.4 * sin(i / WIDE / 5.0), noise);
}

static struct tia_denoiser *begin(void)
{
    size_t size = tia_denoise_size(WIDE, HIGH);
    void *memory = malloc(size);
    struct tia_denoiser *d = NULL;

    CHECK_EQ(tia_denoise_init(&d, memory, size, WIDE, HIGH), TIA_OK);
    CHECK(d == memory);
    return d;
}

static void denoise(void)
{
    struct tia_denoiser *d = begin();

    CHECK_EQ(tia_denoise_put(d, whole, &all, COUNT), TIA_OK);
    for (unsigned pass = 0; pass < TIA_DENOISE_PASSES; pass++)
        CHECK_EQ(tia_denoise_pass(d, pass, whole), TIA_OK);
    CHECK_EQ(tia_denoise_get(d, whole, COUNT, got, WIDE), TIA_OK);
    free(d);
}

/* ---- the formulas ---- */

TEST(it_is_its_formulas)
{
    double worst = 0;

    for (int round = 0; round < 4; round++) {
        invent(0.1 + 0.3 * round);
        denoise();
        const struct pixel *want = oracle();
        for (int i = 0; i < PIXELS; i++)
            for (int c = 0; c < 3; c++) {
                double is = (double)got[i].rgb[c] / ONE / COUNT, should = want[i].rgb[c] * want[i].albedo[c];
                worst = fmax(worst, fabs(is - should));
            }
    }
    printf("# off by at most %.1e\n", worst);
    CHECK_MSG(worst < 0.002, "off by %f", worst);
}

TEST(noise_goes_and_edges_stay)
{
    double before = 0, after = 0;

    invent(0.4);
    denoise();
    for (int i = 0; i < PIXELS; i++)
        for (int c = 0; c < 3; c++) {
            double level =
                (0.5 + 0.4 * sin(i / WIDE / 5.0)) * ((i % WIDE > WIDE / 2 ? 0.25 + 0.25 * c : 0.75) + 0.02 * sin(i));
            before += pow((double)sums[i].rgb[c] / ONE / COUNT - level, 2);
            after += pow((double)got[i].rgb[c] / ONE / COUNT - level, 2);
        }
    CHECK_MSG(after < before / 2, "%f of the noise is left", after / before);
}

/* A pixel whose samples all agree is unchanged, whatever its neighbours: to 2^-16 of light over albedo. */
TEST(what_is_sure_stays)
{
    for (int i = 0; i < PIXELS; i++)
        invent_pixel(i, (i % WIDE + i / WIDE) & 1 ? 0.9 : 0.1, 0);
    denoise();
    for (int i = 0; i < PIXELS; i++)
        for (int c = 0; c < 3; c++)
            CHECK(fabs((double)(got[i].rgb[c] - sums[i].rgb[c])) < 0.001 * ONE * COUNT);
}

/* Lamps of 2^14 beside black and dark surfaces, means of one sample and of very many, missing guides. */
TEST(extremes_do_not_overflow)
{
    static const int64_t lights[] = {0, 1, 1 << 24, (int64_t)1 << 38}, albedos[] = {0, 1, 1 << 20, (int64_t)1 << 38};

    for (uint32_t count = 1; count <= TIA_SPP_MAX; count = count < TIA_SPP_MAX ? TIA_SPP_MAX : count + 1) {
        struct tia_denoiser *d = begin();
        for (int i = 0; i < PIXELS; i++) {
            for (int c = 0; c < 3; c++) {
                sums[i].rgb[c] = lights[random_u32() & 3] * count;
                guides[i].albedo[c] = albedos[random_u32() & 3] * count;
                guides[i].normal[c] = (int64_t)((int32_t)random_u32() >> (random_u32() & 31)) / 256 * count;
            }
            guides[i].depth = (int64_t)(random_u32() >> (random_u32() & 31)) * count;
            squares[i] = random_u32() & 1 ? UINT64_MAX : random_bits() >> (random_u32() & 63);
        }
        CHECK_EQ(tia_denoise_put(d, whole, &all, count), TIA_OK);
        for (unsigned pass = 0; pass < TIA_DENOISE_PASSES; pass++)
            CHECK_EQ(tia_denoise_pass(d, pass, whole), TIA_OK);
        CHECK_EQ(tia_denoise_get(d, whole, count, got, WIDE), TIA_OK);
        for (int i = 0; i < PIXELS; i++)
            for (int c = 0; c < 3; c++)
                CHECK(got[i].rgb[c] >= 0 && got[i].rgb[c] <= ((int64_t)1 << 38) * count);
        free(d);
    }
}

/* ---- the same bits in any tiles; sizes; errors ---- */

TEST(tiles_do_not_matter)
{
    static struct tia_sum tiled[PIXELS];
    struct tia_denoiser *d = begin();

    invent(0.4);
    denoise();
    for (unsigned step = 0; step < TIA_DENOISE_PASSES + 2; step++)
        for (int y = HIGH; y > 0; y -= 7) /* tiles from the end: widths of 5, heights of 7 and the remainder */
            for (int x = WIDE; x > 0; x -= 5) {
                struct tia_tile t = {(uint16_t)(x < 5 ? 0 : x - 5), (uint16_t)(y < 7 ? 0 : y - 7),
                                     (uint16_t)(x < 5 ? x : 5), (uint16_t)(y < 7 ? y : 7)};
                size_t place = (size_t)t.y * WIDE + t.x;
                const struct tia_gathered part = {sums + place, guides + place, squares + place, WIDE};
                if (step == 0)
                    CHECK_EQ(tia_denoise_put(d, t, &part, COUNT), TIA_OK);
                else if (step <= TIA_DENOISE_PASSES)
                    CHECK_EQ(tia_denoise_pass(d, step - 1, t), TIA_OK);
                else
                    CHECK_EQ(tia_denoise_get(d, t, COUNT, tiled + place, WIDE), TIA_OK);
            }
    CHECK(!memcmp(tiled, got, sizeof got));
    free(d);
}

/* These numbers come from integer arithmetic alone: they are the same on each processor, by each compiler. */
TEST(bits_are_pinned)
{
    uint32_t hash = UINT32_C(2166136261);

    random_state = 1;
    for (int i = 0; i < PIXELS; i++) {
        for (int c = 0; c < 3; c++) {
            sums[i].rgb[c] = (int64_t)(random_bits() >> 40) * COUNT;
            guides[i].albedo[c] = (int64_t)((random_bits() >> 44) + (1 << 22)) * COUNT;
            guides[i].normal[c] = (int64_t)((random_bits() >> 42) + (1 << 22)) * COUNT;
        }
        guides[i].depth = (int64_t)(300000 + (random_bits() >> 54)) * COUNT;
        squares[i] = random_bits() >> 28;
    }
    denoise();
    for (int i = 0; i < PIXELS; i++)
        for (int c = 0; c < 3; c++)
            for (int byte = 0; byte < 8; byte++)
                hash = (hash ^ (uint32_t)((uint64_t)got[i].rgb[c] >> (8 * byte) & 255)) * UINT32_C(16777619);
    CHECK_EQ(hash, UINT32_C(396927922));
}

TEST(memory_and_mistakes)
{
    static uint64_t little[16];
    struct tia_denoiser *d;
    size_t size = tia_denoise_size(640, 480);

    CHECK_MSG(size >= 640 * 480 * 68 && size < 640 * 480 * 68 + 256, "%zu", size);
    CHECK_EQ(tia_denoise_size(TIA_SIZE_MAX + 1, 1), SIZE_MAX);
    CHECK_EQ(tia_denoise_init(&d, little, sizeof little, 640, 480), TIA_ERR_MEMORY);
    CHECK_EQ(tia_denoise_init(&d, little, sizeof little, 0, 1), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_denoise_init(&d, little, sizeof little, 1, TIA_SIZE_MAX + 1), TIA_ERR_ARGUMENT);
    d = begin();
    CHECK_EQ(tia_denoise_put(d, whole, &all, 0), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_denoise_put(d, whole, &all, TIA_SPP_MAX + 1), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_denoise_put(d, (struct tia_tile){1, 0, WIDE, 1}, &all, 1), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_denoise_pass(d, TIA_DENOISE_PASSES, whole), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_denoise_pass(d, 0, (struct tia_tile){0, 0, WIDE, 0}), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_denoise_get(d, (struct tia_tile){0, 1, WIDE, HIGH}, 1, got, WIDE), TIA_ERR_ARGUMENT);
    free(d);
}

int main(void)
{
    RUN(it_is_its_formulas);
    RUN(noise_goes_and_edges_stay);
    RUN(what_is_sure_stays);
    RUN(extremes_do_not_overflow);
    RUN(tiles_do_not_matter);
    RUN(bits_are_pinned);
    RUN(memory_and_mistakes);
    return check_status();
}
