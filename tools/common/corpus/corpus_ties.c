#include "corpus_ties.h"

#include "corpus_maker.h"

#define BIAS 8 /* 2^-13 in Q16.16 */

/* Chooses an image with a pixel in its middle. */
static void set_odd(struct maker *m)
{
    unsigned width = 41 + 2 * (unsigned)(dice_next(&m->dice) % 11);
    unsigned height = 31 + 2 * (unsigned)(dice_next(&m->dice) % 6);

    set_size(m, width, height, any_fov(m));
}

/* Chooses an image with a pixel that looks along the frame's vector `along`. With 90 degrees K is the height H. With an
 * odd k and H = -k along.z the pixel's v is k along: its x is even, as with an odd width, and its y is even where H is
 * odd, and odd where H is even. */
static void look_along(struct maker *m, const struct frame *f)
{
    int32_t k = 31 / -f->along.z | 1;

    set_size(m, 63, (unsigned)(-k * f->along.z), TIA_Q16(90));
}

static void swap(tia_q16 *a, tia_q16 *b)
{
    tia_q16 c = *a;

    *a = *b;
    *b = c;
}

/* Two balls, or a ball and a light, at the same distance in the pixels of a column, of a row or of a diagonal, or in
 * all pixels that see both. */
static void tie_order(struct maker *m)
{
    struct tia_vec3 one = somewhere(m, vec(0, -1, -9), vec(1, 1, -4)), other = one;
    tia_q16 r = eighths(m, 1, 2);

    set_odd(m);
    switch (dice_next(&m->dice) % 4) {
    case 0:
        other.x = -one.x;
        break;
    case 1:
        other.y = -one.y;
        break;
    case 2:
        swap(&other.x, &other.y);
        m->out->width = m->out->height = 30 + (unsigned)(dice_next(&m->dice) % 24);
        break;
    default:
        break;
    }
    add_ball(m, one, r, RED);
    if (dice_one_in(&m->dice, 3))
        add_light(m, other, r, (struct tia_rgb){FULL / 2, FULL / 3, 0});
    else
        add_ball(m, other, r, GREEN);
    light_somewhere(m);
}

/* Balls that the ray along a frame's first vector touches. */
static void tie_tangent(struct maker *m)
{
    struct frame f = any_frame(m);
    int32_t count = dice_between(&m->dice, 1, 3);

    look_along(m, &f);
    for (int32_t i = 0; i < count; i++) {
        tia_q16 far = dice_between(&m->dice, 8, 24) * (ONE / 8), r = dice_between(&m->dice, 1, 6) * (ONE / 16);
        struct tia_vec3 at = sum(vec(0, 0, 0), f.along, far);
        add_ball(m, sum(at, heads(m) ? f.aside : f.up, r), r * f.length, (uint32_t)i);
    }
    light_somewhere(m);
}

/* The eye on one or two balls, or on a light. */
static void tie_eye(struct maker *m)
{
    struct frame f = any_frame(m);
    struct tia_vec3 towards[] = {f.along, f.aside, f.up};
    tia_q16 scale = eighths(m, 1, 2);
    uint64_t first = dice_next(&m->dice) % 3;

    set_odd(m);
    for (uint64_t i = first; i < 3 && i < first + 2; i++) {
        struct tia_vec3 at = sum(vec(0, 0, 0), towards[i], scale);
        if (dice_one_in(&m->dice, 4) && !m->out->scene.light_count)
            add_light(m, at, scale * f.length, (struct tia_rgb){FULL, 0, 0});
        else
            add_ball(m, at, scale * f.length, i == first ? GREY : RED);
    }
    add_ball(m, vec(0, 0, TIA_Q16(-9)), TIA_Q16(2), GREEN);
    light_somewhere(m);
    light_somewhere(m);
}

/* Adds a ball that the middle pixel sees at (0, 0, -z), with the normal (0, 0, 1). Returns z. */
static tia_q16 add_stage(struct maker *m, uint32_t material)
{
    tia_q16 z = eighths(m, 8, 20), r = eighths(m, 1, 4);

    set_odd(m);
    add_ball(m, vec(0, 0, -z - r), r, material);
    return z;
}

/* Lights in the tangent plane of the visible point, at that point, and on another ball. */
static void tie_light(struct maker *m)
{
    struct tia_vec3 point = vec(0, 0, -add_stage(m, GREY));
    struct frame f = any_frame(m);
    struct tia_vec3 other = sum(sum(point, f.up, (ONE / 2) * dice_between(&m->dice, 1, 4)), f.aside, ONE / 2);
    struct tia_vec3 beside = heads(m) ? vec(1, 0, 0) : vec(0, 1, 0);

    add_light(m, sum(point, beside, eighths(m, 1, 6)), 0, grey(FULL));
    if (heads(m))
        add_light(m, point, 0, grey(FULL / 2));
    add_ball(m, other, f.length * (ONE / 4), heads(m) ? CLEAR : RED);
    add_light(m, sum(other, f.up, ONE / 4), heads(m) ? 0 : ONE / 8, grey(FULL));
}

/* A caster that the shadow ray of the middle pixel touches, or misses or hits by a step. The point of the ray next to
 * its centre is the ray's start, its end or a point between. */
static void tie_shadow(struct maker *m)
{
    tia_q16 z = add_stage(m, GREY), far = dice_between(&m->dice, 2, 8) * (ONE / 4), along = 0;
    tia_q16 aside = dice_between(&m->dice, 1, 4) * (ONE / 16);
    struct frame f = any_frame(m);

    mirror(&f, 1, 1, -1);
    add_light(m, sum(vec(0, 0, -z), f.along, far), 0, grey(FULL));
    switch (dice_next(&m->dice) % 4) {
    case 0:
        along = far;
        break;
    case 1:
        aside = dice_between(&m->dice, 65, 160);
        break;
    default:
        along = far / 8 * dice_between(&m->dice, 1, 7);
    }
    struct tia_vec3 foot = sum(vec(0, 0, BIAS - z), f.along, along);
    tia_q16 slack = heads(m) ? 0 : dice_between(&m->dice, -1, 1);
    add_ball(m, sum(foot, heads(m) ? f.aside : f.up, aside), aside * f.length + slack, CLEAR);
}

/* Channels that are odd multiples of 1/128, which some entry of the dithering matrix makes a tie, and red of 1/2, a tie
 * without dithering: by emission, by a light at the eye, by two lights on the axis, by a light whose cosine is 4/5, by
 * a visible light. */
static void tie_half(struct maker *m)
{
    tia_q30 green = FULL / 128 * (2 * dice_between(&m->dice, 0, 63) + 1);
    tia_q30 blue = FULL / 128 * (2 * dice_between(&m->dice, 0, 63) + 1);
    struct tia_rgb level = {FULL / 2, green, blue}, part = {FULL / 4, green / 2, blue / 2};
    uint64_t kind = dice_next(&m->dice) % 5;

    m->out->materials[GLOW].emission = level;
    struct tia_vec3 near = vec(0, 0, -add_stage(m, kind ? WHITE : GLOW));
    if (kind == 1)
        add_light(m, vec(0, 0, 0), 0, level);
    if (kind == 2)
        add_light(m, vec(0, 0, 0), 0, part);
    if (kind == 2)
        add_light(m, vec(0, 0, ONE), 0, part);
    if (kind == 3)
        add_light(m, sum(near, vec(3, 0, 4), eighths(m, 1, 3)), 0,
                  (struct tia_rgb){level.r / 4 * 5, level.g / 4 * 5, level.b / 4 * 5});
    if (kind == 4)
        add_light(m, sum(near, vec(0, 0, 1), TIA_Q16(3)), ONE, level);
}

/* The eye in one or two balls, around another ball; a light on the first ball and one outside of it. */
static void tie_inside(struct maker *m)
{
    struct frame f = any_frame(m);
    tia_q16 r = eighths(m, 3, 6), at = eighths(m, 0, 1) / 2;

    set_odd(m);
    add_ball(m, sum(vec(0, 0, 0), f.aside, at), r * f.length, CLEAR);
    if (heads(m))
        add_ball(m, sum(vec(0, 0, 0), f.aside, heads(m) ? at : -at), r * f.length, GREEN);
    add_ball(m, vec(0, 0, TIA_Q16(-2)), ONE / 2, WHITE);
    add_light(m, sum(m->out->spheres[0].centre, f.up, r), 0, grey(FULL));
    add_light(m, sum(vec(0, 0, 0), f.up, 2 * r), heads(m) ? 0 : ONE, grey(FULL / 2));
}

void corpus_make_tie(struct maker *m, unsigned kind)
{
    static void (*const kinds[CORPUS_TIES_KINDS])(struct maker *) = {tie_order,  tie_tangent, tie_eye,   tie_light,
                                                                     tie_shadow, tie_half,    tie_inside};

    kinds[kind % CORPUS_TIES_KINDS](m);
}

void corpus_ties(struct corpus_scene *out, uint64_t seed, unsigned index)
{
    struct maker m;

    maker_begin(&m, out, seed, index);
    corpus_make_tie(&m, index);
    maker_end(&m);
}
