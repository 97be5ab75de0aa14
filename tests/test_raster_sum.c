/* An area light by the accumulation buffer, as in a program that draws with tia/raster.h: for each point of the light,
 * shadow volumes into the stencil buffer, then the lit pixels in a colour, then a share of that into the sum. The mean
 * must be that of exact rays to the points, tested with every face in integers of 128 bits. */
#include "shadow_worlds.h"

enum { LIGHTS = 7, FULL = 50000, PIXELS = SIZE * SIZE };

static const struct tia_tile all = {0, 0, SIZE, SIZE};

static void draw_lit_faces(struct tia_raster_target *target, const struct world *w)
{
    static const struct tia_stencil where_no_volume_is = {.test = TIA_COMPARE_EQUAL, .reference = 0, .mask = 255};
    const struct tia_raster_state state = {.depth = TIA_COMPARE_EQUAL,
                                           .front = where_no_volume_is,
                                           .back = where_no_volume_is,
                                           .colour_write = {true, true, true},
                                           .colour = {FULL, FULL / 2, 1}};

    for (uint32_t f = 0; f < w->flat.face_count; f++) {
        struct tia_raster_vertex corners[TIA_SIDES];
        unsigned sides = tia_flat_corners(&w->flat, f, corners);
        const struct tia_flat_face *face = &w->flat.faces[f];
        if (tia_flat_side(&w->flat, face, &w->light) == tia_flat_side_of_eye(&w->flat, face))
            CHECK_EQ(tia_raster_draw(target, &state, corners, sides, f), TIA_OK);
    }
}

static void add_light(struct tia_raster_target *target, const struct world *w)
{
    static const uint16_t black[3] = {0, 0, 0};

    tia_raster_clear_stencil(target, 0, 255);
    CHECK_EQ(tia_shadow_zfail(target, &w->flat, (struct tia_shadow_light){&w->light, NULL}, &never), TIA_OK);
    tia_raster_clear_colour(target, black);
    draw_lit_faces(target, w);
    tia_raster_sum_add(target, 1);
}

static void count_lit(const struct world *w, unsigned lit[PIXELS])
{
    for (int at = 0; at < PIXELS; at++) {
        uint32_t face = find_seen(w, at % SIZE, at / SIZE);
        lit[at] += face != TIA_NO_FACE && is_lit(w, face, at % SIZE, at / SIZE);
    }
}

static uint32_t rounded(uint32_t full, unsigned lit)
{
    return (2 * full * lit + LIGHTS) / (2 * LIGHTS);
}

/* Compares the target with the lit pixels; returns the number of pixels in the penumbra, which only some of the points
 * reach. */
static unsigned compare(const struct tia_raster_target *target, const unsigned lit[PIXELS])
{
    unsigned between = 0;

    for (size_t at = 0; at < PIXELS; at++) {
        CHECK_EQ(target->colour[3 * at], rounded(FULL, lit[at]));
        CHECK_EQ(target->colour[3 * at + 1], rounded(FULL / 2, lit[at]));
        CHECK_EQ(target->colour[3 * at + 2], rounded(1, lit[at]));
        between += lit[at] > 0 && lit[at] < LIGHTS;
    }
    return between;
}

static unsigned draw_world(struct world *w)
{
    const unsigned buffers = TIA_BUFFER_DEPTH | TIA_BUFFER_STENCIL | TIA_BUFFER_COLOUR | TIA_BUFFER_SUM;
    size_t size = tia_raster_size(all, buffers, w->flat.face_count);
    void *memory = malloc(size);
    struct tia_raster_target target;
    unsigned lit[PIXELS] = {0};
    struct tia_raster_vertex at = w->light;

    CHECK(!tia_raster_init(&target, memory, size, &w->flat.grid, all, buffers, w->flat.face_count));
    CHECK(!tia_shadow_faces(&target, &w->flat, &never));
    for (int i = 0; i < LIGHTS; i++) {
        w->light = (struct tia_raster_vertex){at.x + 60 * i, at.y + 45 * (i % 3), at.w, at.h};
        add_light(&target, w);
        count_lit(w, lit);
    }
    tia_raster_sum_return(&target, LIGHTS);
    unsigned between = compare(&target, lit);
    free(memory);
    return between;
}

TEST(an_area_light_is_the_mean_over_its_points)
{
    static const enum contents kinds[] = {SOUP, SOLIDS, CROOKED, MIXED};
    unsigned between = 0;
    struct world w;

    for (int round = 0; round < 40; round++) {
        begin(&w, TIA_PERSPECTIVE);
        make(&w, kinds[round % 4], 500, 1);
        end(&w, 500, 1);
        between += draw_world(&w);
    }
    CHECK_MSG(between > 1000, "%u pixels in penumbrae", between);
}

int main(void)
{
    RUN(an_area_light_is_the_mean_over_its_points);
    return check_status();
}
