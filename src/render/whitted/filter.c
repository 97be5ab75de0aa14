/* filter.c - textures integrated over footprints.
 *
 * A checker is 1/2 + s(u) s(v)/2 of its even colour, and the rest of its odd one, where s is the square wave, 1 in even
 * cells and -1 in odd ones. Its integral S is a triangular wave between 0 and 1, and the mean of s over a box of width
 * w is (S(u + w/2) - S(u - w/2))/w. The footprint, a parallelogram with the edges l and s in u and v, is cut across its
 * longer edge l into PIECES parallelograms. Each stands for a box with the same centre and the same variances along u
 * and v: (l/PIECES)^2/12 + s^2/12 = w^2/12.
 *
 * Pictures and noise have no such form. They are averaged over several places along the longer edge, each over a
 * round part whose width is that of the shorter edge or, if it is longer, that of a piece: see probes.c. */
#include "filter.h"

#include "probes.h"
#include "render/trace/texture.h"
#include "scene/picture.h"

#define NARROW (NUM_LENGTH_ONE / 1024) /* a narrower box is its centre: S would be divided by its rounding */

/* Puts the longer edge first. */
static void order(struct print *p)
{
    if (print_length(p->edge[1]) <= print_length(p->edge[0]))
        return;
    for (int k = 0; k < 3; k++) {
        num_length longer = p->edge[1][k];
        p->edge[1][k] = p->edge[0][k];
        p->edge[0][k] = longer;
    }
}

static num_length size(num_length x)
{
    return x < 0 ? -x : x;
}

/* Returns S(x). */
static num_length wave_integral(num_length x)
{
    int32_t cell = num_floor(x);
    num_length part = x - num_integer(cell);

    return cell & 1 ? NUM_LENGTH_ONE - part : part;
}

/* Returns the mean of the square wave over a box. */
static num_length wave_mean(num_length x, num_length width)
{
    if (width < NARROW)
        return num_floor(x) & 1 ? -NUM_LENGTH_ONE : NUM_LENGTH_ONE;
    num_length mean = num_ratio(wave_integral(x + width / 2) - wave_integral(x - width / 2), width);
    return num_length_clamp(mean, -NUM_LENGTH_ONE, NUM_LENGTH_ONE);
}

/* True if the footprint is inside one cell along an axis. */
static bool is_in_cell(const struct print *p, int axis)
{
    num_length half = (size(p->edge[0][axis]) + size(p->edge[1][axis])) / 2;

    return num_floor(p->part[axis] - half) == num_floor(p->part[axis] + half);
}

/* Returns the part of the footprint in odd cells. */
static num_length odd_part(const struct print *p)
{
    num_length sum = 0;

    for (int i = 0; i < PIECES; i++) {
        num_length mean[2];
        for (int k = 0; k < 2; k++) {
            num_length centre = p->part[k] + num_integer(p->cell[k] & 1);
            num_length piece = p->edge[0][k] / PIECES;
            num_length at = centre + piece * (num_length)(2 * i + 1 - PIECES) / 2;
            mean[k] = wave_mean(at, num_norm3(piece, p->edge[1][k], 0));
        }
        sum += num_product(mean[0], mean[1]);
    }
    return (NUM_LENGTH_ONE - sum / PIECES) / 2;
}

/* Computes the mean of a checker. Returns false if the footprint is inside one cell. */
static bool mean_of_checker(const struct tia_texture *t, const struct print *p, num_length rgb[3])
{
    if (is_in_cell(p, 0) && is_in_cell(p, 1))
        return false;
    ray_rgb_blend(t->cells, odd_part(p), rgb);
    return true;
}

bool filter_texture(const struct ray_view *view, const struct hit *hit, struct num_point point,
                    const struct tia_texture *t, const struct num_point edge[2], num_length value[3])
{
    struct texture_place place;
    struct print p;

    if (texture_has_texels(t) && !t->mip_levels)
        return false;
    ray_texture_place(view, t, hit, point, &place);
    for (int i = 0; i < 2; i++)
        ray_texture_change(view, t, hit, point, &place, edge[i], p.edge[i]);
    for (int i = 0; i < texture_axes(t); i++)
        p.part[i] = texture_position(t, i, &place, &p.cell[i]);
    order(&p);
    if (t->kind == TIA_CHECKER)
        return mean_of_checker(t, &p, value);
    return t->kind == TIA_NOISE ? mean_of_noise(t, &p, value) : mean_of_picture(t, &p, value);
}
