/* Shadow maps against textbook formulas in double precision: the distance in a texel, found by a ray through its
 * middle; a point's position in the map; and each bias and filter, from the map's distances. Comparisons that are too
 * close to distinguish rounding from a mistake are counted and left out. */
#include "raster/distance.h"
#include "shadow_map_world.h"

/* ---- the light's view ---- */

/* Returns the distance at which a ray enters the boxes, or infinity; *near is how close the ray passes to a silhouette.
 */
static double enter(const double from[3], const double d[3], double *near)
{
    double best = INFINITY;

    *near = INFINITY;
    for (int i = 0; i < BOXES; i++) {
        const struct tia_box *b = &w.shapes[i].box;
        const double low[3] = {b->min.x / 65536., b->min.y / 65536., b->min.z / 65536.};
        const double high[3] = {b->max.x / 65536., b->max.y / 65536., b->max.z / 65536.};
        double in = -INFINITY, out = INFINITY;
        for (int k = 0; k < 3; k++) {
            double a = (low[k] - w.zero[k] - from[k]) / d[k], c = (high[k] - w.zero[k] - from[k]) / d[k];
            in = fmax(in, fmin(a, c));
            out = fmin(out, fmax(a, c));
        }
        *near = fmin(*near, fabs(out - in));
        if (in < out && out > 0)
            best = fmin(best, in > 0 ? in : out);
    }
    return best;
}

/* Numbers of texels. Corners are rounded to 2^-22, and a side seen at an angle of 1/400 magnifies this error 400 times.
 */
struct tally {
    uint32_t texels, seen, unsure, wrong;
};

static void check_texel(const struct tia_map_view *view, int i, int j, struct tally *t)
{
    double axes[3][3], from[3], d[3], u = (i + 0.5 - SIZE / 2) / density(), v = (SIZE / 2 - j - 0.5) / density(), near;

    axes_of(view, axes);
    origin_of(from);
    for (int k = 0; k < 3; k++) {
        double across = u * axes[0][k] + v * axes[1][k];
        d[k] = axes[2][k] + (w.map.parallel ? 0 : across);
        from[k] += w.map.parallel ? across - axes[2][k] : 0;
    }
    double want = enter(from, d, &near) - w.map.parallel;
    uint32_t got = view->distance[j * SIZE + i];
    double distance = ldexp((double)got, w.map.coarse) * unit;
    bool sure = near > 1e-3;
    t->texels++;
    t->seen += isfinite(want);
    t->unsure += !sure;
    t->wrong += sure && (isfinite(want) ? fabs(distance - want) > 1e-4 : got != TIA_MAP_NOTHING);
}

static void check_views(enum tia_light_kind kind, double outer, unsigned views)
{
    struct tally t = {0};

    for (int round = 0; round < 12; round++) {
        make_scene(round % 2 ? TIA_ORTHOGRAPHIC : TIA_PERSPECTIVE);
        make_light(kind, outer);
        make_map(2);
        CHECK_EQ(w.map.view_count, w.map.parallel ? 1 : views); /* a distant light's rays count as parallel */
        for (unsigned n = 0; n < w.map.view_count; n++)
            for (int at = 0; at < SIZE * SIZE; at++)
                check_texel(&w.map.view[n], at % SIZE, at / SIZE, &t);
        unmake();
    }
    CHECK_EQ(t.wrong, 0);
    CHECK_MSG(t.seen > t.texels / 100 && t.unsure < t.seen / 20, "of %u texels %u see a box, %u are not sure", t.texels,
              t.seen, t.unsure);
}

TEST(distances)
{
    check_views(TIA_DIRECTIONAL_LIGHT, 0, 1);
    check_views(TIA_SPOT_LIGHT, 25, 1);
    check_views(TIA_SPOT_LIGHT, 75, 6);
    check_views(TIA_POINT_LIGHT, 0, 6);
}

/* ---- the pixel's view ---- */

TEST(places)
{
    for (int round = 0; round < 20; round++) {
        make_scene(round % 2 ? TIA_ORTHOGRAPHIC : TIA_PERSPECTIVE);
        make_light(TIA_POINT_LIGHT, 0);
        make_map(1);
        int x = (int)(random_bits() % 80), y = (int)(random_bits() % 60);
        double far = any(1, 12), half = round % 2 ? 3.25 : far * tan(25 * M_PI / 180);
        double right = (x + 0.5 - 40) / 30 * half, up = (30 - y - 0.5) / 30 * half;
        int64_t place[3];
        tia_world_seen(&w.world, x, y, (int64_t)ldexp(far, TIA_DISTANCE_BITS), place);
        for (int k = 0; k < 3; k++) {
            double there = right * w.axes[0][k] + up * w.axes[1][k] - far * w.axes[2][k];
            CHECK_MSG(fabs((double)place[k] * unit - there) < 1e-6, "%d: %g, not %g", k, (double)place[k] * unit,
                      there);
        }
        unmake();
    }
}

/* ---- biases and filters ---- */

struct asked {
    const struct point *point;
    struct found at;
    double limit, slack;
    bool plane, unsure;
};

static struct asked ask(const struct point *p, enum tia_bias bias, double amount)
{
    struct asked a = {.point = p, .at = find(p->place), .plane = bias == TIA_BIAS_PLANE};
    double way[3], origin[3], axes[3][3], moved[3];

    origin_of(origin);
    axes_of(&w.map.view[0], axes);
    for (int k = 0; k < 3; k++)
        way[k] = w.map.parallel ? -axes[2][k] : origin[k] - p->place[k];
    double c = dot(way, p->normal) / sqrt(dot(way, way));
    a.slack = bias == TIA_BIAS_NONE ? 0 : bias == TIA_BIAS_CONSTANT ? amount : amount * a.at.texel;
    if (bias == TIA_BIAS_SLOPE)
        a.slack *= 1 + fmin(50, sqrt(1 - c * c) / c);
    for (int k = 0; k < 3; k++)
        moved[k] = p->place[k] + a.slack * p->normal[k];
    if (bias == TIA_BIAS_NORMAL) {
        a.at = find(moved);
        a.slack = 0;
    }
    a.limit = a.at.distance - a.slack;
    return a;
}

static bool tap(struct asked *a, double u, double v)
{
    int i = (int)floor(u), j = (int)floor(v), last = SIZE - 1;

    if (fabs(u - nearbyint(u)) < 1e-4 || fabs(v - nearbyint(v)) < 1e-4)
        a->unsure = true;
    if (w.map.view_count == 1 && (i < 0 || j < 0 || i > last || j > last))
        return true;
    i = i < 0 ? 0 : i > last ? last : i;
    j = j < 0 ? 0 : j > last ? last : j;
    uint32_t there = a->at.view->distance[j * SIZE + i];
    double limit = a->limit, plane = plane_at(a->point, &a->at, i, j);
    if (a->plane && plane > 0)
        limit = plane - a->slack;
    if (there == TIA_MAP_NOTHING)
        return true;
    double distance = ldexp((double)there, w.map.coarse) * unit;
    if (fabs(distance - limit) < 1e-4 * fmax(1, limit))
        a->unsure = true;
    return distance >= limit;
}

static double square(struct asked *a, int half)
{
    int lit = 0;

    for (int y = -half; y <= half; y++)
        for (int x = -half; x <= half; x++)
            lit += tap(a, a->at.u + x, a->at.v + y);
    return lit / pow(2 * half + 1, 2);
}

static double bilinear(struct asked *a)
{
    double u = a->at.u - 0.5, v = a->at.v - 0.5, x = u - floor(u), y = v - floor(v), sum = 0;

    for (int i = 0; i < 4; i++)
        sum += tap(a, floor(u) + i % 2 + 0.5, floor(v) + i / 2 + 0.5) * (i % 2 ? x : 1 - x) * (i / 2 ? y : 1 - y);
    return sum;
}

static double pcss(struct asked *a, double radius)
{
    double texels = radius / a->at.texel, sum = 0, reach = fmin(SIZE / 8, floor(texels) + 1),
           step = reach > 4 ? floor(reach / 4) : 1;
    int blockers = 0, lit = 0, taps = 0;

    for (double y = -reach; y <= reach; y += step)
        for (double x = -reach; x <= reach; x += step)
            if (!tap(a, a->at.u + x, a->at.v + y)) {
                int i = (int)floor(a->at.u + x), j = (int)floor(a->at.v + y), last = SIZE - 1;
                i = i < 0 ? 0 : i > last ? last : i;
                j = j < 0 ? 0 : j > last ? last : j;
                sum += ldexp((double)a->at.view->distance[j * SIZE + i], w.map.coarse) * unit;
                blockers++;
            }
    if (!blockers)
        return 1;
    double wide = texels * fmax(0, a->at.distance - sum / blockers) / (sum / blockers),
           k = fmin(SIZE / 8, floor(wide + 0.5));
    if (fabs(wide + 0.5 - nearbyint(wide + 0.5)) < 1e-3)
        a->unsure = true;
    if (k < 1)
        return bilinear(a);
    step = k > 4 ? floor(k / 4) : 1;
    for (double y = -k; y <= k; y += step)
        for (double x = -k; x <= k; x += step)
            if (x * x + y * y <= k * (k + 1)) {
                lit += tap(a, a->at.u + x, a->at.v + y);
                taps++;
            }
    return (double)lit / taps;
}

#define RADIUS 0.4

static double filtered(struct asked *a, enum tia_filter filter)
{
    switch (filter) {
    case TIA_FILTER_BILINEAR:
        return bilinear(a);
    case TIA_FILTER_3X3:
        return square(a, 1);
    case TIA_FILTER_5X5:
        return square(a, 2);
    case TIA_FILTER_7X7:
        return square(a, 3);
    case TIA_FILTER_PCSS:
        return pcss(a, RADIUS);
    default:
        return tap(a, a->at.u, a->at.v);
    }
}

struct sums {
    uint32_t points, sure, dark, partly;
};

static void compare(enum tia_bias bias, enum tia_filter filter, double amount, struct sums *sums)
{
    struct point p;
    int64_t place[3];
    struct tia_map_point point = {.map = &w.map, .world = &w.world};
    struct tia_map_look look = {SIZE, bias, (int64_t)(bias == TIA_BIAS_CONSTANT ? amount / unit : amount * 65536),
                                filter};

    if (!any_point(&p))
        return;
    for (int k = 0; k < 3; k++)
        place[k] = (int64_t)floor(p.place[k] / unit + 0.5);
    tia_map_face(&point, &w.at, p.face);
    tia_map_place(&point, &look, place);
    unsigned share = tia_map_share(&point, filter, (int64_t)(RADIUS / unit), 0);
    struct asked a = ask(&p, bias, amount);
    double want = filtered(&a, filter), got = share / (double)TIA_SHARE_ALL;
    sums->points++;
    if (a.unsure)
        return;
    sums->sure++;
    sums->dark += want < 0.01;
    sums->partly += want > 0.01 && want < 0.99;
    CHECK_MSG(fabs(got - want) < (filter == TIA_FILTER_BILINEAR || filter == TIA_FILTER_PCSS ? 0.01 : 1e-4),
              "bias %d, filter %d: %g, not %g", (int)bias, (int)filter, got, want);
}

static void check_looks(enum tia_light_kind kind, double outer)
{
    static const double amounts[] = {0, 0, 0.05, 1.25, 1.5, 0.75};

    for (int bias = TIA_BIAS_NONE; bias <= TIA_BIAS_PLANE; bias++) {
        struct sums sums = {0};
        for (int round = 0; round < 12; round++) {
            make_scene(round % 2 ? TIA_ORTHOGRAPHIC : TIA_PERSPECTIVE);
            make_light(kind, outer);
            make_map(3);
            for (int i = 0; i < 600; i++)
                compare((enum tia_bias)bias,
                        (enum tia_filter)(i % 6 == 5 ? TIA_FILTER_PCSS : (int)TIA_FILTER_NONE + i % 6), amounts[bias],
                        &sums);
            unmake();
        }
        CHECK_MSG(sums.sure > sums.points * 3 / 5 && sums.dark > sums.points / 20 && sums.partly > sums.points / 50,
                  "bias %d: of %u points %u are sure, %u dark, %u partly lit", bias, sums.points, sums.sure, sums.dark,
                  sums.partly);
    }
}

TEST(looks)
{
    check_looks(TIA_DIRECTIONAL_LIGHT, 0);
    check_looks(TIA_SPOT_LIGHT, 25);
    check_looks(TIA_POINT_LIGHT, 0);
}

/* The 16 taps lie within 3.6 texels; turned patterns give shares in sixteenths. */

TEST(poisson)
{
    struct tia_map_point point = {.map = &w.map, .world = &w.world};
    unsigned shares[8] = {0};
    static uint32_t texels[SIZE * SIZE];

    w.map = (struct tia_map){.view_count = 1, .size = SIZE};
    w.map.view[0].distance = texels;
    point.spot = (struct tia_map_spot){.view = &w.map.view[0], .u = 32 << 16 | 32768, .v = 32 << 16 | 32768};
    point.limit = 5;
    for (int i = 0; i < SIZE * SIZE; i++)
        texels[i] = hypot(i % SIZE - 32, i / SIZE - 32) < 3.6 ? 9 : 1; /* lit within this radius */
    for (unsigned turn = 0; turn < 8; turn++)
        CHECK_EQ(tia_map_share(&point, TIA_FILTER_POISSON, 0, turn), TIA_SHARE_ALL);
    for (int i = 0; i < SIZE * SIZE; i++)
        texels[i] = i % SIZE < 32 ? 1 : 9;
    for (unsigned turn = 0; turn < 8; turn++) {
        shares[turn] = tia_map_share(&point, TIA_FILTER_POISSON, 0, turn);
        CHECK(shares[turn] % (TIA_SHARE_ALL / 16) == 0);
        CHECK(shares[turn] > TIA_SHARE_ALL / 4 && shares[turn] < TIA_SHARE_ALL);
    }
    CHECK(shares[0] != shares[1] || shares[1] != shares[2] || shares[2] != shares[3]);
}

static bool stop_at_once(void *ctx)
{
    ++*(unsigned *)ctx;
    return true;
}

TEST(stops)
{
    unsigned asked = 0;
    struct cancel cancel = {.stop = stop_at_once, .ctx = &asked};

    make_scene(TIA_PERSPECTIVE);
    make_light(TIA_POINT_LIGHT, 0);
    make_map(1);
    w.map.size = 4096; /* a band of this map is so much work that the first one is not finished */
    void *room = malloc((size_t)tia_map_room(4096, w.flat.face_count));
    CHECK(!tia_map_init(&w.map, &w.world, &(struct tia_map_light){&w.light, w.at}, 4096, 1));
    CHECK_EQ(tia_map_draw(&w.map, &w.flat, room, NULL, &cancel), TIA_STOPPED);
    CHECK_EQ(asked, 1);
    free(room);
    unmake();
}

int main(void)
{
    RUN(distances);
    RUN(places);
    RUN(looks);
    RUN(poisson);
    RUN(stops);
    return check_status();
}
