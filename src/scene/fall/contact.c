#include "contact.h"

#include "math/wide.h"

int64_t tia_fall_place(const struct fall_ball *ball, int axis, uint32_t time)
{
    int64_t t = (int64_t)time - ball->at;

    return ball->place[axis] + tia_round_shift(ball->velocity[axis] * t, 12) +
           tia_round_shift(ball->pull[axis] * t * t, 25);
}

int64_t tia_fall_velocity(const struct fall_ball *ball, int axis, uint32_t time)
{
    return ball->velocity[axis] + tia_round_shift(ball->pull[axis] * ((int64_t)time - ball->at), 12);
}

struct fall_ball *tia_fall_partner(const struct falling *f, uint32_t other)
{
    return other < f->ball_count ? &f->balls[other] : NULL;
}

static int64_t larger(int64_t a, int64_t b)
{
    return a > b ? a : b;
}

static int64_t size_of(int64_t x)
{
    return x < 0 ? -x : x;
}

/* Returns a bound on the ball's movement in a tick along any axis: v 2^-8 + a 2^-17. */
static int64_t reach(const struct fall_ball *ball)
{
    int64_t most = 0;

    for (int i = 0; i < 3; i++)
        most = larger(most, size_of(ball->velocity[i]) + size_of(ball->pull[i]));
    return most;
}

/* Writes the vector, along the box's axes, from the box's closest point to a point; `offset` is the point's position
 * relative to the box's origin. */
static void from_box(const struct fall_block *block, const int64_t offset[3], int64_t out[3])
{
    for (int i = 0; i < 3; i++) {
        int64_t along = wide_round(wide_dot(offset, block->axes[i]), 62);
        out[i] = along < block->min[i] ? along - block->min[i] : along > block->max[i] ? along - block->max[i] : 0;
    }
}

/* True if v is shorter than `length`. */
static bool is_shorter(const int64_t v[3], int64_t length)
{
    return wide_is_negative(wide_difference(wide_dot(v, v), wide_product(length, length)));
}

static bool overlaps(const struct falling *f, const struct fall_ball *ball, uint32_t other, uint32_t time)
{
    const struct fall_ball *partner = tia_fall_partner(f, other);
    const struct fall_block *block = partner ? NULL : &f->blocks[other - f->ball_count];
    int64_t offset[3], rest[3];

    for (int i = 0; i < 3; i++)
        offset[i] = tia_fall_place(ball, i, time) - (partner ? tia_fall_place(partner, i, time) : block->place[i]);
    if (partner)
        return is_shorter(offset, ball->radius + partner->radius);
    if (!block->is_box)
        return size_of(wide_round(wide_dot(offset, block->axes[0]), 62)) < ball->radius;
    from_box(block, offset, rest);
    return is_shorter(rest, ball->radius);
}

/* Writes the direction, along the box's axes, from a centre inside the box to the nearest face. */
static void nearest_face(const struct fall_block *block, const int64_t offset[3], int64_t out[3])
{
    int64_t least = INT64_MAX;

    for (int i = 0; i < 3; i++) {
        int64_t along = wide_round(wide_dot(offset, block->axes[i]), 62);
        bool high = block->max[i] - along < along - block->min[i];
        int64_t depth = high ? block->max[i] - along : along - block->min[i];
        if (depth >= least)
            continue;
        least = depth;
        out[0] = out[1] = out[2] = 0;
        out[i] = high ? 1 : -1;
    }
}

/* Writes the normal of a contact with a box, in the world's axes. The sums are divided by 4, so that they fit in 64
 * bits. */
static void out_of_box(const struct fall_block *block, const int64_t offset[3], int64_t normal[3])
{
    int64_t rest[3], unit[3];

    from_box(block, offset, rest);
    if (!(rest[0] | rest[1] | rest[2]))
        nearest_face(block, offset, rest);
    (void)wide_normalise(rest, unit);
    for (int k = 0; k < 3; k++) {
        const int64_t row[3] = {block->axes[0][k], block->axes[1][k], block->axes[2][k]};
        rest[k] = wide_round(wide_dot(unit, row), 64);
    }
    (void)wide_normalise(rest, normal);
}

/* If the centres of two balls coincide, the normal is the y axis. */
void tia_fall_normal(const struct falling *f, const struct fall_ball *ball, uint32_t other, uint32_t time,
                     int64_t normal[3])
{
    const struct fall_ball *partner = tia_fall_partner(f, other);
    const struct fall_block *block = partner ? NULL : &f->blocks[other - f->ball_count];
    int64_t offset[3];

    for (int i = 0; i < 3; i++)
        offset[i] = tia_fall_place(ball, i, time) - (partner ? tia_fall_place(partner, i, time) : block->place[i]);
    if (partner) {
        if (!wide_normalise(offset, normal))
            normal[1] = FALL_ONE;
    } else if (block->is_box) {
        out_of_box(block, offset, normal);
    } else {
        bool behind = wide_is_negative(wide_dot(offset, block->axes[0]));
        for (int i = 0; i < 3; i++)
            normal[i] = behind ? -block->axes[0][i] : block->axes[0][i];
    }
}

bool tia_fall_touches(const struct falling *f, const struct fall_ball *ball, uint32_t other, uint32_t time)
{
    const struct fall_ball *partner = tia_fall_partner(f, other);
    int64_t normal[3], velocity[3];

    if (!overlaps(f, ball, other, time))
        return false;
    tia_fall_normal(f, ball, other, time, normal);
    for (int i = 0; i < 3; i++)
        velocity[i] = tia_fall_velocity(ball, i, time) - (partner ? tia_fall_velocity(partner, i, time) : 0);
    return wide_is_negative(wide_dot(normal, velocity));
}

bool tia_fall_is_near(const struct falling *f, const struct fall_ball *ball, uint32_t other)
{
    const struct fall_ball *partner = tia_fall_partner(f, other);
    const struct fall_block *block = partner ? NULL : &f->blocks[other - f->ball_count];
    int64_t far = ball->radius + reach(ball) + (partner ? partner->radius + reach(partner) : 0);

    if (block && !block->is_box)
        return true;
    for (int i = 0; i < 3; i++) {
        int64_t low = partner ? partner->place[i] : block->low[i], high = partner ? partner->place[i] : block->high[i];
        if (ball->place[i] < low - far || ball->place[i] > high + far)
            return false;
    }
    return true;
}
