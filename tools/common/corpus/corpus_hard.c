#include "corpus_hard.h"

#include "corpus_maker.h"
#include "corpus_ties.h"

#define STEPS 3 /* largest change of a length, in units of 2^-16 */

static tia_q16 steps(struct maker *m)
{
    return dice_between(&m->dice, -STEPS, STEPS);
}

static void shake(struct maker *m, struct tia_vec3 *centre)
{
    *centre = sum(*centre, dice_vec3(&m->dice, vec(-STEPS, -STEPS, -STEPS), vec(STEPS, STEPS, STEPS)), 1);
}

/* A scene of ties, in which each length is changed by a few steps. */
static void hard_tie(struct maker *m)
{
    corpus_make_tie(m, (unsigned)(dice_next(&m->dice) % CORPUS_TIES_KINDS));
    for (uint32_t i = 0; i < m->out->scene.sphere_count; i++) {
        shake(m, &m->out->spheres[i].centre);
        m->out->spheres[i].radius += dice_between(&m->dice, 0, STEPS);
    }
    for (uint32_t i = 0; i < m->out->scene.light_count; i++)
        shake(m, &m->out->lights[i].centre);
}

/* Balls that are tiny for their distance, in a narrow field of view. */
static void hard_small(struct maker *m)
{
    static const tia_q16 distances[] = {20 * ONE, 200 * ONE, 2000 * ONE}, radii[] = {64, 197, 655, 3277};
    tia_q16 far = distances[dice_next(&m->dice) % 3];

    set_size(m, 320, 240, heads(m) ? ONE : 2 * ONE);
    for (uint32_t i = 0; i < CORPUS_BALLS; i++) {
        struct tia_vec3 at =
            dice_vec3(&m->dice, vec(-far / 83, -far / 100, -far / 5 * 6), vec(far / 83, far / 100, -far / 5 * 3));
        add_ball(m, at, radii[dice_next(&m->dice) % 4], i % MATERIALS);
    }
    light_somewhere(m);
    add_light(m, dice_vec3(&m->dice, vec(-far, 0, -far), vec(far, far, far / 2)), 0, grey(FULL));
}

/* A half-transparent ball above a ground, with a light at its centre, around its top, or anywhere above or below its
 * centre. */
static void hard_lamp(struct maker *m)
{
    static const tia_q16 radii[] = {65, 655, 1311, 6554, ONE, 4 * ONE};
    tia_q16 r = radii[dice_next(&m->dice) % 6], up = dice_between(&m->dice, -r - 2, r + 2);
    struct tia_vec3 at = somewhere(m, vec(-1, -1, -8), vec(1, 2, -5));

    set_size(m, 160, 120, any_fov(m));
    if (heads(m))
        up = heads(m) ? 0 : r + steps(m);
    add_ball(m, vec(0, TIA_Q16(-1002), TIA_Q16(-5)), TIA_Q16(1000), WHITE);
    add_ball(m, at, r, CLEAR);
    add_ball(m, somewhere(m, vec(-2, -1, -9), vec(2, 1, -9)), ONE, RED);
    add_light(m, vec(at.x, at.y + up, at.z), 0, dice_rgb(&m->dice, 50, 100));
}

/* A light, or the eye and a light, within a few steps of a large ball's surface. */
static void hard_near(struct maker *m)
{
    struct frame f = any_frame(m);
    tia_q16 scale = dice_between(&m->dice, ONE / 2, 20 * ONE);
    struct tia_vec3 ground = sum(vec(0, 0, 0), f.up, -scale), foot = vec(0, 0, 0);

    set_size(m, 160, 120, any_fov(m));
    if (heads(m)) {
        foot = vec(0, -ONE, -TIA_Q16(3));
        ground = sum(ground, foot, 1);
    }
    tia_q16 radius = scale * f.length + steps(m);
    add_ball(m, ground, radius, heads(m) ? GREY : CLEAR);
    add_ball(m, somewhere(m, vec(-2, -1, -6), vec(2, 1, -6)), ONE, RED);
    shake(m, &foot);
    add_light(m, foot, 0, grey(FULL));
    light_somewhere(m);
}

void corpus_hard(struct corpus_scene *out, uint64_t seed, unsigned index)
{
    static void (*const kinds[])(struct maker *) = {hard_tie, hard_small, hard_lamp, hard_near};
    struct maker m;

    maker_begin(&m, out, seed, index);
    kinds[index % 4](&m);
    maker_end(&m);
}
