/* The ranges of src/raster/ranges.h, at their ends: coordinates at the limit are drawn as by the oracle, and the next
 * one is refused; polygons that need all of 64 bits have the bits of the format in 128; no quantity is larger than
 * stated. The quantities are linear in each coordinate, so they are largest where each is at an end. */
#include "raster/target.h"
#include "raster_random.h"

#include "raster/depth.h"
#include "raster/ranges.h"

#define CORNERS 3
#define PLACES 5 /* pixels: the image's corners and its middle */

static struct tia_tile whole_of(const struct tia_raster_grid *l)
{
    return (struct tia_tile){0, 0, l->width, l->height};
}

static int64_t limit_of(bool flat)
{
    return INT64_C(1) << (flat ? FLAT_POINT : RASTER_POINT);
}

/* Gives the image's outermost pixels, for n from 0 on, and one in its middle. */
static void place(const struct tia_raster_grid *l, unsigned n, int *x, int *y)
{
    *x = n == 4 ? l->width / 2 : n & 1 ? l->width - 1 : 0;
    *y = n == 4 ? l->height / 2 : n & 2 ? l->height - 1 : 0;
}

/* Makes corners whose coordinates are `most` or -most by the bits of `signs`, twice as much for directions. */
static void make_extreme(struct tia_raster_vertex v[CORNERS], const struct tia_raster_grid *l, unsigned signs,
                         unsigned directions, int64_t most)
{
    bool flat = l->projection == TIA_ORTHOGRAPHIC;

    for (unsigned i = 0; i < CORNERS; i++) {
        bool direction = directions >> i & 1;
        int64_t size = direction ? 2 * most : most, c[3];
        for (unsigned k = 0; k < 3; k++)
            c[k] = signs >> (3 * i + k) & 1 ? -size : size;
        v[i] = (struct tia_raster_vertex){c[0], c[1], c[2], !direction};
        if (flat)
            v[i] = (struct tia_raster_vertex){c[0], c[1], direction ? 0 : most,
                                              c[2] < 0 ? -2 * limit_of(true) : 2 * limit_of(true)};
    }
}

static void init_lattice(struct tia_raster_grid *l, bool flat, unsigned width, unsigned height, uint32_t samples)
{
    CHECK_EQ(tia_raster_grid_init(l, flat ? TIA_ORTHOGRAPHIC : TIA_PERSPECTIVE, width, height, samples, samples - 1, 0),
             TIA_OK);
}

/* ---- limits ---- */

static int draw_one(const struct tia_raster_grid *l, const struct tia_raster_vertex v[CORNERS])
{
    struct tia_raster_plane plane;

    return tia_raster_plane_init(&plane, l, v, CORNERS);
}

/* Draws a triangle whose corner 1 has coordinate `k`, of which h is the last, at `value`; the others are small. */
static int draw_with(const struct tia_raster_grid *l, unsigned k, bool direction, int64_t value)
{
    bool flat = l->projection == TIA_ORTHOGRAPHIC;
    int64_t one = flat ? INT64_C(1) << l->fraction : 1000;
    struct tia_raster_vertex v[CORNERS] = {{-900, -800, one, 1}, {900, -700, one, 1}, {10, 900, one, 1}};

    v[1].h = !direction;
    v[1].w = flat && direction ? 0 : one;
    *(k == 0 ? &v[1].x : k == 1 ? &v[1].y : k == 2 ? &v[1].w : &v[1].h) = value;
    return draw_one(l, v);
}

static void check_limits(bool flat)
{
    struct tia_raster_grid l;

    init_lattice(&l, flat, 640, 480, 1);
    for (unsigned i = 0; i < 12; i++) {
        unsigned k = i % 3;
        bool direction = i / 3 % 2, negative = i / 6;
        if (flat && k == 2 && direction)
            continue; /* w = 0 makes it a direction */
        int64_t limit = limit_of(flat) << direction, sign = negative ? -1 : 1;
        CHECK_EQ(draw_with(&l, k, direction, sign * (limit - 1)), TIA_OK);
        CHECK_EQ(draw_with(&l, k, direction, sign * limit), TIA_ERR_RANGE);
        CHECK_EQ(draw_with(&l, k, direction, sign * INT64_MAX), TIA_ERR_RANGE);
    }
    int64_t most = flat ? 2 * limit_of(true) : 1, least = flat ? -most : 0;
    CHECK_EQ(draw_with(&l, 3, false, most), TIA_OK);
    CHECK_EQ(draw_with(&l, 3, false, most + 1), TIA_ERR_RANGE);
    CHECK_EQ(draw_with(&l, 3, false, least), TIA_OK);
    CHECK_EQ(draw_with(&l, 3, false, least - 1), TIA_ERR_RANGE);
}

TEST(limits_are_accepted_and_the_next_is_refused)
{
    CHECK_EQ(limit_of(false), INT64_C(1) << 40); /* the limits of tia/raster.h */
    CHECK_EQ(limit_of(true), INT64_C(1) << 29);
    check_limits(false);
    check_limits(true);
}

TEST(images_and_ranges_beyond_are_refused)
{
    struct tia_raster_grid l;

    CHECK_EQ(tia_raster_grid_init(&l, TIA_PERSPECTIVE, TIA_SIZE_MAX, TIA_SIZE_MAX, 16, 15, 24), TIA_OK);
    CHECK_EQ(tia_raster_grid_init(&l, TIA_PERSPECTIVE, TIA_SIZE_MAX + 1, 1, 1, 0, 20), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_raster_grid_init(&l, TIA_PERSPECTIVE, 1, TIA_SIZE_MAX + 1, 1, 0, 20), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_raster_grid_init(&l, TIA_PERSPECTIVE, 1, 1, 1, 0, 25), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_raster_grid_init(&l, TIA_PERSPECTIVE, 1, 1, 2, 0, 0), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_raster_grid_init(&l, TIA_PERSPECTIVE, 1, 1, 4, 4, 0), TIA_ERR_ARGUMENT);
}

/* The vectors D of the outermost pixels of the largest images are at most 2^RASTER_PIXEL, and above half of it. */
TEST(pixels_reach_their_bound)
{
    static const uint16_t sizes[][2] = {{8192, 8191}, {8191, 8192}, {8192, 8192}, {8191, 8191}, {1, 8192}, {8192, 1}};
    int64_t most = 0;

    for (unsigned s = 0; s < sizeof sizes / sizeof *sizes; s++)
        for (uint32_t samples = 1; samples <= 16; samples *= 4)
            for (unsigned n = 0; n < PLACES; n++) {
                struct tia_raster_grid l;
                int x, y;
                init_lattice(&l, false, sizes[s][0], sizes[s][1], samples);
                place(&l, n, &x, &y);
                int64_t d[3] = {l.x + (int64_t)l.right * x, l.y - (int64_t)l.down * y, l.w};
                for (int k = 0; k < 3; k++)
                    most = llabs(d[k]) > most ? llabs(d[k]) : most;
            }
    CHECK(most <= INT64_C(1) << RASTER_PIXEL);
    CHECK(most > INT64_C(1) << (RASTER_PIXEL - 1));
}

/* ---- 64 bits ---- */

static struct wide_form form_of(const struct polygon *p, int edge)
{
    if (!p->narrow)
        return edge < 0 ? p->of.wide_forms.plane : p->of.wide_forms.edge[edge];
    const struct narrow_form *f = edge < 0 ? &p->of.narrow_forms.plane : &p->of.narrow_forms.edge[edge];
    return (struct wide_form){wide_product(f->x, 1), wide_product(f->y, 1), wide_product(f->c, 1)};
}

static int64_t narrow_at(const struct polygon *p, int edge, int x, int y)
{
    return narrow_form_at(edge < 0 ? &p->of.narrow_forms.plane : &p->of.narrow_forms.edge[edge], x, y);
}

/* Compares the plane and the edges at the image's corners with those in 64 bits. Returns the number of their bits. */
static int compare_formats(const struct tia_raster_grid *l, const struct tia_raster_vertex v[CORNERS])
{
    struct tia_raster_grid any = *l;
    struct polygon narrow, other;
    int most = 0;

    any.narrow = -1;
    CHECK_EQ(tia_polygon_init(&narrow, l, whole_of(l), v, CORNERS), TIA_OK);
    CHECK_EQ(tia_polygon_init(&other, &any, whole_of(l), v, CORNERS), TIA_OK);
    CHECK_EQ(narrow.count, other.count);
    if (!narrow.count)
        return 0;
    CHECK(narrow.narrow && !other.narrow);
    CHECK(!wide_sign(wide_difference(narrow.det, other.det)) && narrow.front == other.front);
    for (int edge = -1; edge < CORNERS; edge++)
        for (unsigned n = 0; n < PLACES; n++) {
            struct wide_form f = form_of(&other, edge);
            int x, y, bits;
            place(l, n, &x, &y);
            bits = wide_bits(wide_size(wide_form_at(&f, x, y)));
            CHECK(!wide_sign(wide_difference(wide_form_at(&f, x, y), wide_product(narrow_at(&narrow, edge, x, y), 1))));
            most = bits > most ? bits : most;
        }
    return most;
}

static int try_narrow(unsigned width, unsigned height, int64_t more)
{
    struct tia_raster_vertex v[CORNERS];
    struct tia_raster_grid l;
    int most = 0;

    init_lattice(&l, false, width, height, 1);
    for (unsigned n = 0; n < 512 * 8; n++) {
        unsigned directions = n / 512;
        make_extreme(v, &l, n % 512, directions, directions ? (l.narrow + more) / 2 : l.narrow + more);
        int bits = compare_formats(&l, v);
        most = bits > most ? bits : most;
    }
    return most;
}

/* Polygons that fit have the same bits in both formats, up to all 63; one more bit is drawn in 128. */
TEST(sixty_four_bits_are_used_to_the_last)
{
    struct tia_raster_vertex v[CORNERS];
    struct tia_raster_grid l;
    struct polygon p;

    CHECK_EQ(try_narrow(640, 480, 0), 63);
    CHECK_EQ(try_narrow(479, 331, 0), 63);
    CHECK_EQ(try_narrow(8192, 8191, 0), 63);
    CHECK(try_narrow(1, 8192, -1) >= 62);
    init_lattice(&l, false, 640, 480, 1);
    make_extreme(v, &l, 0x0aa, 0, l.narrow + 1);
    CHECK_EQ(tia_polygon_init(&p, &l, whole_of(&l), v, CORNERS), TIA_OK);
    CHECK(!p.narrow);
}

/* ---- 128 bits ---- */

static void check_bits(const char *what, int most, int stated)
{
    CHECK_MSG(most <= stated && most >= stated - 3, "%s has %d bits, stated %d", what, most, stated);
}

/* Number of pairs of triangles whose order was compared with the oracle's, at PLACES pixels each. */
static unsigned compared;

static void compare_order(const struct tia_raster_grid *l, const struct oracle_image *image,
                          const struct tia_raster_vertex a[CORNERS], const struct tia_raster_vertex b[CORNERS])
{
    struct tia_raster_plane plane;
    struct polygon p;

    CHECK_EQ(tia_raster_plane_init(&plane, l, b, CORNERS), TIA_OK);
    CHECK_EQ(tia_polygon_init(&p, l, whole_of(l), a, CORNERS), TIA_OK);
    if (!p.count || !(plane.det[0] | plane.det[1]))
        return;
    compared++;
    for (unsigned n = 0; n < PLACES; n++) {
        int x, y;
        place(l, n, &x, &y);
        CHECK_EQ(tia_depth_order(&p, &plane, x, y), oracle_order(image, a, b, x, y));
        bool covered = true;
        for (unsigned edge = 0; edge < CORNERS; edge++)
            covered = covered && polygon_edge_covers(&p, edge, x, y);
        CHECK_EQ(covered, oracle_covers(image, a, CORNERS, x, y));
    }
}

struct sizes {
    int normal, edge, plane, det;
};

static void measure(struct sizes *s, const struct tia_raster_grid *l, const struct tia_raster_vertex v[CORNERS])
{
    int64_t a[3] = {v[0].x, v[0].y, v[0].w}, b[3] = {v[1].x, v[1].y, v[1].w};
    struct polygon p;
    wide n[3];

    wide_cross(a, b, n);
    for (int k = 0; k < 3; k++)
        s->normal = wide_bits(wide_size(n[k])) > s->normal ? wide_bits(wide_size(n[k])) : s->normal;
    CHECK_EQ(tia_polygon_init(&p, l, whole_of(l), v, CORNERS), TIA_OK);
    if (!p.count)
        return;
    s->det = wide_bits(p.det) > s->det ? wide_bits(p.det) : s->det;
    for (int edge = -1; edge < CORNERS; edge++)
        for (unsigned i = 0; i < PLACES; i++) {
            struct wide_form f = form_of(&p, edge);
            int x, y, *most = edge < 0 ? &s->plane : &s->edge;
            place(l, i, &x, &y);
            int bits = wide_bits(wide_size(wide_form_at(&f, x, y)));
            *most = bits > *most ? bits : *most;
        }
}

static struct sizes try_wide(bool flat)
{
    const struct oracle_image image = {flat ? TIA_ORTHOGRAPHIC : TIA_PERSPECTIVE, 8192, 8191, 16, 15};
    struct tia_raster_vertex v[CORNERS], before[CORNERS];
    struct sizes most = {0, 0, 0, 0};
    struct tia_raster_grid l;

    compared = 0;
    init_lattice(&l, flat, 8192, 8191, 16);
    make_extreme(before, &l, 0x155, 0, limit_of(flat) - 1);
    for (unsigned n = 0; n < 512 * 8; n++) {
        make_extreme(v, &l, n % 512, n / 512, limit_of(flat) - 1);
        measure(&most, &l, v);
        compare_order(&l, &image, v, before);
        if (n % 7 == 0)
            memcpy(before, v, sizeof v);
    }
    CHECK_MSG(compared > 400, "only %u triangles are compared", compared);
    return most;
}

/* Checks the sizes of numbers; `stated` has the bits of a normal, an edge, a plane and a determinant. */
static void check_sizes(bool flat, struct sizes stated)
{
    struct sizes most = try_wide(flat);

    check_bits("a normal", most.normal, stated.normal);
    check_bits("an edge", most.edge, stated.edge);
    check_bits("a plane", most.plane, stated.plane);
    check_bits("a determinant", most.det, stated.det);
}

TEST(all_of_perspective_fits)
{
    check_sizes(false, (struct sizes){RASTER_NORMAL, RASTER_EDGE, RASTER_PLANE, RASTER_DET});
}

TEST(all_of_orthographic_views_fits)
{
    check_sizes(true, (struct sizes){FLAT_NORMAL, FLAT_EDGE, FLAT_PLANE, FLAT_DET});
}

int main(void)
{
    RUN(limits_are_accepted_and_the_next_is_refused);
    RUN(images_and_ranges_beyond_are_refused);
    RUN(pixels_reach_their_bound);
    RUN(sixty_four_bits_are_used_to_the_last);
    RUN(all_of_perspective_fits);
    RUN(all_of_orthographic_views_fits);
    return check_status();
}
