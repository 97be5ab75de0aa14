/* The alias-free map against exact rays, tested with every face in integers of 128 bits, in whole images and in tiles
 * of any size, which sort their points into different cells. Many corners lie on pixel centres, in one plane, or in the
 * plane of the light or the eye. */
#include <string.h>

#include "raster/target.h"
#include "shadow/technique.h"
#include "shadow_worlds.h"

static struct cancel never;

struct tally {
    uint32_t seen, dark, wrong, tiles;
};

/* Distance between rows in pixels: two more than the image has. */
#define PITCH (SIZE + 2)

static struct drawn {
    uint64_t lit[SIZE * PITCH], more[SIZE * PITCH], nearness[SIZE * PITCH];
    uint32_t face[SIZE * PITCH];
    struct tia_raster_plane planes[FACES];
    struct tia_raster_target target;
} drawn;

static void draw(struct world *w)
{
    memset(&drawn, 0, sizeof drawn);
    drawn.target = (struct tia_raster_target){.grid = &w->flat.grid,
                                              .area = {0, 0, SIZE, SIZE},
                                              .face = drawn.face,
                                              .nearness = drawn.nearness,
                                              .planes = drawn.planes,
                                              .face_count = w->flat.face_count,
                                              .pitch = PITCH};
    tia_raster_clear_depth(&drawn.target);
    for (uint32_t f = 0; f < w->flat.face_count; f++) {
        struct tia_raster_vertex corners[TIA_SIDES];
        unsigned sides = tia_flat_corners(&w->flat, f, corners);
        CHECK(!tia_raster_plane_init(&drawn.planes[f], &w->flat.grid, corners, sides));
    }
    w->flat.planes = drawn.planes;
    drawn.target.planes_known = true;
    CHECK(!tia_shadow_faces(&drawn.target, &w->flat, &never));
}

static void light_tile(const struct tia_shadow_view *view, struct tia_tile area, unsigned sample)
{
    size_t first = (size_t)area.y * PITCH + area.x;
    struct tia_shadow_tile tile = {.lit = drawn.lit + first, .more = drawn.more + first};

    CHECK(!tia_raster_part(&tile.target, &drawn.target, area));
    tia_shadow_exact_maps.light(view, &tile, sample, &never);
}

/* Computes the light of all pixels, in half of the worlds in a single tile, in the others in tiles of random sizes.
 * Returns the number of tiles. */
static uint32_t light_all(const struct world *w)
{
    static struct tia_shadow_view view;
    unsigned sample = (unsigned)below(TIA_SHADOW_SAMPLES_MAX);
    bool whole = below(2) == 0;
    uint32_t tiles = 0;

    view.flat = w->flat;
    view.samples[sample] = w->light;
    for (unsigned y = 0, height; y < SIZE; y += height) {
        height = whole ? SIZE : 1 + (unsigned)below((int32_t)(SIZE - y));
        for (unsigned x = 0, width; x < SIZE; x += width, tiles++) {
            width = whole ? SIZE : 1 + (unsigned)below((int32_t)(SIZE - x));
            light_tile(&view, (struct tia_tile){(uint16_t)x, (uint16_t)y, (uint16_t)width, (uint16_t)height}, sample);
        }
    }
    for (int i = 0; i < SIZE * PITCH; i++) {
        CHECK(drawn.lit[i] == 0 || drawn.lit[i] == UINT64_C(1) << sample);
        drawn.lit[i] = drawn.lit[i] != 0;
    }
    return tiles;
}

static void compare(struct world *w, struct tally *t)
{
    draw(w);
    t->tiles += light_all(w);
    for (int j = 0; j < SIZE; j++)
        for (int i = 0; i < SIZE; i++) {
            size_t at = (size_t)j * PITCH + (size_t)i;
            uint32_t face = drawn.face[at];
            bool lit = face != TIA_NO_FACE && is_lit(w, face, i, j);
            CHECK_EQ(face, find_seen(w, i, j));
            t->seen += face != TIA_NO_FACE;
            t->dark += face != TIA_NO_FACE && !lit;
            t->wrong += drawn.lit[at] != lit;
        }
    for (int j = 0; j < SIZE; j++)
        CHECK(!drawn.lit[j * PITCH + SIZE] && !drawn.more[j * PITCH + SIZE + 1]);
}

static void check_worlds(enum tia_projection projection, enum contents contents, bool grid)
{
    int32_t step = grid ? projection == TIA_ORTHOGRAPHIC ? 128 : 96 : 1, range = grid ? 4 : 500;
    const unsigned rounds = check_count(150);
    struct tally t = {0};
    struct world w;

    for (unsigned round = 0; round < rounds; round++) {
        begin(&w, projection);
        make(&w, contents, range, step);
        end(&w, range, step);
        compare(&w, &t);
    }
    CHECK_EQ(t.wrong, 0);
    CHECK_MSG(t.seen > rounds * SIZE * SIZE / 20 && t.dark > t.seen / 8 && t.dark < t.seen - t.seen / 20,
              "%u see a face, %u are dark", t.seen, t.dark);
    CHECK(t.tiles > 2 * rounds);
}

static void check_all(enum contents contents)
{
    for (int grid = 0; grid < 2; grid++) {
        check_worlds(TIA_PERSPECTIVE, contents, grid);
        check_worlds(TIA_ORTHOGRAPHIC, contents, grid);
    }
}

TEST(soups)
{
    check_all(SOUP);
}

TEST(solids)
{
    check_all(SOLIDS);
    check_worlds(TIA_PERSPECTIVE, CROOKED, false);
    check_worlds(TIA_ORTHOGRAPHIC, CROOKED, false);
}

TEST(planes_and_all)
{
    check_all(MIXED);
}

int main(void)
{
    RUN(soups);
    RUN(solids);
    RUN(planes_and_all);
    return check_status();
}
