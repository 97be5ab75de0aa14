/* bump.c - normals perturbed by the gradient of a texture.
 *
 * After Blinn, "Simulation of wrinkled surfaces" (1978). A surface with the normal N that is moved outwards by a height
 * h, small against its radius of curvature, has the normal N - grad h, normalised, where grad h = sum_i T_i dh/dT_i for
 * two tangents T_i of length 1 at right angles. With the texture's coordinates x_k, in cells or texels,
 *
 *     dh/dT_i = depth sum_k dv/dx_k dx_k/dT_i,
 *
 * where v is the texture's value. Both factors are differences between two places on either side of the point:
 * dx_k/dT_i between places 2 STEP apart, dv/dx_k between places that are so far apart that it is continuous:
 *
 *   - noise: 2^-5 of the unit of its finest octave
 *   - a picture: two texels of the bilinear value, whatever its own look-up is
 *   - a checker: an eighth of a cell. Its value is 1/2 - s(u) s(v)/2, where the square wave s, 1 in even cells and -1
 * in odd ones, has the mean over a width of 1/8 in place of its jumps.
 *
 * A normal beyond what the viewer sees, N.V < m, is moved by (m - N.V) V, which is continuous, too. */
#include "bump.h"

#include "noise.h"
#include "scene/picture.h"
#include "texture.h"

#define STEPS (INT32_C(1) << 13) /* 1/STEP */
#define STEP (NUM_LENGTH_ONE / (num_length)STEPS)
#define CELLS_MAX (16 * NUM_LENGTH_ONE) /* in 2 STEP */
#define RISE_MAX (8 * NUM_LENGTH_ONE)   /* in 2 STEP */
#define SEEN (NUM_UNIT_ONE / 64)        /* m */

/* A place in a texture: cells, and positions in them. */
struct spot {
    int32_t cell[3];
    num_length part[3];
};

/* Returns the number of steps in which the texture's value is looked up along an axis, for each repetition. */
static int32_t side_of(const struct tia_texture *t, int axis)
{
    return !texture_has_texels(t) ? 1 : axis ? t->height : t->width;
}

static num_length noise_at(const struct tia_texture *t, const struct spot *at)
{
    struct noise_place place = {{at->cell[0], at->cell[1], at->cell[2]}, {at->part[0], at->part[1], at->part[2]}};

    noise_carry(&place);
    return noise_value(&place, t->octaves, 0);
}

/* Returns the mean of the square wave over 1/8: a ramp around each edge of a cell. */
static num_length wave_at(const struct spot *at, int axis)
{
    int32_t whole = num_floor(at->part[axis]);
    num_length part = at->part[axis] - num_integer(whole), beyond = NUM_LENGTH_ONE - part;
    num_length ramp = num_length_clamp(16 * (part < beyond ? part : beyond), 0, NUM_LENGTH_ONE);

    return ((uint32_t)at->cell[axis] + (uint32_t)whole) & 1 ? -ramp : ramp;
}

static num_length picture_at(const struct tia_texture *t, const struct spot *at)
{
    const struct texels texels = texture_texels(t);
    num_length place[2], value[3], sum = 0;

    for (int k = 0; k < 2; k++)
        place[k] = (at->part[k] - num_integer(num_floor(at->part[k]))) * (num_length)side_of(t, k);
    texture_blend(&texels, place[0] - NUM_LENGTH_ONE / 2, place[1] - NUM_LENGTH_ONE / 2, value);
    for (unsigned c = 0; c < texels.channels; c++)
        sum += value[c];
    return sum / (num_length)texels.channels;
}

static num_length value_at(const struct tia_texture *t, const struct spot *at)
{
    if (t->kind == TIA_NOISE)
        return noise_at(t, at);
    if (t->kind == TIA_CHECKER)
        return NUM_LENGTH_ONE / 2 - num_product(wave_at(at, 0), wave_at(at, 1)) / 2;
    return picture_at(t, at);
}

/* Returns one over half the distance of the places between which the value's difference is taken, in cells or texels.
 */
static int32_t fineness(const struct tia_texture *t)
{
    return t->kind == TIA_NOISE ? INT32_C(32) << t->octaves : t->kind == TIA_CHECKER ? 16 : 1;
}

/* Computes dv/dx_k, in cells or texels. */
static void slopes(const struct tia_texture *t, const struct spot *at, num_length slope[3])
{
    const num_length parts = (num_length)fineness(t);

    for (int k = 0; k < texture_axes(t); k++) {
        const num_length half = NUM_LENGTH_ONE / parts / (num_length)side_of(t, k);
        struct spot before = *at, behind = *at;
        before.part[k] -= half;
        behind.part[k] += half;
        slope[k] = (value_at(t, &behind) - value_at(t, &before)) / 2 * parts;
    }
}

/* Returns the depth in the scene's unit, at most TIA_BUMP_MAX. */
static num_length depth_of(const struct ray_view *view, const struct tia_texture *t)
{
    const int bits = view->scene->scale_bits;
    const num_length depth = num_length_of(t->depth), most = num_length_of(TIA_BUMP_MAX);

    if (bits <= 0)
        return depth / (num_length)(INT32_C(1) << -bits);
    num_length limit = most / (num_length)(INT32_C(1) << bits);
    return num_length_clamp(depth, -limit, limit) * (num_length)(INT32_C(1) << bits);
}

/* Returns the change of the height over 2 STEP along a tangent. */
static num_length rise(const struct ray_view *view, const struct hit *hit, const struct tia_texture *t,
                       struct num_point point, struct num_dir tangent, const num_length slope[3])
{
    const struct num_point half = num_point_along(tangent, STEP);
    const struct num_point whole = num_point_add(half, half);
    const struct num_point begin = num_point_sub(point, half);
    num_length cells[3], sum = 0;
    struct texture_place from;

    ray_texture_place(view, t, hit, begin, &from);
    ray_texture_change(view, t, hit, begin, &from, whole, cells);
    for (int k = 0; k < texture_axes(t); k++) {
        const num_length side = (num_length)side_of(t, k);
        const num_length most = CELLS_MAX / side;
        sum += num_product(num_length_clamp(cells[k], -most, most) * side, slope[k]);
    }
    return num_length_clamp(num_product(sum, depth_of(view, t)), -RISE_MAX, RISE_MAX);
}

/* Turns a normal to the seen side, where it is not on it already. */
static struct num_dir turned_to(struct num_dir normal, struct num_dir viewer, num_unit before)
{
    const num_unit least = before < SEEN ? before : SEEN, facing = num_dir_dot(normal, viewer);

    if (facing >= least)
        return normal;
    return num_dir_normalised(num_dir_add(normal, num_dir_scaled(viewer, least - facing)));
}

void bump_normal(const struct ray_view *view, const struct hit *hit, struct num_point point, struct num_dir viewer,
                 bool back, struct num_dir *normal)
{
    const struct tia_material *m = &view->scene->materials[ray_material(view, hit->object, hit->element)];
    const struct tia_texture *t = &view->scene->textures[m->bump - 1];
    const num_unit before = num_dir_dot(*normal, viewer);
    struct num_point sum = num_point_along(*normal, NUM_LENGTH_ONE);
    struct texture_place place;
    struct num_dir tangents[2];
    num_length slope[3];
    struct spot at;

    ray_texture_place(view, t, hit, point, &place);
    for (int k = 0; k < texture_axes(t); k++)
        at.part[k] = texture_position(t, k, &place, &at.cell[k]);
    slopes(t, &at, slope);
    shape_axes(*normal, tangents);
    for (int i = 0; i < 2; i++) {
        num_length up = rise(view, hit, t, point, tangents[i], slope) * (num_length)(STEPS / 2);
        sum = num_point_add(sum, num_point_along(tangents[i], back ? up : -up));
    }
    if (num_normalise(sum, normal))
        *normal = turned_to(*normal, viewer, before);
}
