/* steps_row.c - the pixels of a row by the steps of their colour.
 *
 * The points of a row lie on less than half of a circle, which the ball turns to the eye. There u = G.P has at most one
 * extremum: a maximum if G points to the eye's side of the circle's centre, else a minimum. So it is enough to look for
 * the next step in the direction in which u changes, and, before the extremum, once a run in the other one. */
#include "steps_row.h"

#include "math/noinline.h"

/* Returns a b/2^64, too small by less than 3. */
static NOINLINE int64_t upper(int64_t a, int64_t b)
{
    uint32_t a_low = (uint32_t)a, b_low = (uint32_t)b;
    int64_t left = tia_mul_s32(steps_top(a), (int32_t)(b_low >> 1)) >> 31;
    int64_t right = tia_mul_s32(steps_top(b), (int32_t)(a_low >> 1)) >> 31;

    return tia_mul_s32(steps_top(a), steps_top(b)) + left + right;
}

/* Returns c x/2^32, too small by less than 2. */
static NOINLINE int64_t scaled(uint32_t c, int64_t x)
{
    int64_t low = (int64_t)(tia_mul_u32(c, (uint32_t)x) >> 32);
    uint64_t size = tia_mul_u32(c, (uint32_t)(steps_top(x) < 0 ? 0 - (uint32_t)steps_top(x) : (uint32_t)steps_top(x)));

    return low + (steps_top(x) < 0 ? -(int64_t)size : (int64_t)size);
}

/* ---- one step ---- */

/* Returns A at this pixel, with a lower word. */
static int64_t form_at(const struct step_row *row, int32_t w)
{
    return steps_g(row) - tia_mul_s32(w, steps_top(steps_b(row)));
}

/* Decides by 64 bits whether u is at or above step k at pixel `at`: 1, or -1, or 0 in doubt. */
static NOINLINE int decide(const struct step_row *row, int k)
{
    const struct colour_steps *steps = row->steps;
    int32_t w = steps->at[k], a = steps_top(form_at(row, w)), size = w < 0 ? -w : w;
    int64_t square = tia_mul_s32(w, w), root = (tia_mul_s32(size, steps->root_most) >> 32) + 1;
    int64_t left = tia_mul_s32(a, a < 0 ? -a : a), right = upper(square, (int64_t)row->d);
    int64_t margin = (2 * root + steps->fine_doubt) * steps->fine_doubt +
                     ((square >> 32) + 1) * (2 * (int64_t)steps->depth_doubt) + 4;
    int64_t more = left - (w < 0 ? -right : right);

    return more > margin ? 1 : more < -margin ? -1 : 0;
}

/* Returns 1 if u is at or above step k at this pixel, -1 if it is below, 0 in doubt. */
static int side_of(const struct step_row *row, int k)
{
    if (k < 0 || k >= row->steps->count)
        return k < 0 ? 1 : -1;
    int32_t w = row->steps->at[k], margin = row->steps->margin;
    int32_t more = steps_square(steps_top(form_at(row, w))) - steps_high(steps_square(w), (int32_t)(row->d >> 32));
    return more > margin ? 1 : more < -margin ? -1 : decide(row, k);
}

/* ---- a row ---- */

static uint64_t depth_at(const struct span_sphere *sphere, const struct row_square *square, int64_t b, int64_t b_step,
                         struct step_row *row)
{
    int64_t once = upper(b_step, b_step);
    uint64_t d = (uint64_t)(upper(b, b) - scaled((uint32_t)sphere->c_disc, (int64_t)square->start - STEPS_HALF));

    row->d_step = (uint64_t)(2 * upper(b, b_step) + once - scaled((uint32_t)sphere->c_disc, (int64_t)square->step));
    row->d_twice = (uint64_t)(2 * once - scaled((uint32_t)sphere->c_disc, (int64_t)square->twice));
    return d;
}

/* Returns 1 if u has no minimum in the row, -1 if it has no maximum: by the sign of G.L in the row's plane. Where that
 * is in doubt, u has neither. */
static int turn_of(const struct primary_rays *primary, const struct span_sphere *sphere,
                   const struct colour_steps *steps, int y)
{
    num_wide row = primary_y(primary, y), square = num_square(row) + num_square(primary->depth);
    const struct num_vec *l = &sphere->centre, *g = &steps->to_light;
    num_wide l_base = l->y * row - l->z * primary->depth, g_base = g->y * row - g->z * primary->depth;
    bool sides_differ = (l->x < 0) != (g->x < 0), bases_differ = (l_base < 0) != (g_base < 0);

    if (sides_differ == bases_differ)
        return sides_differ ? 1 : -1;
    int order = tia_cmp_products((uint64_t)(num_abs(l->x) * num_abs(g->x)), (uint64_t)square, (uint64_t)num_abs(l_base),
                                 (uint64_t)num_abs(g_base));
    return (order > 0) == sides_differ ? 1 : -1;
}

/* Sets the index to about that of the first pixel. */
static void find_index(struct step_row *row)
{
    int low = 0, high_index = row->steps->count;

    while (low < high_index) {
        int middle = (low + high_index) / 2;
        if (side_of(row, middle) > 0)
            low = middle + 1;
        else
            high_index = middle;
    }
    row->index = low;
    row->pixel = steps_pixel(row->steps, low);
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
    row->turn = turn_of(primary, sphere, steps, y);
    row->turned = row->sure = false;
    row->slow = 0;
    steps_set_order(row, false);
    find_index(row);
}

static void advance(struct step_row *row)
{
    row->d += row->d_step;
    row->d_step += row->d_twice;
    row->at++;
}

static void retreat(struct step_row *row)
{
    row->d_step -= row->d_twice;
    row->d -= row->d_step;
    row->at--;
}

/* Decides a pixel by the steps on both sides; false if it is in doubt. */
static bool draw_pixel(struct step_row *row, tia_rgb565 *pixel)
{
    int above, below = 1, before = row->index;

    while ((above = side_of(row, row->index)) > 0)
        steps_pass(row, 1);
    if (row->index == before)
        while ((below = side_of(row, row->index - 1)) < 0)
            steps_pass(row, -1);
    if (row->index < before)
        above = -1;
    row->turned = row->turned || (row->sure && (row->index - before) * row->turn < 0);
    row->sure = row->turn > 0 ? below > 0 : above < 0;
    row->slow -= row->slow > 0;
    *pixel = steps_shown(row);
    advance(row);
    return above && below;
}

/* True if u at the pixel before this one is certainly on this side of the step behind it. */
static bool was_before(struct step_row *row)
{
    retreat(row);
    int side = side_of(row, row->turn > 0 ? row->index - 1 : row->index);
    advance(row);
    return side == row->turn;
}

/* Draws up to `count` pixels, 0 if one must be decided by the steps on both sides. Before the extremum u may have
 * turned since it passed a step. */
static int draw_run(struct step_row *row, int count, tia_rgb565 *pixels)
{
    int passed, drawn = steps_walk(row, row->turned ? -row->turn : row->turn, count, &passed, pixels);

    if (!row->turned && drawn > passed && !was_before(row))
        for (; drawn > passed; drawn--, row->slow++)
            retreat(row);
    return drawn;
}

uint64_t steps_draw(struct step_row *row, tia_rgb565 *pixels)
{
    int count = row->count - row->at < STEPS_BLOCK ? row->count - row->at : STEPS_BLOCK;
    uint64_t open = 0;

    for (int i = 0; i < count;) {
        if (row->slow > 0 || !(row->turned || row->sure)) {
            if (!draw_pixel(row, pixels + i))
                open |= UINT64_C(1) << i;
            i++;
        } else {
            i += draw_run(row, count - i, pixels + i);
        }
    }
    return open;
}
