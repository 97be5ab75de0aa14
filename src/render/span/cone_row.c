#include "math/fast.h"

#include "cone_row.h"

#include "math/integer.h"
#include "span_shift.h"

static num_wide coordinate_at(const struct cone_row *s, int i)
{
    return num_pixel_coordinate(2 * i + 1 - s->count, s->exponent);
}

static bool inside(const struct cone_row *s, int i)
{
    num_wide x = coordinate_at(s, i);
    int inside = num_cone(s->slope * x + s->base, s->c, num_square(x) + s->square, s->doubt);

    return inside ? inside > 0 : !s->shows || s->shows(s->view, i, s->y, s->object);
}

/* True if L.v/|v| still grows at pixel i: its derivative has the sign of slope square - base X. */
static bool rising(const struct cone_row *s, int i)
{
    return span_product_above(s->slope, s->square, s->base, coordinate_at(s, i));
}

/* Returns the pixel where L.v/|v| is largest, or its left neighbour. */
static int peak(const struct cone_row *s)
{
    int low = 0, high = s->count;

    if (s->base <= 0)
        return s->slope > 0 ? s->count - 1 : 0;
    while (high - low > 1) {
        int middle = (low + high) / 2;
        if (rising(s, middle))
            low = middle;
        else
            high = middle;
    }
    return low;
}

/* Returns the last pixel inside the cone on the way from `in`, a pixel inside, to the end of the line in the direction
 * `step`, +1 or -1. `guess` affects only the speed. */
static int boundary(const struct cone_row *s, int in, int step, int guess)
{
    int out = step > 0 ? s->count : -1;
    int stride = step;

    if ((guess - in) * step > 0 && (out - guess) * step > 0) {
        if (inside(s, guess))
            in = guess;
        else
            out = guess;
    }
    for (bool grow = in == guess; in + step != out; stride *= 2) {
        int probe = grow ? in + stride : out - stride;
        if ((probe - in) * step <= 0 || (out - probe) * step <= 0)
            break;
        if (inside(s, probe) == grow) {
            *(grow ? &in : &out) = probe;
        } else {
            *(grow ? &out : &in) = probe;
            break;
        }
    }
    while (in + step != out) {
        int middle = in + (out - in) / 2;
        *(inside(s, middle) ? &in : &out) = middle;
    }
    return in;
}

/* Returns a pixel inside the cone, or -1 if there is none; `guess` affects only the speed. */
static int any_inside(const struct cone_row *s, struct span guess)
{
    int middle = guess.first + (guess.end - guess.first) / 2;

    if (guess.first < guess.end && inside(s, middle))
        return middle;
    middle = peak(s);
    if (inside(s, middle))
        return middle;
    return middle + 1 < s->count && inside(s, middle + 1) ? middle + 1 : -1;
}

struct span cone_row_span(const struct cone_row *cone_row, struct span guess)
{
    struct span span = {0, 0}, near = guess;
    if (guess.first >= guess.end && !TIA_SHIFTS_BITS)
        near = cone_row_estimate(cone_row);
    int seed = any_inside(cone_row, near);

    if (seed >= 0) {
        span.first = boundary(cone_row, seed, -1, near.first);
        span.end = boundary(cone_row, seed, 1, near.end - 1) + 1;
    }
    return span;
}
