/* Nets of quads around the eye: each pixel is drawn once, for any jitter, sample and corners. */
#include "raster_random.h"

#define ROWS 20
#define COLUMNS 24

/* A state that counts in the stencil buffer how often each pixel is drawn. */
static const struct tia_stencil count_all = {TIA_COMPARE_ALWAYS, 0, 255, 255, TIA_STENCIL_INCR, TIA_STENCIL_INCR,
                                             TIA_STENCIL_INCR};

struct net {
    struct tia_raster_vertex corner[ROWS + 1][COLUMNS];
};

/* Makes a box-like barrel around the eye from pole to pole, its corners moved by up to `jitter`: a closed surface. */
static void make_net(struct net *n, int64_t size, int64_t jitter, bool far)
{
    for (int i = 0; i <= ROWS; i++)
        for (int k = 0; k < COLUMNS; k++) {
            static const int8_t ring[24][2] = {{3, 0},  {3, 1},   {3, 2},   {3, 3},   {2, 3},   {1, 3},
                                               {0, 3},  {-1, 3},  {-2, 3},  {-3, 3},  {-3, 2},  {-3, 1},
                                               {-3, 0}, {-3, -1}, {-3, -2}, {-3, -3}, {-2, -3}, {-1, -3},
                                               {0, -3}, {1, -3},  {2, -3},  {3, -3},  {3, -2},  {3, -1}};
            bool pole = i == 0 || i == ROWS;
            struct tia_raster_vertex *v = &n->corner[i][k];
            v->x = pole ? 0 : ring[k][0] * size + random_size(jitter);
            v->w = pole ? 0 : ring[k][1] * size + random_size(jitter);
            v->y = (2 * i - ROWS) * size + (pole ? 0 : random_size(jitter));
            v->h = !far;
        }
}

/* Draws each quad as two triangles; quads whose corners moved are not flat. */
static void draw_net(struct tia_raster_target *t, const struct net *n)
{
    const struct tia_raster_state state = {.depth = TIA_COMPARE_ALWAYS, .front = count_all, .back = count_all};

    for (int i = 0; i < ROWS; i++)
        for (int k = 0; k < COLUMNS; k++) {
            int next = (k + 1) % COLUMNS;
            const struct tia_raster_vertex a = n->corner[i][k], b = n->corner[i][next], c = n->corner[i + 1][next];
            const struct tia_raster_vertex d = n->corner[i + 1][k], halves[2][3] = {{a, b, c}, {a, c, d}};
            CHECK_EQ(tia_raster_draw(t, &state, halves[0], 3, TIA_NO_FACE), TIA_OK);
            CHECK_EQ(tia_raster_draw(t, &state, halves[1], 3, TIA_NO_FACE), TIA_OK);
        }
}

static void try_net(unsigned range, int64_t size, int64_t jitter, bool far)
{
    static const uint16_t sizes[][2] = {{160, 120}, {97, 61}, {64, 64}, {120, 160}};
    const uint16_t *image = sizes[random_below(4)];
    struct tia_raster_grid grid;
    struct net net;
    void *memory;
    size_t holes = 0, twice = 0;

    CHECK_EQ(tia_raster_grid_init(&grid, TIA_PERSPECTIVE, image[0], image[1], 4, (uint32_t)random_below(4), range), 0);
    struct tia_tile all = {0, 0, image[0], image[1]};
    struct tia_raster_target target = target_of(&grid, all, TIA_BUFFER_STENCIL, 0, &memory);
    make_net(&net, size, jitter, far);
    draw_net(&target, &net);
    for (size_t i = 0; i < (size_t)image[0] * image[1]; i++) {
        holes += target.stencil[i] == 0;
        twice += target.stencil[i] > 1;
    }
    CHECK_MSG(holes + twice == 0, "range %u, size %jd: %zu holes, %zu twice", range, (intmax_t)size, holes, twice);
    free(memory);
}

TEST(jittered_nets_are_watertight)
{
    for (int i = 0; i < 30; i++) {
        try_net(4, 1 << 18, 1 << 16, i & 1);
        try_net(18, INT64_C(1) << 34, INT64_C(1) << 32, i & 1);
    }
}

/* Nets have corners and whole edges on pixel centres. */
TEST(nets_on_the_lattice_are_watertight)
{
    for (int i = 0; i < 30; i++) {
        try_net(4, 1 << (i % 20), 0, i & 1);
        try_net(18, INT64_C(1) << (i + 4), 0, i & 1);
        try_net(4, 120 * (1 + random_below(999)), 0, i & 1);
    }
}

int main(void)
{
    RUN(jittered_nets_are_watertight);
    RUN(nets_on_the_lattice_are_watertight);
    return check_status();
}
