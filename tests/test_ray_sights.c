/* Distances of faces that the rasteriser has found, in src/simd/rays/plain_tmpl.h, against the fixed-point ones: planes
 * seen at any angle, and rays that are off as far as their bounds allow (see ray_steps.h). */
#include "one_lane.h"

#include "float_modes.h"
#include "raster/distance.h"
#include "raster/target.h"
#include "ray_steps.h"
#include "simd/rays/plain_tmpl.h"

enum { TRIES = 40000 };
#define WITHIN .9999L /* used part of a bound */

static int64_t some_coordinate(const struct tia_raster_grid *grid, int range)
{
    return (int64_t)ldexp(random_double(), range + grid->fraction);
}

/* Chooses a triangle and a pixel that sees its plane. Returns false if there is none. */
static bool choose(struct tia_raster_grid *grid, struct tia_raster_plane *plane, bool flat, int xy[2])
{
    int range = 1 + (int)(random_bits() % 16);
    struct tia_raster_vertex corner[3];

    CHECK_EQ(tia_raster_grid_init(grid, flat ? TIA_ORTHOGRAPHIC : TIA_PERSPECTIVE, 1920, 1080, 1, 0, (unsigned)range),
             TIA_OK);
    for (int i = 0; i < 3; i++) {
        int64_t far = some_coordinate(grid, range - 1), low = some_coordinate(grid, range - 1);
        far = far < 0 && !flat ? -far : far;
        corner[i] = (struct tia_raster_vertex){some_coordinate(grid, range - 1), low, far, 1};
        if (flat)
            corner[i] =
                (struct tia_raster_vertex){corner[i].x, low, INT64_C(1) << grid->fraction, far < 0 ? far : -far};
    }
    xy[0] = (int)(random_bits() % 1920);
    xy[1] = (int)(random_bits() % 1080);
    return !tia_raster_plane_init(plane, grid, corner, 3) && tia_plane_distance(plane, grid, xy[0], xy[1]) > 0;
}

static void try_sight(struct used *u, bool flat)
{
    const struct sure_camera camera = {.orthographic = flat};
    struct sure_seen_face face = {.object = 0};
    struct tia_raster_plane plane;
    struct tia_raster_grid grid;
    int xy[2];

    if (!choose(&grid, &plane, flat, xy))
        return;
    tia_sure_set_plane(&face, &plane, &grid);
    struct sight z = sight_of(camera.orthographic, v3_set(face.inverse), xy[0], xy[1]);
    int64_t exact = tia_plane_distance(&plane, &grid, xy[0], xy[1]);
    if (!mbits(z.fine) || face.object == TIA_NO_OBJECT || exact == INT64_C(1) << 62)
        u->open++;
    else
        use(u, z.z - (long double)exact * 0x1p-45L, z.e);
}

TEST(distances_along_the_line_of_sight)
{
    struct used round = {.name = "distance from the eye"}, flat = {.name = "distance from the window"};

    for (int i = 0; i < TRIES; i++) {
        try_sight(&round, false);
        try_sight(&flat, true);
    }
    check_used(&round);
    check_used(&flat);
}

/* The fixed-point ray is turned by ed in the plane of the line of sight, its distance along that line is off by z.e,
 * and its origin by eo. */
static void try_point(struct used *distances, struct used *points)
{
    struct real n = real_random(), d = real_unit(real_along(n, real_random(), -1.2L)), off = real_random();
    struct real aside = real_unit(real_along(n, d, -real_dot(n, d)));
    static struct sure_scene scene;
    struct packet p = {.d = v3_of(d), .ed = some_size(12, 45), .eo = some_size(20, 45)};
    struct sight z = {.z = ldexp(some_part() + .01, (int)(random_bits() % 12)), .e = some_size(12, 45), .fine = mof(1)};
    static struct query q;

    for (int i = 0; i < 3; i++)
        scene.camera.n[i] = (double)n.v[i];
    vm fine = meet_sights(&scene, &p, &z, &q);
    struct real theirs = real_turned(d, aside, p.ed * WITHIN * (long double)some_sign());
    long double t = (z.z + z.e * WITHIN * (long double)some_sign()) / -real_dot(n, theirs);
    if (!mbits(fine)) {
        distances->open++;
        return;
    }
    struct real mine = real_along((struct real){{0, 0, 0}}, d, q.t);
    use(distances, q.t - t, q.e);
    use(points, real_gap(real_along(real_along((struct real){{0, 0, 0}}, off, p.eo * WITHIN), theirs, t), v3_of(mine)),
        q.ep);
}

TEST(points_along_rays)
{
    struct used distances = {.name = "distance along the ray"}, points = {.name = "point"};

    for (int i = 0; i < TRIES; i++)
        try_point(&distances, &points);
    check_used(&distances);
    check_used(&points);
}

int main(void)
{
    (void)trace;
    (void)find_seen;
    (void)shade_plain;
    float_mode_of_simd();
    RUN(distances_along_the_line_of_sight);
    RUN(points_along_rays);
    return check_status();
}
