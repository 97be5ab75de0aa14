/* The distance of a plane at a pixel: against the definition in long double, for planes of all sizes. */
#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "random.h"
#include "raster/distance.h"
#include "raster/target.h"
#include <tia/raster.h>

struct real3 {
    long double x, y, z;
};

static struct real3 real(const struct tia_raster_vertex *v)
{
    return (struct real3){v->x, v->y, v->w};
}

static struct real3 cross(struct real3 a, struct real3 b)
{
    return (struct real3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static long double dot(struct real3 a, struct real3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/* Returns the nearness f/det of raster.h. */
static long double nearness(const struct tia_raster_vertex v[3], struct real3 d)
{
    struct real3 a = real(&v[0]), b = real(&v[1]), c = real(&v[2]), u = cross(b, c), s = cross(c, a), t = cross(a, b);

    return (v[0].h * dot(u, d) + v[1].h * dot(s, d) + v[2].h * dot(t, d)) / dot(u, a);
}

static int64_t any(unsigned bits)
{
    int64_t size = (int64_t)random_short(bits);
    return random_bits() & 1 ? -size : size;
}

static void check_plane(const struct tia_raster_grid *l, const struct tia_raster_vertex v[3], unsigned *seen)
{
    bool flat = l->projection == TIA_ORTHOGRAPHIC;
    struct tia_raster_plane plane;

    CHECK(!tia_raster_plane_init(&plane, l, v, 3));
    for (int i = 0; i < 20 && (plane.det[0] || plane.det[1]); i++) {
        int x = (int)(random_bits() % l->width), y = (int)(random_bits() % l->height);
        struct real3 d = {l->x + (long double)l->right * x, l->y - (long double)l->down * y, l->w};
        long double s = nearness(v, d), want = flat ? -s / l->w : l->w / s;
        want = ldexpl(want, flat ? TIA_DISTANCE_BITS : TIA_DISTANCE_BITS - l->fraction);
        int64_t got = tia_raster_distance(&plane, l, x, y);
        if (!isfinite(want) || want < 1)
            continue; /* behind the eye, or too close for a decision */
        if (want > ldexpl(1, 62))
            want = ldexpl(1, 62);
        CHECK_MSG(fabsl((long double)got - want) <= 1 + ldexpl(want, -44), "%jd, not %Lf", (intmax_t)got, want);
        ++*seen;
    }
}

/* Checks planes whose corners are on the image's edges, so that they are visible and long double loses few bits. */
static void check_planes(enum tia_projection projection)
{
    unsigned seen = 0;

    for (int i = 0; i < 2000; i++) {
        unsigned range = (unsigned)(random_bits() % 12);
        struct tia_raster_vertex v[3];
        struct tia_raster_grid l;
        CHECK(!tia_raster_grid_init(&l, projection, 1 + (unsigned)random_short(13), 1 + (unsigned)random_short(13), 1,
                                    0, range));
        bool flat = projection == TIA_ORTHOGRAPHIC;
        int64_t one = INT64_C(1) << l.fraction;
        for (int k = 0; k < 3; k++) {
            int64_t w = flat ? one : one / 4 + (int64_t)random_short((unsigned)l.fraction + range - 1);
            v[k] = (struct tia_raster_vertex){k == 0   ? -w
                                              : k == 1 ? w
                                                       : w / 5,
                                              k == 2 ? w : -w, w, flat ? any((unsigned)l.fraction + range - 1) : 1};
        }
        check_plane(&l, v, &seen);
    }
    CHECK_MSG(seen > 5000, "%u planes seen", seen);
}

/* A wall is at a known distance, straight ahead: in both projections every pixel has that distance. */
TEST(a_wall)
{
    for (int flat = 0; flat < 2; flat++) {
        struct tia_raster_plane plane;
        struct tia_raster_grid l;
        CHECK(!tia_raster_grid_init(&l, flat ? TIA_ORTHOGRAPHIC : TIA_PERSPECTIVE, 90, 70, 1, 0, 4));
        int64_t one = INT64_C(1) << l.fraction, far = 15 * one / 2, w = flat ? one : far, h = flat ? -far : 1;
        const struct tia_raster_vertex v[3] = {{-one, -one, w, h}, {one, -one, w, h}, {0, one, w, h}};
        CHECK(!tia_raster_plane_init(&plane, &l, v, 3));
        for (int x = 0; x < 90; x += 13)
            CHECK(llabs(tia_raster_distance(&plane, &l, x, x / 2) - (INT64_C(15) << 44)) <= 1);
    }
}

TEST(perspective)
{
    check_planes(TIA_PERSPECTIVE);
}

TEST(orthographic)
{
    check_planes(TIA_ORTHOGRAPHIC);
}

int main(void)
{
    RUN(a_wall);
    RUN(perspective);
    RUN(orthographic);
    return check_status();
}
