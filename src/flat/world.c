/* world.c - the inverse of the camera's matrix. With its rows r0, r1, r2, the inverse has the columns c0 = r1 x r2, c1
 * = r2 x r0, c2 = r0 x r1, each divided by r0.c0.
 */
#include "world.h"

#include "math/wide.h"
#include "raster/distance.h"
#include "scene/axes.h"

#define COLUMN_BITS 60 /* number of bits of the largest column */

static int bits_of(int64_t a)
{
    return 64 - (int)tia_clz64((uint64_t)(a < 0 ? -a : a) | 1);
}

/* Returns a/b 2^e, rounded; e in -64..126. */
static int64_t quotient(int64_t a, int64_t b, int e)
{
    return wide_quotient(e < 0 ? a >> (e < -62 ? 62 : -e) : a, b, e < 0 ? 0 : e);
}

/* Gives half of each row, so that products of rows fit. */
static void rows_of(const struct tia_eye *eye, int64_t rows[3][3])
{
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 3; i++)
            rows[k][i] = eye->row[k].m[i] / 2;
}

static void invert(struct tia_world *world, const struct tia_eye *eye)
{
    int64_t rows[3][3], columns[3][3];
    int most = INT16_MIN, exponents[3];

    rows_of(eye, rows);
    for (int k = 0; k < 3; k++)
        tia_axes_cross(rows[(k + 1) % 3], rows[(k + 2) % 3], columns[k]);
    int64_t det = wide_round(wide_dot(rows[0], columns[0]), 62);
    for (int k = 0; k < 3; k++) {
        exponents[k] = eye->row[k].places - 1 - 62;
        for (int i = 0; i < 3; i++) {
            int bits = bits_of(columns[k][i]) - bits_of(det) + exponents[k] + 1;
            most = bits > most ? bits : most;
        }
    }
    world->places = COLUMN_BITS - most;
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 3; i++)
            world->m[i][k] = quotient(columns[k][i], det, exponents[k] + world->places);
}

/* Limit of each of three numbers that are added: the first pixel's, and the steps from there to the last column and
 * row. Only views of 2^16 units and more reach it. */
#define VIEW_MOST (INT64_C(1) << 61)

/* Returns row i of m d/w in Q.45; components of d are integers below 2^31. */
static int64_t over(const struct tia_world *world, int i, const int64_t d[3], int32_t w)
{
    wide sum = wide_dot(world->m[i], d);
    int spare = wide_bits(wide_size(sum)) - 61, cut = spare > 0 ? spare : 0;
    int64_t above = cut ? wide_round(sum, (unsigned)cut) : (int64_t)wide_low(sum);

    return quotient(above, w, TIA_DISTANCE_BITS + cut - world->places);
}

static int64_t limited(int64_t a, int64_t most)
{
    return a > most ? most : a < -most ? -most : a;
}

void tia_world_init(struct tia_world *world, const struct tia_flat_scene *flat)
{
    static const int64_t ahead[3] = {0, 0, -1};
    const struct tia_raster_grid *l = &flat->grid;
    bool flat_view = flat->eye.projection == TIA_ORTHOGRAPHIC;
    const int64_t first[3] = {l->x, l->y, flat_view ? 0 : l->w}, right[3] = {l->right}, down[3] = {0, -l->down};

    world->flat = flat;
    invert(world, &flat->eye);
    for (int i = 0; i < 3; i++) {
        world->first[i] = limited(over(world, i, first, l->w), VIEW_MOST);
        world->right[i] = limited(over(world, i, right, l->w), VIEW_MOST / l->width);
        world->down[i] = limited(over(world, i, down, l->w), VIEW_MOST / l->height);
        world->along[i] = over(world, i, ahead, 1);
    }
}

void tia_world_place(const struct tia_world *world, const struct tia_raster_vertex *v, int64_t place[3])
{
    int64_t q[3];

    tia_flat_affine(world->flat, v, q);
    for (int i = 0; i < 3; i++)
        place[i] = wide_round(wide_dot(world->m[i], q),
                              (unsigned)(world->places + world->flat->grid.fraction - TIA_WORLD_BITS));
}

/* Gives the direction of q in the world, Q1.62. It is normalised from components of at most 60 bits. */
static void turn(const struct tia_world *world, const int64_t q[3], int64_t direction[3])
{
    int64_t long_one[3];
    wide sum[3];
    int most = 0;

    for (int i = 0; i < 3; i++) {
        sum[i] = wide_dot(world->m[i], q);
        int bits = wide_bits(wide_size(sum[i]));
        most = bits > most ? bits : most;
    }
    for (int i = 0; i < 3; i++)
        long_one[i] = most > 60 ? wide_down(sum[i], (unsigned)(most - 60)) : (int64_t)wide_low(sum[i]);
    (void)wide_normalise(long_one, direction);
}

void tia_world_direction(const struct tia_world *world, const struct tia_raster_vertex *v, int64_t direction[3])
{
    int64_t q[3];

    tia_flat_affine(world->flat, v, q);
    turn(world, q, direction);
}

void tia_world_from_to(const struct tia_world *world, const struct tia_raster_vertex *from,
                       const struct tia_raster_vertex *to, int64_t direction[3])
{
    int64_t a[3], b[3];

    tia_flat_affine(world->flat, from, a);
    tia_flat_affine(world->flat, to, b);
    for (int k = 0; k < 3; k++)
        b[k] -= a[k];
    turn(world, b, direction);
}

void tia_world_seen(const struct tia_world *world, int x, int y, int64_t distance, int64_t place[3])
{
    bool flat_view = world->flat->eye.projection == TIA_ORTHOGRAPHIC;

    for (int i = 0; i < 3; i++) {
        int64_t at = world->first[i] + x * world->right[i] + y * world->down[i];
        int64_t far = wide_round(wide_product(flat_view ? world->along[i] : at, distance),
                                 2 * TIA_DISTANCE_BITS - TIA_WORLD_BITS);
        place[i] = flat_view ? far + tia_round_shift(at, TIA_DISTANCE_BITS - TIA_WORLD_BITS) : far;
    }
}
