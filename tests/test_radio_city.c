/* Paths between random blocks of houses: rays and images find the same as the oracle. */
#include <math.h>

#include "oracle/radio.h"
#include "radio/search.h"
#include "radio_world.h"
#include "random.h"

enum { CITIES = 50, LINKS = 4, HOUSES = 5, POLYGONS = 1 + 6 * HOUSES + 2, DENSITY = 128 };

static struct world w;
static struct oracle_polygon polygons[POLYGONS];
static int polygon_count;

static double random_unit(void)
{
    return (random_double() + 1) / 2;
}

/* Returns a multiple of 1/64, exact in either format. */
static double grid(double low, double high)
{
    return low + floor((high - low) * 64 * random_unit()) / 64;
}

static void add_polygon(const double corners[4][3], int count, bool solid)
{
    struct oracle_polygon *p = &polygons[polygon_count++];

    p->count = count;
    p->solid = solid;
    memcpy(p->corner, corners, sizeof p->corner);
}

static void add_house(const double low[3], const double high[3])
{
    world_box(&w, world_at(low[0], low[1], low[2]), world_at(high[0], high[1], high[2]));
    for (int k = 0; k < 3; k++)
        for (int side = 0; side < 2; side++) {
            int u = (k + 1) % 3, v = (k + 2) % 3;
            double c[4][3];
            for (int i = 0; i < 4; i++) {
                bool far_u = i == 1 || i == 2, far_v = i >= 2;
                c[i][k] = side ? high[k] : low[k];
                c[i][u] = (side ? far_u : far_v) ? high[u] : low[u];
                c[i][v] = (side ? far_v : far_u) ? high[v] : low[v];
            }
            add_polygon((const double(*)[3])c, 4, true);
        }
}

static void add_roof(void)
{
    double c[4][3] = {{0}};

    for (int i = 0; i < 3; i++) {
        c[i][0] = grid(0, 40);
        c[i][1] = grid(4, 20);
        c[i][2] = grid(0, 40);
    }
    world_triangle(&w, world_at(c[0][0], c[0][1], c[0][2]), world_at(c[1][0], c[1][1], c[1][2]),
                   world_at(c[2][0], c[2][1], c[2][2]));
    add_polygon((const double(*)[3])c, 3, false);
}

/* Builds houses of random sizes on a square, with a ground and two slanting triangles in the air. */
static void build_city(unsigned number)
{
    const double ground[4][3] = {{-30, 0, -30}, {-30, 0, 70}, {70, 0, 70}, {70, 0, -30}};

    random_state = 1000 + number;
    world_begin(&w);
    polygon_count = 0;
    world_triangle(&w, world_at(-30, 0, -30), world_at(-30, 0, 70), world_at(70, 0, 70));
    world_triangle(&w, world_at(-30, 0, -30), world_at(70, 0, 70), world_at(70, 0, -30));
    add_polygon(ground, 4, false);
    for (int i = 0; i < HOUSES; i++) {
        double low[3] = {grid(0, 30), 0.25, grid(0, 30)}, high[3];
        for (int k = 0; k < 3; k++)
            high[k] = low[k] + grid(2, k == 1 ? 25 : 10);
        add_house(low, high);
    }
    add_roof();
    add_roof();
    CHECK(world_build(&w));
}

static struct tia_vec3 place_outside(double at[3])
{
    struct tia_vec3 place;

    do {
        for (int k = 0; k < 3; k++)
            at[k] = grid(0.5, k == 1 ? 20 : 40);
        place = world_at(at[0], at[1], at[2]);
    } while (tia_radio_inside(w.radio, place) != TIA_RADIO_NO_OBJECT);
    return place;
}

static bool is_same(const struct oracle_path *want, const struct tia_radio_path *got)
{
    bool same = want->order == (int)got->order && fabs(want->length - world_length(got)) < 1e-9;

    for (uint32_t i = 0; i < got->order && same; i++) {
        const double at[3] = {got->point[i].x / 65536.0, got->point[i].y / 65536.0, got->point[i].z / 65536.0};
        for (int k = 0; k < 3; k++)
            same &= fabs(want->point[i][k] - at[k]) < 1e-5;
    }
    return same;
}

static struct oracle_path want[WORLD_PATHS];
static unsigned total, unsure;

/* Compares the paths between two random points with the oracle's. Only paths of which the oracle is not sure may be
 * missing. */
static void compare_link(unsigned city, unsigned order)
{
    double from[3], to[3];
    struct tia_vec3 a = place_outside(from), b = place_outside(to);
    unsigned count = world_images(&w, a, b, order, 0);
    int wanted = oracle_radio(polygons, polygon_count, from, to, (int)order, 1e-7, want, WORLD_PATHS);

    for (unsigned i = 0; i < count; i++) {
        bool found = false;
        for (int k = 0; k < wanted && !found; k++)
            found = is_same(&want[k], &w.paths[i]);
        CHECK_MSG(found, "city %u: a path of %u reflections that the oracle has not", city, w.paths[i].order);
    }
    for (int k = 0; k < wanted; k++) {
        bool found = false;
        for (unsigned i = 0; i < count && !found; i++)
            found = is_same(&want[k], &w.paths[i]);
        CHECK_MSG(found || !want[k].sure, "city %u: the oracle has a path of %d reflections more", city, want[k].order);
        unsure += !want[k].sure;
    }
    total += count;
}

TEST(paths_are_those_of_the_oracle)
{
    total = unsure = 0;
    for (unsigned city = 0; city < check_count(CITIES); city++) {
        build_city(city);
        for (unsigned link = 0; link < LINKS; link++)
            compare_link(city, (city + link) % 8 == 0 ? 3 : 2);
        world_end(&w);
    }
    CHECK_MSG(total > 5 * check_count(CITIES), "%u paths are too few to compare", total);
    CHECK_MSG(unsure * 20 < total, "%u of %u paths are no test", unsure, total);
}

/* ---- rays ---- */

/* Results of rays: the sequences, and the receiver's paths found by them. */
struct finds {
    uint32_t plane[WORLD_PATHS][TIA_RADIO_ORDER_MAX], order[WORLD_PATHS], count;
};

static bool keep(void *ctx, const struct tia_radio_ray *ray)
{
    struct finds *f = ctx;

    for (uint32_t i = 0; i < f->count; i++)
        if (f->order[i] == ray->path.order &&
            memcmp(f->plane[i], ray->plane, ray->path.order * sizeof *ray->plane) == 0)
            return true;
    if (f->count < WORLD_PATHS) {
        f->order[f->count] = ray->path.order;
        memcpy(f->plane[f->count++], ray->plane, sizeof ray->plane);
    }
    return true;
}

static unsigned hybrid(struct world *world, struct tia_vec3 from, struct tia_vec3 to, unsigned order, unsigned walls,
                       unsigned density)
{
    static struct finds finds;
    struct tia_radio_link link = world_link(world, from, to, order, walls);

    finds.count = 0;
    for (uint32_t i = 0; i < tia_radio_directions(density); i++)
        CHECK_EQ(tia_radio_shoot(world->radio, world->room, &link, density, i, false, keep, &finds), TIA_OK);
    world->count = 0;
    for (uint32_t i = 0; i < finds.count; i++)
        CHECK_EQ(tia_radio_try(world->radio, world->room, &link, finds.plane[i], finds.order[i]), TIA_OK);
    qsort(world->paths, world->count, sizeof *world->paths, world_compare);
    return world->count;
}

static struct tia_radio_path images[WORLD_PATHS];

TEST(hybrid_gives_the_paths_of_images_to_the_bit)
{
    total = 0;
    for (unsigned city = 0; city < check_count(8); city++) {
        double from[3], to[3];
        unsigned walls = city % 3;
        build_city(100 + city);
        struct tia_vec3 a = place_outside(from), b = place_outside(to);
        unsigned count = world_images(&w, a, b, 2, walls);
        memcpy(images, w.paths, count * sizeof *images);
        unsigned found = hybrid(&w, a, b, 2, walls, DENSITY);
        CHECK_MSG(found == count, "city %u: %u paths by rays, %u by images", city, found, count);
        CHECK_MSG(memcmp(images, w.paths, count * sizeof *images) == 0, "city %u: another path", city);
        total += count;
        world_end(&w);
    }
    CHECK(total > 2 * check_count(8));
}

/* Rays in a room of 5 x 3.5 x 4.25, which has 38 paths up to 3 reflections: 42 rays find all of them, 12 do not. */
TEST(rays_of_a_room)
{
    struct tia_vec3 from = world_at(1.25, 1.5, 3), to = world_at(4.125, 1.0625, 0.75);

    world_begin(&w);
    world_shoebox(&w, 5, 3.5, 4.25);
    CHECK(world_build(&w));
    CHECK_EQ(hybrid(&w, from, to, 3, 0, 1), 22);
    CHECK_EQ(hybrid(&w, from, to, 3, 0, 2), 38);
    world_end(&w);
}

/* Rays miss small faces: the numbers are those of twelve cities' paths that are found, by density. */
TEST(rays_of_cities_by_density)
{
    static const unsigned densities[] = {1, 2, 4, 8, 16, 32}, counts[] = {19, 25, 28, 31, 33, 34};
    unsigned found[6] = {0}, all = 0;

    for (unsigned city = 200; city < 212; city++) {
        double from[3], to[3];
        build_city(city);
        struct tia_vec3 a = place_outside(from), b = place_outside(to);
        all += world_images(&w, a, b, 2, 0);
        for (unsigned i = 0; i < 6; i++)
            found[i] += hybrid(&w, a, b, 2, 0, densities[i]);
        world_end(&w);
    }
    for (unsigned i = 0; i < 6; i++)
        CHECK_MSG(found[i] == counts[i], "density %u: %u paths of %u, not %u", densities[i], found[i], all, counts[i]);
    CHECK_EQ(all, counts[5]);
}

/* ---- directions ---- */

static double angle(const int64_t a[3], const int64_t b[3])
{
    double c[3], d = 0, s = 0;

    for (int k = 0; k < 3; k++) {
        c[k] = (double)a[(k + 1) % 3] * (double)b[(k + 2) % 3] - (double)a[(k + 2) % 3] * (double)b[(k + 1) % 3];
        d += (double)a[k] * (double)b[k];
        s += c[k] * c[k];
    }
    return atan2(sqrt(s), d);
}

TEST(directions_are_all_around)
{
    enum { EACH = 6, COUNT = 10 * EACH * EACH + 2 };
    static int64_t all[COUNT][3];
    double farthest = 0;

    CHECK_EQ(tia_radio_directions(EACH), COUNT);
    for (uint32_t i = 0; i < COUNT; i++) {
        tia_radio_direction(EACH, i, all[i]);
        double length = 0;
        for (int k = 0; k < 3; k++)
            length += pow((double)all[i][k] / 0x1p62, 2);
        CHECK(fabs(length - 1) < 1e-15);
        for (uint32_t k = 0; k < i; k++)
            CHECK(angle(all[i], all[k]) > 1.05 / EACH * 0.79);
    }
    random_state = 5;
    for (unsigned i = 0; i < 20000; i++) {
        int64_t d[3];
        double nearest = 9;
        for (int k = 0; k < 3; k++)
            d[k] = (int64_t)((random_unit() - 0.5) * 0x1p62);
        for (uint32_t k = 0; k < COUNT; k++)
            nearest = fmin(nearest, angle(d, all[k]));
        farthest = fmax(farthest, nearest);
    }
    CHECK_MSG(farthest < 0.764 / EACH && farthest > 0.7 / EACH, "%g", farthest * EACH);
}

int main(void)
{
    RUN(paths_are_those_of_the_oracle);
    RUN(hybrid_gives_the_paths_of_images_to_the_bit);
    RUN(rays_of_a_room);
    RUN(rays_of_cities_by_density);
    RUN(directions_are_all_around);
    return check_status();
}
