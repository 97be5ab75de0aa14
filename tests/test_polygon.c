/* Triangulation against areas and point-in-polygon tests in double. */
#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "random.h"
#include "read/triangulation.h"

#define MOST POLYGON_MAX

static struct polygon_corner corners[MOST];
static double plane[MOST][2]; /* the polygon in the plane, before it is placed in space */
static uint32_t triangles[MOST][3], triangle_count;

static uint32_t random_below(uint32_t limit)
{
    return random_u32() % limit;
}

/* The placement of the plane's x and y in space: their axes, their order, and the slopes of the third axis. */
struct placing {
    int u, v;
    double slope_u, slope_v;
};

static void put(uint32_t i, double x, double y, struct placing how)
{
    int w = 3 - how.u - how.v;
    tia_q16 at[3];

    at[how.u] = (tia_q16)lround(x);
    at[how.v] = (tia_q16)lround(y);
    at[w] = (tia_q16)lround(how.slope_u * x + how.slope_v * y);
    corners[i].point = (struct tia_vec3){at[0], at[1], at[2]};
    plane[i][0] = (double)at[how.u];
    plane[i][1] = (double)at[how.v];
}

static const struct placing placings[] = {{0, 1, 0, 0}, {1, 2, 0.5, -0.25}, {2, 0, 0.75, 0.75},
                                          {1, 0, 0, 1}, {2, 1, -0.9, 0},    {0, 2, 0.1, 0.2}};
#define PLACINGS (sizeof placings / sizeof *placings)

static void triangulate(uint32_t count)
{
    struct polygon polygon;

    triangle_count = 0;
    tia_polygon_begin(&polygon, corners, count);
    while (triangle_count < MOST && tia_polygon_next(&polygon, triangles[triangle_count]))
        triangle_count++;
}

static double cross(const double *a, const double *b, const double *c)
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

static double area_of_polygon(uint32_t count)
{
    double sum = 0;

    for (uint32_t i = 1; i + 1 < count; i++)
        sum += cross(plane[0], plane[i], plane[i + 1]);
    return sum;
}

/* True if the point is inside, by the even-odd rule; *unsure: it is too close to an edge. */
static bool is_inside(const double *p, uint32_t count, bool *unsure)
{
    bool inside = false;

    for (uint32_t i = 0, j = count - 1; i < count; j = i++) {
        const double *a = plane[i], *b = plane[j];
        double length = hypot(b[0] - a[0], b[1] - a[1]);
        if (length > 0 && fabs(cross(a, b, p)) < 0.01 * length)
            *unsure = true;
        if ((a[1] > p[1]) != (b[1] > p[1]) && p[0] < (b[0] - a[0]) * (p[1] - a[1]) / (b[1] - a[1]) + a[0])
            inside = !inside;
    }
    return inside;
}

static unsigned covers(const double *p)
{
    unsigned n = 0;

    for (uint32_t i = 0; i < triangle_count; i++) {
        const double *a = plane[triangles[i][0]], *b = plane[triangles[i][1]], *c = plane[triangles[i][2]];
        double ab = cross(a, b, p), bc = cross(b, c, p), ca = cross(c, a, p);
        n += (ab > 0 && bc > 0 && ca > 0) || (ab < 0 && bc < 0 && ca < 0);
    }
    return n;
}

static void check_points(uint32_t count, double low, double high)
{
    for (int n = 0; n < 20; n++) {
        bool unsure = false;
        double p[2] = {low + (high - low) * random_below(100000) / 1e5 + 0.137,
                       low + (high - low) * random_below(100000) / 1e5 + 0.371};
        bool inside = is_inside(p, count, &unsure);
        if (!unsure)
            CHECK_EQ(covers(p), inside);
    }
}

/* Checks that there are enough triangles, all in the polygon's order, and that their areas add up to its area. */
static void check_covered(uint32_t count, double low, double high)
{
    double whole = area_of_polygon(count), sum = 0;

    triangulate(count);
    CHECK_EQ(triangle_count, count - 2);
    for (uint32_t i = 0; i < triangle_count; i++) {
        const uint32_t *t = triangles[i];
        CHECK(t[0] < count && t[1] < count && t[2] < count);
        double area = cross(plane[t[0]], plane[t[1]], plane[t[2]]);
        CHECK_MSG(area * whole >= 0, "triangle %u of %u: area %g of %g", i, count - 2, area, whole);
        sum += area;
    }
    CHECK_MSG(fabs(sum - whole) <= 1e-9 * fabs(whole), "area %.17g, not %.17g", sum, whole);
    check_points(count, low, high);
}

/* Checks the triangles as check_covered does, and that none is degenerate. */
static void check_simple(uint32_t count, double low, double high)
{
    check_covered(count, low, high);
    for (uint32_t i = 0; i < triangle_count; i++)
        CHECK(cross(plane[triangles[i][0]], plane[triangles[i][1]], plane[triangles[i][2]]));
}

/* Makes corners at growing angles, at any distance. */
static void make_star(uint32_t count, double nearest, double farthest, struct placing how)
{
    for (uint32_t i = 0; i < count; i++) {
        double angle = 6.283185307179586 * (i + random_below(1000) / 1250.0) / count;
        double distance = nearest + (farthest - nearest) * random_below(1000) / 1e3;
        put(i, distance * cos(angle), distance * sin(angle), how);
    }
}

TEST(stars)
{
    for (int n = 0; n < 3000; n++) {
        uint32_t count = 5 + random_below(n % 10 ? 20 : 150);
        make_star(count, 1e5, 3e6, placings[(size_t)n % PLACINGS]);
        check_simple(count, -3e6, 3e6);
    }
}

/* Coordinates span the whole range: their differences need 33 bits. */
TEST(largest)
{
    for (int n = 0; n < 500; n++) {
        uint32_t count = 5 + random_below(30);
        make_star(count, 1e3, 2.147e9, placings[(n % 2) * 3]);
        check_simple(count, -2.1e9, 2.1e9);
    }
}

/* A skyline has steps of integers: right angles, flat corners, corners on the diagonals of others. */
TEST(skylines)
{
    for (int n = 0; n < 2000; n++) {
        uint32_t steps = 3 + random_below(20), count = 0;
        struct placing how = placings[(size_t)n % PLACINGS];

        for (uint32_t i = 0; i <= steps; i++)
            put(count++, i * 65536.0, 0, how);
        for (uint32_t i = steps; i-- > 0;) {
            double height = (1 + random_below(4)) * 65536.0;
            put(count, (i + 1) * 65536.0, height, how);
            count += i + 1 == steps || plane[count - 1][1] != height || plane[count - 1][0] != plane[count][0];
            put(count++, i * 65536.0, height, how);
        }
        check_simple(count, 0, 65536.0 * 5);
    }
}

/* Makes a spiral wall, which has few ears at a time, each of which may have all corners in view. Returns its number of
 * corners. */
static uint32_t make_spiral(uint32_t turns, struct placing how)
{
    uint32_t half = turns * 12;

    for (uint32_t i = 0; i < 2 * half; i++) {
        uint32_t step = i < half ? i : 2 * half - 1 - i;
        double distance = 65536.0 * (1 + step + (i < half ? 0 : 4)), angle = step * 0.5235987755982988;
        put(i, distance * cos(angle), distance * sin(angle), how);
    }
    return 2 * half;
}

TEST(spirals)
{
    for (uint32_t turns = 1; turns <= 20; turns++)
        check_simple(make_spiral(turns, placings[turns % PLACINGS]), -65536.0 * 12 * turns, 65536.0 * 12 * turns);
}

TEST(most_corners)
{
    make_star(MOST, 1e6, 2e9, placings[0]);
    check_simple(MOST, -2e9, 2e9);
    CHECK_EQ(make_spiral(170, placings[1]), 4080);
    check_simple(4080, -65536.0 * 2000, 65536.0 * 2000);
}

#define HOLE 8 /* number of corners of a hole */

/* Adds corners from..to of a hole, clockwise from its left, to `count` corners. Returns the number of corners then. */
static uint32_t go_around(uint32_t count, double (*hole)[2], uint32_t from, uint32_t to, struct placing how)
{
    for (uint32_t i = from; i <= to; i++)
        put(count++, hole[i % HOLE][0], hole[i % HOLE][1], how);
    return count;
}

/* Makes a frame with holes in a row, each reached by a bridge from the previous one, there and back through the same
 * points. Returns its number of corners. */
static uint32_t make_holes(uint32_t holes, struct placing how)
{
    static const int frame[][2] = {{-8, 0}, {-8, -6}, {1, -6}, {1, 6}, {-8, 6}, {-8, 0}};
    double hole[10][HOLE][2] = {{{0}}};
    uint32_t count = 0, exit[10];

    for (uint32_t i = 0; i < sizeof frame / sizeof *frame; i++)
        put(count++, (frame[i][0] > 0 ? holes * 10.0 : -8.0) * 65536.0, frame[i][1] * 65536.0, how);
    for (uint32_t n = 0; n < holes; n++) {
        exit[n] = n + 1 < holes ? HOLE / 2 : HOLE - 1; /* the last hole is left where it was entered */
        double height = 65.536 * random_below(1500);
        for (uint32_t i = 0; i < HOLE; i++) {
            double distance = 65.536 * (2000 + random_below(1000)),
                   angle = (0.5 - i / (double)HOLE) * 6.283185307179586;
            hole[n][i][0] = n * 655360.0 + distance * cos(angle);
            hole[n][i][1] = height + distance * sin(angle);
        }
        count = go_around(count, hole[n], 0, exit[n], how);
    }
    put(count++, hole[holes - 1][0][0], hole[holes - 1][0][1], how);
    for (uint32_t n = holes - 1; n-- > 0;)
        count = go_around(count, hole[n], exit[n], HOLE, how);
    return count;
}

TEST(holes)
{
    for (size_t n = 0; n < 3000; n++) {
        uint32_t holes = 1 + random_below(10), count = make_holes(holes, placings[n % PLACINGS]);
        check_simple(count, -8 * 65536.0, holes * 655360.0);
    }
}

/* With as few corners as possible, all ears are at the bridge. */
TEST(triangle_in_triangle)
{
    static const int at[][2] = {{0, 0}, {12, 0}, {0, 12}, {0, 0}, {1, 1}, {1, 9}, {9, 1}, {1, 1}};

    for (uint32_t first = 0; first < 8; first++) {
        for (uint32_t i = 0; i < 8; i++)
            put(i, at[(first + i) % 8][0] * 65536.0, at[(first + i) % 8][1] * 65536.0, placings[first % PLACINGS]);
        check_simple(8, 0, 12 * 65536.0);
    }
}

/* Petals lie around a point through which the polygon goes once for each petal. */
TEST(petals)
{
    for (int n = 0; n < 2000; n++) {
        uint32_t petals = 2 + random_below(6), count = 0;
        struct placing how = placings[(size_t)n % PLACINGS];

        for (uint32_t i = 0; i < petals; i++) {
            put(count++, 0, 0, how);
            for (int k = 0; k < 3; k++) {
                double angle = 0.9 * (i + (k + random_below(1000) / 1250.0) / 4),
                       distance = 1e6 + random_below(2000000);
                put(count++, distance * cos(angle), distance * sin(angle), how);
            }
        }
        check_covered(count, -3e6, 3e6);
    }
}

/* Checks that triangulation of a polygon that is not simple gives count - 2 triangles of different corners. */
static void check_ends(uint32_t count)
{
    triangulate(count);
    CHECK_EQ(triangle_count, count - 2);
    for (uint32_t i = 0; i < triangle_count; i++)
        for (int k = 0; k < 3; k++)
            CHECK(triangles[i][k] < count && triangles[i][k] != triangles[i][(k + 1) % 3]);
}

TEST(degenerate)
{
    for (uint32_t count = 3; count < 40; count++) {
        for (uint32_t i = 0; i < count; i++)
            put(i, 0, 0, placings[0]);
        check_ends(count);
        for (uint32_t i = 0; i < count; i++)
            put(i, i * 1000.0, i * 3000.0, placings[1]);
        check_ends(count);
        for (uint32_t i = 0; i < count; i++)
            put(i, i % 2 * 1000.0, i % 2 * 1000.0, placings[2]);
        check_ends(count);
    }
    for (uint32_t i = 0; i < MOST; i++)
        put(i, i % 3 * 1000.0, 0, placings[0]);
    check_ends(MOST);
}

TEST(self_crossing)
{
    for (int n = 0; n < 3000; n++) {
        uint32_t count = 4 + random_below(30), range = n % 2 ? 5 : 1000000;
        for (uint32_t i = 0; i < count; i++)
            put(i, random_below(range), random_below(range), placings[(size_t)n % PLACINGS]);
        check_ends(count);
    }
    for (uint32_t i = 0; i < MOST; i++)
        put(i, random_below(100000000), random_below(100000000), placings[0]);
    check_ends(MOST);
}

int main(void)
{
    RUN(stars);
    RUN(largest);
    RUN(skylines);
    RUN(spirals);
    RUN(most_corners);
    RUN(holes);
    RUN(triangle_in_triangle);
    RUN(petals);
    RUN(degenerate);
    RUN(self_crossing);
    return check_status();
}
