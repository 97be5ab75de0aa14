/* test_gl_raster.c - the rasteriser beside Mesa's, llvmpipe and softpipe: the same triangles with the same states.
 * Their corners are multiples of 1/256 of a pixel, to which Mesa rounds: no pixel may differ. Where an edge passes
 * through a pixel's centre llvmpipe follows the same rule; softpipe does not, so pixels with ties are left out there.
 */
#include <stdlib.h>
#include <tia/raster.h>

#include "check.h"

#ifndef TIA_HAVE_LIBOSMESA
TEST(gl_raster)
{
    SKIP("built without OSMesa (install libosmesa6-dev)");
}
int main(void)
{
    RUN(gl_raster);
    return check_status();
}
#else
#include "gl/drivers.h"
#include "raster_random.h"

#define SIDE 64
#define POLYGONS 40
#define STATES 150 /* number of states, for each of which llvmpipe compiles code */
#define LEVELS 12
#define BUFFERS (TIA_BUFFER_DEPTH | TIA_BUFFER_STENCIL)

static struct tia_raster_state states[STATES];

static struct tia_raster_state any_state(void)
{
    struct tia_raster_state s = random_state_of_all();

    s.ties_by_face = false;
    s.colour_write[0] = s.depth_write; /* a colour is written only with its depth */
    return s;
}

/* A triangle of one depth; its corners are whole multiples of `step` in 1/256 pixel from the top left. */
struct triangle {
    int64_t x[3], y[3], level;
};

static void random_triangle(unsigned step, struct triangle *t)
{
    t->level = 1 + random_below(LEVELS);
    for (int i = 0; i < 3; i++) {
        t->x[i] = random_below(SIDE * 256 / step + 1) * step;
        t->y[i] = random_below(SIDE * 256 / step + 1) * step;
    }
}

static void place(const struct triangle *t, const struct tia_raster_grid *l, struct tia_raster_vertex v[3],
                  double clip[3][4])
{
    int64_t level = t->level, one = INT64_C(1) << l->fraction;

    for (int i = 0; i < 3; i++) {
        v[i] = (struct tia_raster_vertex){(t->x[i] - SIDE * 128) * (one / (SIDE * 128)) * level,
                                          (SIDE * 128 - t->y[i]) * (one / (SIDE * 128)) * level, one * level, 1};
        clip[i][0] = (double)v[i].x / (double)one;
        clip[i][1] = (double)v[i].y / (double)one;
        clip[i][3] = (double)level;
        clip[i][2] = (double)(level * (level - 8)) / 8; /* z/w is the same distance apart for all levels */
    }
}

/* Marks pixels whose centre is on the line of an edge. */
static void mark_ties(const struct triangle *t, bool *tied)
{
    for (int k = 0; k < 3; k++) {
        int64_t dx = t->x[(k + 1) % 3] - t->x[k], dy = t->y[(k + 1) % 3] - t->y[k];
        for (int i = 0; i < SIDE * SIDE; i++)
            tied[i] = tied[i] || dx * (256 * (i / SIDE) + 128 - t->y[k]) == dy * (256 * (i % SIDE) + 128 - t->x[k]);
    }
}

/* Returns the number of pixels that differ from Mesa's; those with ties only if `ties_count`. */
static size_t trial(struct gl_raster *gl, unsigned step, bool all_new, bool ties_count)
{
    static bool tied[SIDE * SIDE];
    static uint32_t face[SIDE * SIDE];
    static uint8_t stencil[SIDE * SIDE];
    struct tia_raster_grid grid;
    uint8_t clear = (uint8_t)random_below(4);
    size_t wrong = 0;
    void *memory;

    memset(tied, 0, sizeof tied);
    CHECK_EQ(tia_raster_grid_init(&grid, TIA_PERSPECTIVE, SIDE, SIDE, 1, 0, 5), TIA_OK);
    struct tia_raster_target t = target_of(&grid, (struct tia_tile){0, 0, SIDE, SIDE}, BUFFERS, POLYGONS, &memory);
    tia_raster_clear_stencil(&t, clear, 255);
    gl_raster_clear(gl, clear);
    for (uint32_t id = 0; id < POLYGONS; id++) {
        struct tia_raster_state s = all_new ? any_state() : states[random_below(check_count(STATES))];
        struct triangle triangle;
        struct tia_raster_vertex v[3];
        double clip[3][4];
        random_triangle(step, &triangle);
        place(&triangle, &grid, v, clip);
        if (!ties_count)
            mark_ties(&triangle, tied);
        CHECK_EQ(tia_raster_draw(&t, &s, v, 3, id), TIA_OK);
        gl_raster_draw(gl, &s, (const double(*)[4])clip, 3, id);
    }
    CHECK(gl_raster_read(gl, face, stencil));
    for (size_t i = 0; i < SIDE * SIDE; i++)
        wrong += !tied[i] && (t.stencil[i] != stencil[i] || t.face[i] != face[i]);
    free(memory);
    return wrong;
}

static void compare_states(const char *driver, unsigned step, int trials, bool softly)
{
    struct gl_raster *gl = gl_opened(driver, SIDE, SIDE);
    size_t wrong = 0;

    if (!gl)
        return;
    for (int i = 0; i < trials; i++)
        wrong += trial(gl, step, softly, !softly);
    CHECK_MSG(wrong == 0, "%zu of %d pixels differ", wrong, trials * SIDE * SIDE);
    gl_raster_close(gl);
}

TEST(llvmpipe_has_the_same_states)
{
    compare_states("llvmpipe", 1, 200, false);
}

TEST(llvmpipe_breaks_ties_the_same_way)
{
    compare_states("llvmpipe", 128, 200, false);
}

TEST(softpipe_has_the_same_states)
{
    compare_states("softpipe", 1, (int)check_count(200), true);
}

static void by_llvmpipe(void)
{
    RUN(llvmpipe_has_the_same_states);
    RUN(llvmpipe_breaks_ties_the_same_way);
}

static void by_softpipe(void)
{
    RUN(softpipe_has_the_same_states);
}

int main(void)
{
    for (int i = 0; i < STATES; i++)
        states[i] = any_state();
    return gl_in_both(by_llvmpipe, by_softpipe);
}
#endif
