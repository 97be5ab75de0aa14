/* steps_row.c - the pixels of a row by the steps of their colour.
 *
 * The points of a row lie on less than half of a circle, which the ball turns to the eye. There u = G.P has at most one
 * extremum, and elsewhere it is enough to look for the next step in the direction in which u changes. It grows where
 *
 *     (b + S)^2 S (g/(b + S))' = omega S + l > 0,   omega = g' b - g b',   l = g' D - g D'/2,
 *
 * as the derivative of S is D'/(2 S). Omega is the same for all pixels of a row, as g and b are linear. So this is
 * decided as a step is, with W = -omega and A = l. */
#include "steps_row.h"

#include "math/noinline.h"

/* Returns c x/2^32, too small by less than 2. */
static NOINLINE int64_t scaled(uint32_t c, int64_t x)
{
    int64_t low = (int64_t)(tia_mul_u32(c, (uint32_t)x) >> 32);
    uint64_t size = tia_mul_u32(c, (uint32_t)(steps_top(x) < 0 ? 0 - (uint32_t)steps_top(x) : (uint32_t)steps_top(x)));

    return low + (steps_top(x) < 0 ? -(int64_t)size : (int64_t)size);
}

/* ---- the direction of u ---- */

/* Returns an accumulator's step for 2^turn_shift pixels, as a word. */
static int32_t long_step(const struct step_row *row, uint64_t step)
{
    return steps_top((int64_t)(step << row->steps->turn_shift));
}

/* Gives A = l and W = -omega at a pixel, both for 2^turn_shift pixels and divided by 2^32. */
static void turn_at(const struct step_row *row, const struct step_point *point, int32_t *a, int32_t *w)
{
    uint64_t slope = row->d_step + steps_times(row->d_twice, row->at) - (uint64_t)((int64_t)row->d_twice / 2);
    int32_t half = steps_top((int64_t)(slope << (row->steps->turn_shift - 1))), g = steps_top(point->g);
    int32_t g_step = long_step(row, (uint64_t)row->g_step), b_step = long_step(row, (uint64_t)row->b_step);

    *a = steps_top(tia_mul_s32(g_step, steps_top((int64_t)point->d)) - tia_mul_s32(g, half));
    *w = steps_top(tia_mul_s32(g, b_step) - tia_mul_s32(g_step, point->b));
}

/* Returns 1 if u grows at the row's pixel, -1 if it falls, 0 in doubt. */
static int way_at(const struct step_row *row)
{
    const struct colour_steps *steps = row->steps;
    struct step_point point;
    int32_t a, w;

    steps_point(row, &point);
    turn_at(row, &point, &a, &w);
    return steps_decide(steps, point.d, a, w, steps->turn_doubt, 2 * steps->depth_doubt);
}

/* Returns the first pixel from `first` on, below `end`, where u does not certainly change in the direction `way`, as it
 * does before; `end` if it does in all of them. */
static int way_end(struct step_row *row, int way, int first, int end)
{
    while (first < end) {
        row->at = first + (end - first) / 2;
        if (way_at(row) == way)
            first = row->at + 1;
        else
            end = row->at;
    }
    return first;
}

/* Finds where u changes in one direction. */
static void find_turn(struct step_row *row)
{
    const bool wide = row->steps->turn_shift > 0;
    const int last = row->count - 1;

    row->way[0] = wide ? way_at(row) : 0;
    row->at = last;
    row->way[1] = wide ? way_at(row) : 0;
    row->turn_first = 0;
    if (row->way[0])
        row->turn_first = row->way[0] == row->way[1] ? row->count : way_end(row, row->way[0], 1, last);
    row->turn_end = row->way[1] ? row->turn_first : row->count;
    for (int next = 1; row->turn_end < last; next *= 2) {
        row->at = row->turn_end;
        if (way_at(row) == row->way[1])
            break;
        row->turn_end = row->turn_end + next < last ? row->turn_end + next : last;
    }
    row->at = 0;
}

/* ---- a row ---- */

static uint64_t depth_at(const struct span_sphere *sphere, const struct row_square *square, int64_t b, int64_t b_step,
                         struct step_row *row)
{
    int64_t once = steps_upper(b_step, b_step);
    uint64_t d = (uint64_t)(steps_upper(b, b) - scaled((uint32_t)sphere->c_disc, (int64_t)square->start - STEPS_HALF));

    row->d_step =
        (uint64_t)(2 * steps_upper(b, b_step) + once - scaled((uint32_t)sphere->c_disc, (int64_t)square->step));
    row->d_twice = (uint64_t)(2 * once - scaled((uint32_t)sphere->c_disc, (int64_t)square->twice));
    return d;
}

/* Sets the index to about that of the first pixel. */
static void find_index(struct step_row *row)
{
    const struct colour_steps *steps = row->steps;
    int low = 0, end = steps->count;
    struct step_point point;

    steps_point(row, &point);
    while (low < end) {
        int middle = (low + end) / 2;
        int32_t w = steps->at[middle], a = steps_top(point.g) - steps_high(w, point.b);
        if (steps_square(a) >= steps_high(steps_square(w), steps_top((int64_t)point.d)))
            low = middle + 1;
        else
            end = middle;
    }
    row->index = low;
}

void steps_begin(const struct primary_rays *primary, const struct span_sphere *sphere, const struct colour_steps *steps,
                 int x, int y, int count, struct step_row *row)
{
    struct row_form b = primary_form(primary, &sphere->centre, x, y, sphere->b_shift);
    struct row_form g = primary_form(primary, &steps->to_light, x, y, steps->form_shift);
    struct row_square square = primary_square(primary, x, y);

    row->steps = steps;
    row->b = (int64_t)b.start;
    row->b_step = (int64_t)b.step;
    row->g = (int64_t)g.start;
    row->g_step = (int64_t)g.step;
    row->d = depth_at(sphere, &square, row->b - STEPS_HALF, row->b_step, row) +
             ((uint64_t)(uint32_t)steps->depth_doubt << 32);
    row->at = 0;
    row->count = count;
    row->sure = false;
    find_turn(row);
    find_index(row);
}

/* Returns the direction of u at the row's pixel, 0 if it is in doubt. */
static int way_of(const struct step_row *row)
{
    return row->at < row->turn_first ? row->way[0] : row->at >= row->turn_end ? row->way[1] : 0;
}

/* Decides a pixel by the steps on both sides; false if it is in doubt. */
static bool draw_pixel(struct step_row *row, tia_rgb565 *pixel)
{
    int above, below = 1, before = row->index;
    struct step_point point;

    steps_point(row, &point);
    while ((above = steps_side(row->steps, &point, row->index)) > 0)
        row->index++;
    if (row->index == before)
        while ((below = steps_side(row->steps, &point, row->index - 1)) < 0)
            row->index--;
    if (row->index < before)
        above = -1;
    row->sure = way_of(row) > 0 ? below > 0 : above < 0;
    *pixel = steps_shown(row);
    row->at++;
    return above && below;
}

/* Draws up to `count` pixels where u changes in one direction, until one must be decided by the steps on both sides. */
static int draw_run(struct step_row *row, int count, tia_rgb565 *pixels)
{
    int way = way_of(row), left = (row->at < row->turn_first ? row->turn_first : row->count) - row->at;

    if (!way || !row->sure || row->at == row->turn_end)
        return 0;
    return steps_walk(row, way, count < left ? count : left, pixels);
}

uint64_t steps_draw(struct step_row *row, tia_rgb565 *pixels)
{
    int count = row->count - row->at < STEPS_BLOCK ? row->count - row->at : STEPS_BLOCK;
    uint64_t open = 0;

    for (int i = 0; i < count; i++) {
        i += draw_run(row, count - i, pixels + i);
        if (i < count && !draw_pixel(row, pixels + i))
            open |= UINT64_C(1) << i;
    }
    return open;
}
