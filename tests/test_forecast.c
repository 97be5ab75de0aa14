/* The time left is told within 20 % after a tenth of the work: from the measured times of the gallery's rows, and from
 * pictures that are harder. No clock is read here. */
#include <math.h>

#include "check.h"
#include "common/forecast.h"
#include "row_costs.h"

#define ROWS 960
#define SHARE 0.1
#define WITHIN 0.2

static double cost[ROWS]; /* of each row of the picture being drawn */

static double sum(unsigned rows)
{
    double all = 0;

    for (unsigned y = 0; y < rows; y++)
        all += cost[y];
    return all;
}

/* Returns by how much the time of a picture of one band, as told after `share` of its rows, is too long. */
static double error_at_once(unsigned rows, double share)
{
    double spent = 0;
    unsigned done = 0;

    while (done < share * rows)
        spent += cost[forecast_part(done++, rows)];
    return spent * rows / done / sum(rows) - 1;
}

/* Draws the probes of a band of `rows` rows; gives their number, and returns their time. */
static double probe(unsigned first, unsigned rows, unsigned *probes)
{
    double spent = 0;

    *probes = forecast_probes(rows);
    for (unsigned i = 0; i < *probes; i++)
        spent += cost[first + forecast_probe(i)];
    return spent;
}

static bool is_probe(unsigned row, unsigned probes)
{
    return row % FORECAST_STEP == forecast_probe(0) && row / FORECAST_STEP < probes;
}

/* As error_at_once, of a picture that is surveyed and then drawn in bands. */
static double error_in_bands(unsigned rows, unsigned bands, double share)
{
    unsigned height = rows / bands, probes = 0;
    double spent = 0, done = 0, all = 0, weights[16];

    for (unsigned b = 0; b < bands; b++) {
        double some = probe(b * height, height, &probes);
        weights[b] = (double)forecast_weight((uint64_t)(some * 1000), probes);
        spent += some;
        done += weights[b] * probes;
        all += weights[b] * height;
    }
    for (unsigned i = 0; i < rows && done < share * all; i++) {
        unsigned band = i / height, row = forecast_part(i % height, height);
        if (is_probe(row, probes))
            continue;
        spent += cost[band * height + row];
        done += weights[band];
    }
    return spent * all / done / sum(rows) - 1;
}

static void check_picture(const char *name, unsigned rows)
{
    double once = error_at_once(rows, SHARE), half = error_at_once(rows, 0.5);

    if (getenv("FORECAST_TABLE"))
        printf("# %-15s %4u rows: %+6.1f %% at a tenth, %+5.1f %% at half", name, rows, 100 * once, 100 * half);
    CHECK_MSG(fabs(once) <= WITHIN, "%s, %u rows: %.0f %%", name, rows, 100 * once);
    CHECK_MSG(fabs(half) <= WITHIN / 4, "%s, %u rows, half: %.0f %%", name, rows, 100 * half);
    for (unsigned bands = 2; rows == ROWS && bands <= 16; bands *= 2) {
        double banded = error_in_bands(rows, bands, SHARE);
        CHECK_MSG(fabs(banded) <= WITHIN, "%s, %u bands: %.0f %%", name, bands, 100 * banded);
        if (getenv("FORECAST_TABLE"))
            printf(", %u bands: %+5.1f %%", bands, 100 * banded);
    }
    if (getenv("FORECAST_TABLE"))
        printf("\n");
}

/* Each row takes the time of the measured row there. */
TEST(scenes_of_the_gallery)
{
    for (size_t i = 0; i < sizeof row_costs / sizeof row_costs[0]; i++) {
        CHECK_EQ(strlen(row_costs[i].rows), ROW_COSTS_ROWS);
        for (unsigned rows = ROW_COSTS_ROWS / 2; rows <= ROWS; rows *= 2) {
            for (unsigned y = 0; y < rows; y++)
                cost[y] = pow(1.15, row_costs[i].rows[y * ROW_COSTS_ROWS / rows] - '#');
            check_picture(row_costs[i].scene, rows);
        }
    }
}

/* The time of row y: above row `edge` another than below, a hundred times as much or a hundredth; or more in each row.
 */
static double made_cost(unsigned kind, unsigned y, unsigned edge)
{
    static const double above[] = {1, 100}, below[] = {100, 1};

    return kind == 2 ? y + 1 : y < edge ? above[kind] : below[kind];
}

TEST(skies)
{
    for (unsigned rows = 240; rows <= ROWS; rows *= 2)
        for (unsigned part = 4; part <= 12; part++)
            for (unsigned kind = 0; kind < 3; kind++) {
                for (unsigned y = 0; y < rows; y++)
                    cost[y] = made_cost(kind, y, rows * part / 16);
                check_picture("a sky", rows);
            }
}

TEST(each_part_is_drawn_once)
{
    static unsigned char seen[5000];

    for (unsigned count = 1; count <= 5000; count += 1 + count / 50) {
        memset(seen, 0, sizeof seen);
        for (unsigned i = 0; i < count; i++) {
            unsigned part = forecast_part(i, count);
            CHECK(part < count && !seen[part]);
            seen[part < count ? part : 0] = 1;
        }
    }
    CHECK(forecast_part(65534, 65535) < 65535);
}

TEST(probes_lie_in_the_band)
{
    for (unsigned parts = 0; parts < 1000; parts++) {
        unsigned probes = forecast_probes(parts);
        CHECK(!probes || forecast_probe(probes - 1) < parts);
        CHECK(forecast_probe(probes) >= parts);
    }
    CHECK_EQ(forecast_weight(0, 0), 1);
    CHECK_EQ(forecast_weight(1000, 256), 1001);
}

int main(void)
{
    RUN(scenes_of_the_gallery);
    RUN(skies);
    RUN(each_part_is_drawn_once);
    RUN(probes_lie_in_the_band);
    return check_status();
}
