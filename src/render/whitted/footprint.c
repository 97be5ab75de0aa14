/* footprint.c - footprints on surfaces, and checkers integrated over them.
 *
 * The neighbour of the ray O + t D starts at O' in the direction D'. With v = O' + t D' - P, linearised, it meets the
 * tangent plane at P, whose normal is N, at P + v - D (v.N)/(D.N). Towards the horizon D.N goes to 0 and the footprint
 * grows without limit. So v and the quotient are cut to 2^15, and positions stay below P + 2^16.
 *
 * A checker is 1/2 + s(u) s(v)/2 of its even colour, and the rest of its odd one, where s is the square wave, 1 in even
 * cells and -1 in odd ones. Its integral S is a triangular wave between 0 and 1, and the mean of s over a box of width
 * w is (S(u + w/2) - S(u - w/2))/w. The footprint, a parallelogram with the edges l and s in u and v, is cut across its
 * longer edge l into PIECES parallelograms. Each stands for a box with the same centre and the same variances along u
 * and v: (l/PIECES)^2/12 + s^2/12 = w^2/12. */
#include "footprint.h"

#include "render/geometry/round.h"
#include "render/trace/texture.h"
#include "scene/colour.h"

#define REACH (NUM_LENGTH_FAR / 2) /* 2^15 */
#define PIECES 8
#define NARROW (NUM_LENGTH_ONE / 1024) /* a narrower box is its centre: S would be divided by its rounding */

/* A footprint's edges in the texture's cells, with the cell and the position in it of its centre. */
struct print {
    num_length edge[2][2]; /* [0]: the longer edge, along u and v */
    num_length centre[2];  /* 0..2: modulo two cells */
};

static struct num_point cut(struct num_point p)
{
    return (struct num_point){num_length_clamp(p.x, -REACH, REACH), num_length_clamp(p.y, -REACH, REACH),
                              num_length_clamp(p.z, -REACH, REACH)};
}

/* Returns the change of the hit's point from a ray to its neighbour. */
static struct num_point moved(const struct ray *ray, const struct ray *next, num_length t, const struct shading *s)
{
    struct num_point v = cut(num_point_sub(num_point_at(next->origin, next->direction, t), s->point));
    num_length dt = num_div(num_point_dot(v, s->geometric), num_dir_dot(ray->direction, s->geometric));

    return num_point_sub(v, num_point_along(ray->direction, num_length_clamp(dt, -REACH, REACH)));
}

static bool is_long(num_length x)
{
    return x > NUM_LENGTH_ONE || x < -NUM_LENGTH_ONE;
}

/* Halves a vector until no component is above 1. Returns the number of times. */
static int shorten(struct num_point *v)
{
    int times = 0;

    for (; is_long(v->x) || is_long(v->y) || is_long(v->z); times++)
        *v = (struct num_point){v->x / 2, v->y / 2, v->z / 2};
    return times;
}

/* Returns the change of a coordinate that goes round, 0 and 1 being one place. */
static num_length around(num_length x)
{
    return x > NUM_LENGTH_ONE / 2 ? x - NUM_LENGTH_ONE : x < -NUM_LENGTH_ONE / 2 ? x + NUM_LENGTH_ONE : x;
}

/* Returns the kind of the shape that is hit, or of the member of a solid, and its element. */
static const struct shape_kind *kind_of(const struct ray_view *view, const struct hit *hit, uint32_t *element)
{
    uint32_t spheres = view->scene->sphere_count;

    *element = hit->element;
    return hit->object < spheres ? &SHAPE_KIND(sphere)
                                 : shape_part(&view->shapes[hit->object - spheres], element)->kind;
}

/* True if the coordinate u goes round at the hit: on spheres, and on the sides of cylinders and cones. */
static bool is_round(const struct ray_view *view, const struct hit *hit)
{
    uint32_t element;
    const struct shape_kind *kind = kind_of(view, hit, &element);
    bool has_sides = kind == &SHAPE_KIND(cylinder) || kind == &SHAPE_KIND(cone);

    return kind == &SHAPE_KIND(sphere) || (has_sides && element == ROUND_SIDE);
}

/* True for the shapes whose coordinates u, v continue beyond their edges. */
static bool has_footprints(const struct ray_view *view, const struct hit *hit)
{
    uint32_t element;
    const struct shape_kind *kind = kind_of(view, hit, &element);

    return kind != &SHAPE_KIND(triangle) && kind != &SHAPE_KIND(mesh);
}

static struct num_pattern pattern_of(const struct tia_texture *t, int axis)
{
    return (struct num_pattern){t->repeat[axis], t->offset[axis], t->repeat_bits, t->offset_bits};
}

/* Sets an edge of the footprint from the change of the hit's point. */
static void set_edge(const struct ray_view *view, const struct hit *hit, const struct shading *s,
                     const struct tia_texture *t, struct num_point change, num_length edge[2])
{
    int times = shorten(&change);
    num_length from[2], to[2];
    int bits = ray_uv(view, hit, s->point, from) + times;

    (void)ray_uv(view, hit, num_point_add(s->point, change), to);
    for (int i = 0; i < 2; i++) {
        const struct num_pattern pattern = pattern_of(t, i);
        num_length d = to[i] - from[i];

        if (i == 0 && is_round(view, hit))
            d = around(d);
        edge[i] = num_repeats(d, bits, &pattern);
    }
}

static void set_centre(const struct ray_view *view, const struct hit *hit, const struct shading *s,
                       const struct tia_texture *t, num_length centre[2])
{
    num_length uv[2];
    int bits = ray_uv(view, hit, s->point, uv);

    for (int i = 0; i < 2; i++) {
        const struct num_pattern pattern = pattern_of(t, i);
        int32_t cell;

        centre[i] = num_repeat(uv[i], bits, &pattern, &cell);
        centre[i] += num_integer(cell & 1);
    }
}

static num_length size(num_length x)
{
    return x < 0 ? -x : x;
}

/* Puts the longer edge first. */
static void order(struct print *p)
{
    if (num_norm3(p->edge[1][0], p->edge[1][1], 0) <= num_norm3(p->edge[0][0], p->edge[0][1], 0))
        return;
    for (int k = 0; k < 2; k++) {
        num_length longer = p->edge[1][k];
        p->edge[1][k] = p->edge[0][k];
        p->edge[0][k] = longer;
    }
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

    return num_floor(p->centre[axis] - half) == num_floor(p->centre[axis] + half);
}

/* Returns the part of the footprint in odd cells. */
static num_length odd_part(const struct print *p)
{
    num_length sum = 0;

    for (int i = 0; i < PIECES; i++) {
        num_length mean[2];
        for (int k = 0; k < 2; k++) {
            num_length piece = p->edge[0][k] / PIECES;
            num_length at = p->centre[k] + piece * (num_length)(2 * i + 1 - PIECES) / 2;
            mean[k] = wave_mean(at, num_norm3(piece, p->edge[1][k], 0));
        }
        sum += num_product(mean[0], mean[1]);
    }
    return (NUM_LENGTH_ONE - sum / PIECES) / 2;
}

/* Computes the material's colour times the checker's mean over the footprint. */
static void mix(const struct tia_texture *t, num_length odd, struct shading *s)
{
    num_length even_rgb[3], odd_rgb[3];

    ray_rgb(&s->material->colour, s->colour);
    ray_rgb(&t->cells[0], even_rgb);
    ray_rgb(&t->cells[1], odd_rgb);
    for (int c = 0; c < 3; c++)
        s->colour[c] = num_product(s->colour[c], even_rgb[c] + num_product(odd, odd_rgb[c] - even_rgb[c]));
    s->textured[0] = false;
}

void footprint_filter(const struct ray_view *view, const struct light_pixel *pixel, int sample, const struct ray *ray,
                      const struct hit *hit, struct shading *s)
{
    uint32_t number = s->material->texture;
    const struct tia_texture *t = number ? &view->scene->textures[number - 1] : NULL;
    struct print p;

    if (!t || !t->footprint || t->kind != TIA_CHECKER || colour_is_black(&s->material->colour) ||
        !has_footprints(view, hit))
        return;
    for (int i = 0; i < 2; i++) {
        struct ray next;
        ray_camera_next(&view->camera, pixel, sample, i, &next);
        set_edge(view, hit, s, t, moved(ray, &next, hit->t, s), p.edge[i]);
    }
    set_centre(view, hit, s, t, p.centre);
    if (is_in_cell(&p, 0) && is_in_cell(&p, 1))
        return;
    order(&p);
    mix(t, odd_part(&p), s);
}
