/* src/simd/rays, empty cubes of grids, beside all of their cells; rays that leap by them, beside rays that step;
 * and rays beside others within their error. */
#include "one_lane.h"

#include "float_modes.h"
#include "ray_steps.h"
#include "simd/rays/grids.h"

enum { LONGEST = 12, CELLS = LONGEST * LONGEST * LONGEST };

struct trial {
    uint8_t cells[CELLS], empty[8 * CELLS];
    struct tia_grid grid;
    struct sure_grid sure;
};

static void some_grid(struct trial *t)
{
    unsigned sparse = 1u << random_bits() % 10;

    t->grid = (struct tia_grid){.cells = t->cells};
    for (int i = 0; i < 3; i++)
        t->grid.size[i] = (uint16_t)(1 + random_bits() % LONGEST);
    for (int i = 0; i < CELLS; i++)
        t->cells[i] = random_bits() % sparse ? 0 : (uint8_t)(1 + random_bits() % 2);
    tia_sure_set_empty(t->empty, &t->grid);
    t->sure = (struct sure_grid){.from = &t->grid, .edge = 0.25, .corner = {-1, 0.5, -0.25}};
}

/* True if a cube of this edge, with the cell in one corner, has only empty cells. */
static bool is_empty(const struct trial *t, const int at[3], unsigned octant, int edge)
{
    const uint16_t *n = t->grid.size;

    for (int k = 0; k < n[0] * n[1] * n[2]; k++) {
        const int cell[3] = {k % n[0], k / n[0] % n[1], k / n[0] / n[1]};
        bool in = true;
        for (int i = 0; i < 3; i++) {
            int away = octant >> i & 1 ? at[i] - cell[i] : cell[i] - at[i];
            in = in && away >= 0 && away < edge;
        }
        if (in && t->cells[k])
            return false;
    }
    return true;
}

TEST(cubes)
{
    static struct trial t;
    int wrong = 0;

    for (int i = 0; i < 200; i++) {
        some_grid(&t);
        const uint16_t *n = t.grid.size;
        const int at[3] = {(int)(random_bits() % n[0]), (int)(random_bits() % n[1]), (int)(random_bits() % n[2])};
        for (unsigned octant = 0; octant < 8; octant++) {
            int edge = t.empty[octant * n[0] * n[1] * n[2] + (unsigned)((at[2] * n[1] + at[1]) * n[0] + at[0])];
            wrong += !is_empty(&t, at, octant, edge);
            wrong += edge < SURE_GRID_FAR && is_empty(&t, at, octant, edge + 1);
        }
    }
    CHECK_MSG(wrong == 0, "%d cubes are wrong", wrong);
}

/* Meets the grid with or without cubes. */
static struct query met(struct trial *t, struct packet *p, bool leaps)
{
    static struct grid_walk walk;
    struct query q = {.p = p, .active = 1, .limit = INFINITE, .t = INFINITE, .low = INFINITE};

    t->sure.empty = leaps ? t->empty : NULL;
    meet_grid(&q, &t->sure, &walk);
    return q;
}

static bool is_decided(const struct query *q)
{
    return q->t + q->e < q->low || q->low >= INFINITE;
}

static void try_leap(struct trial *t, unsigned long *sure, unsigned long *open)
{
    struct packet p = {.o = v3_scale(v3_of(real_random()), 4 * some_part()), .d = v3_of(real_random())};
    double round = random_bits() % 4 ? 0 : 1;

    p.eo = some_size(12, 40);
    p.ed = some_size(12, 40);
    if (round > 0 && fabs(p.d.x) > 0.1 && fabs(p.d.y) > 0.1) { /* near edges between cells */
        p.d = v3_of(real_unit((struct real){{p.d.x > 0 ? 1 : -1, p.d.y > 0 ? 1 : -1, p.d.z}}));
        p.o.x = -1 + 0.25 * floor(8 * random_double()) + ldexp(random_double(), -20);
        p.o.y = 0.5 + 0.25 * floor(8 * random_double());
    }
    struct query a = met(t, &p, false), b = met(t, &p, true);
    if (!is_decided(&a) || !is_decided(&b)) {
        ++*open;
        return;
    }
    ++*sure;
    CHECK_MSG(a.t == b.t || fabs(a.t - b.t) <= a.e + b.e, "%.17g by steps, %.17g by leaps", a.t, b.t);
    CHECK_MSG((a.t >= INFINITE && b.t >= INFINITE) || a.element == b.element, "%g by steps, %g by leaps", a.element,
              b.element);
}

TEST(leaps)
{
    static struct trial t;
    unsigned long sure = 0, open = 0;

    for (int i = 0; i < 400; i++) {
        some_grid(&t);
        for (int k = 0; k < 200; k++)
            try_leap(&t, &sure, &open);
    }
    printf("# %lu sure, %lu open\n", sure, open);
    CHECK_MSG(sure > 10 * open, "%lu sure, %lu open", sure, open);
}

/* Compares a nearly level ray with another that is turned by its error, more level still. Both meet the same plane,
 * which is near their origin. */
static void try_turned(struct trial *t, unsigned long *sure)
{
    struct packet p = {.o = v3_scale(v3_of(real_random()), 2 * some_part()), .d = v3_of(real_random())}, turned;
    double side = some_sign();

    p.ed = ldexp(1, -6 - (int)(random_bits() % 8));
    p.d.x = side * p.ed * (1 + 3 * some_part());
    p.d = v3_of(real_unit(real_of(p.d)));
    p.o.x = -1 + 0.25 * floor(12 * some_part()) - 3 * p.d.x * some_part();
    struct real d = real_of(p.d), level = real_unit(real_along((struct real){{-side, 0, 0}}, d, side * d.v[0]));
    turned = p;
    turned.d = v3_of(real_turned(d, level, 0.9999L * p.ed));
    turned.ed = BOUND(CONVERTED);
    struct query a = met(t, &p, true), b = met(t, &turned, true);
    if (!is_decided(&a) || !is_decided(&b))
        return;
    ++*sure;
    CHECK_MSG((a.t >= INFINITE && b.t >= INFINITE) || fabs(a.t - b.t) <= a.e + b.e,
              "%.17g, and %.17g when turned by %g", a.t, b.t, p.ed);
}

TEST(turned_rays)
{
    static struct trial t;
    unsigned long sure = 0;

    for (int i = 0; i < 400; i++) {
        some_grid(&t);
        for (int k = 0; k < 200; k++)
            try_turned(&t, &sure);
    }
    CHECK_MSG(sure > 10000, "%lu sure", sure);
}

int main(void)
{
    (void)trace;
    float_mode_of_simd();
    RUN(cubes);
    RUN(leaps);
    RUN(turned_rays);
    return check_status();
}
