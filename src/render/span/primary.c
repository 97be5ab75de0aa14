#include "primary.h"

#include "math/integer.h"
#include "math/trig.h"

/* The lattice's exponent makes |v| < 2^30 in every pixel, and beyond the last one as far as row_square
 * looks: its step there, 4 X + 4 for X = width + 1 and less, is below (width + 3)^2. */
void lattice_prepare(struct lattice *lattice, unsigned width, unsigned height, tia_q16 fov)
{
    uint64_t cotangent = tia_cotangent(fov);
    uint64_t w = (uint64_t)width + 3, h = (uint64_t)height + 1;
    uint64_t d = (h * ((cotangent >> 40) + 1) >> 16) + 1;
    int bits = 64 - (int)tia_clz64(w * w + h * h + d * d);

    lattice->width = (int)width;
    lattice->height = (int)height;
    lattice->exponent = 30 - (bits + 1) / 2;
    lattice->depth = num_depth(height, cotangent, lattice->exponent);
    lattice->x_reach = num_lattice((int32_t)w, lattice->exponent);
    lattice->y_reach = num_lattice((int32_t)h, lattice->exponent);
    num_wide most =
        lattice->x_reach * lattice->x_reach + lattice->y_reach * lattice->y_reach + lattice->depth * lattice->depth;
    lattice->square_shift = 63 - num_bits(most + num_shift(most, -20));
}

num_wide lattice_reach(const struct lattice *lattice, struct num_vec a)
{
    num_wide reach = num_abs(a.x) * lattice->x_reach + num_abs(a.y) * lattice->y_reach + num_abs(a.z) * lattice->depth;
    return reach + num_shift(reach, -20); /* room for NUM_HALF */
}

num_wide lattice_y(const struct lattice *lattice, int y)
{
    return num_lattice(lattice->height - 2 * y - 1, lattice->exponent);
}

struct row_form lattice_form(const struct lattice *lattice, struct num_vec a, int x, int y, int shift)
{
    int middle = lattice->width / 2;
    num_wide middle_x = num_lattice(2 * middle + 1 - lattice->width, lattice->exponent);
    num_wide start = a.x * middle_x + a.y * lattice_y(lattice, y) - a.z * lattice->depth;
    struct row_form form = {num_shift(start, shift) + NUM_HALF,
                            num_shift(a.x * num_lattice(2, lattice->exponent), shift)};

    /* From the middle no product is larger than the form itself; and where the shift rounds, every
     * pixel's value is the same wherever a run begins. */
    form.start += (num_wide)(x - middle) * form.step;
    return form;
}

struct row_square lattice_square(const struct lattice *lattice, int x, int y)
{
    int shift = lattice->square_shift;
    num_wide first = num_lattice(2 * x + 1 - lattice->width, lattice->exponent), row = lattice_y(lattice, y);
    num_wide step = num_lattice(2, lattice->exponent);
    num_wide square = first * first + row * row + lattice->depth * lattice->depth;
    struct row_square s = {num_shift(square, shift) + NUM_HALF, num_shift(step * (2 * first + step), shift),
                           num_shift(2 * step * step, shift)};

    return s;
}
