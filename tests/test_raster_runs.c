/* The rasteriser's runs by each instruction set against plain C: every nearness, face and count. */
#include <stdlib.h>
#include <tia/debug.h>
#include <tia/simd.h>

#include "raster/target.h"
#include "raster_random.h"

#define BUFFERS (TIA_BUFFER_DEPTH | TIA_BUFFER_COUNT)
#define POLYGONS 40
#define KEEPS                                                                                                          \
    {                                                                                                                  \
        .test = TIA_COMPARE_ALWAYS, .mask = 255, .write = 255                                                          \
    }

static const struct tia_raster_state seen = {
    .depth = TIA_COMPARE_LESS, .depth_write = true, .ties_by_face = true, .front = KEEPS, .back = KEEPS};

static struct tia_raster_state counting(void)
{
    struct tia_raster_state s = {.depth = TIA_COMPARE_LESS, .front = KEEPS, .back = KEEPS};
    bool behind = random_below(2);

    *(behind ? &s.front.zfail : &s.front.zpass) = TIA_STENCIL_INCR_WRAP;
    *(behind ? &s.back.zfail : &s.back.zpass) = TIA_STENCIL_DECR_WRAP;
    return s;
}

/* Draws a polygon in both targets. The first POLYGONS have new faces; of the others, which count, half have one of
 * these faces again, and half have no face. */
static void draw(struct tia_raster_target *a, struct tia_raster_target *b, const struct random_polygon *p, uint32_t i)
{
    struct tia_raster_state state = i < POLYGONS ? seen : counting();
    uint32_t face = i < POLYGONS ? i : random_below(2) ? i - POLYGONS : TIA_NO_FACE;

    CHECK_EQ(tia_raster_draw(a, &state, p->v, p->count, face), TIA_OK);
    CHECK_EQ(tia_raster_draw(b, &state, p->v, p->count, face), TIA_OK);
}

/* Compares a part of a target, around which no byte may change. */
static void compare(const struct tia_simd *simd, enum tia_projection projection, uint64_t *drawn)
{
    struct tia_tile all = {0, 0, 90, 40}, area = {(uint16_t)random_below(20), (uint16_t)random_below(9), 70, 31};
    static struct random_polygon polygons[POLYGONS];
    struct tia_raster_target whole[2], part[2];
    struct tia_raster_grid grid;
    unsigned range = (unsigned)random_below(projection == TIA_ORTHOGRAPHIC ? TIA_RANGE_FLAT + 1 : TIA_RANGE_MAX + 1);
    void *memory[2];

    CHECK_EQ(tia_raster_grid_init(&grid, projection, 90, 40, 1, 0, range), TIA_OK);
    int64_t most = ((INT64_C(1) << (grid.fraction + (int)range)) - 1) / 40 * 40;
    for (int i = 0; i < 2; i++) {
        whole[i] = target_of(&grid, all, BUFFERS, POLYGONS, &memory[i]);
        CHECK_EQ(tia_raster_part(&part[i], &whole[i], area), TIA_OK);
    }
    part[1].runs = tia_simd_raster(simd);
    CHECK(part[1].runs != NULL);
    for (uint32_t i = 0; i < 2 * POLYGONS; i++) {
        if (i < POLYGONS) {
            polygons[i] = i ? polygons[i - 1] : (struct random_polygon){.count = 0};
            random_polygon(&polygons[i], &grid, area, most);
        }
        draw(&part[0], &part[1], &polygons[i % POLYGONS], i);
    }
    for (size_t i = 0; i < 90 * 40; i++)
        *drawn += whole[0].face[i] != TIA_NO_FACE && whole[0].count[i] != 0;
    CHECK(memcmp(whole[0].nearness, whole[1].nearness, sizeof(uint64_t) * 90 * 40) == 0);
    CHECK(memcmp(whole[0].face, whole[1].face, sizeof(uint32_t) * 90 * 40) == 0);
    CHECK(memcmp(whole[0].count, whole[1].count, sizeof(uint32_t) * 90 * 40) == 0);
    free(memory[0]);
    free(memory[1]);
}

TEST(every_level_draws_what_plain_c_draws)
{
    const struct tia_simd *simd;

    for (unsigned i = 0; (simd = tia_simd_at(i)); i++) {
        uint64_t drawn = 0;
        for (int round = 0; round < 600 && tia_simd_raster(simd); round++)
            compare(simd, round % 3 ? TIA_PERSPECTIVE : TIA_ORTHOGRAPHIC, &drawn);
        CHECK(!tia_simd_raster(simd) || drawn > 100000);
    }
    CHECK(tia_simd_raster(NULL) == NULL);
}

int main(void)
{
    RUN(every_level_draws_what_plain_c_draws);
    return check_status();
}
