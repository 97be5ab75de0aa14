/* corpus_maker.h - functions that make scenes of a few balls, shared by corpus_ties.c and corpus_hard.c. */
#ifndef TOOLS_COMMON_CORPUS_CORPUS_MAKER_H
#define TOOLS_COMMON_CORPUS_CORPUS_MAKER_H

#include "corpus.h"
#include "dice.h"

#define ONE TIA_Q16_ONE
#define FULL TIA_Q30_ONE

enum { RED, GREEN, GREY, WHITE, GLOW, CLEAR, MATERIALS }; /* materials of all scenes */

/* A scene being made. Positions are relative to the eye until maker_end(). */
struct maker {
    struct corpus_scene *out;
    uint64_t dice; /* state of the random numbers */
};

static inline void add_ball(struct maker *m, struct tia_vec3 centre, tia_q16 radius, uint32_t material)
{
    struct tia_scene *scene = &m->out->scene;

    m->out->spheres[scene->sphere_count++] = (struct tia_sphere){centre, radius, material};
}

static inline void add_light(struct maker *m, struct tia_vec3 centre, tia_q16 radius, struct tia_rgb emission)
{
    struct tia_light *light = &m->out->lights[m->out->scene.light_count++];

    light->centre = centre;
    light->radius = radius;
    light->emission = emission;
}

static inline struct tia_vec3 vec(tia_q16 x, tia_q16 y, tia_q16 z)
{
    return (struct tia_vec3){x, y, z};
}

static inline struct tia_rgb grey(tia_q30 level)
{
    return (struct tia_rgb){level, level, level};
}

/* Returns a + scale b. */
static inline struct tia_vec3 sum(struct tia_vec3 a, struct tia_vec3 b, int32_t scale)
{
    return vec(a.x + scale * b.x, a.y + scale * b.y, a.z + scale * b.z);
}

/* Returns a random multiple of an eighth from low to high, so that sums and small multiples of such numbers are
 * exact. */
static inline tia_q16 eighths(struct maker *m, int32_t low, int32_t high)
{
    return dice_between(&m->dice, 8 * low, 8 * high) * (ONE / 8);
}

static inline void set_size(struct maker *m, unsigned width, unsigned height, tia_q16 fov)
{
    m->out->width = width;
    m->out->height = height;
    m->out->scene.camera.fov = fov;
}

static inline tia_q16 any_fov(struct maker *m)
{
    switch (dice_next(&m->dice) % 4) {
    case 0:
        return TIA_Q16(90);
    case 1:
        return TIA_Q16(25);
    case 2:
        return TIA_Q16(61.5);
    default:
        return dice_between(&m->dice, TIA_Q16(15), TIA_Q16(110));
    }
}

/* Returns a random point whose coordinates are multiples of an eighth, from low to high in whole units. Each statement
 * draws one random number, here and in the files that include this one, since compilers choose the order in which
 * arguments are evaluated. */
static inline struct tia_vec3 somewhere(struct maker *m, struct tia_vec3 low, struct tia_vec3 high)
{
    struct tia_vec3 zero = {0, 0, 0};

    return sum(zero, dice_vec3(&m->dice, sum(zero, low, 8), sum(zero, high, 8)), ONE / 8);
}

static inline void light_somewhere(struct maker *m)
{
    struct tia_vec3 at = somewhere(m, vec(-6, 3, -5), vec(6, 9, 6));
    tia_q16 radius = dice_one_in(&m->dice, 2) ? 0 : ONE / 4;

    add_light(m, at, radius, dice_rgb(&m->dice, 50, 100));
}

/* True in half of all cases. */
static inline bool heads(struct maker *m)
{
    return dice_one_in(&m->dice, 2);
}

/* ---- directions whose lengths are whole numbers ---- */

/* Three integer vectors of one length, at right angles to each other. */
struct frame {
    struct tia_vec3 along, aside, up;
    int32_t length;
};

/* Multiplies the coordinates of the vectors by x, y and z, each of which is 1 or -1. */
static inline void mirror(struct frame *f, int32_t x, int32_t y, int32_t z)
{
    struct tia_vec3 *const vectors[] = {&f->along, &f->aside, &f->up};

    for (unsigned i = 0; i < 3; i++)
        *vectors[i] = vec(x * vectors[i]->x, y * vectors[i]->y, z * vectors[i]->z);
}

/* Returns a random frame whose first vector points away from the eye. */
static inline struct frame any_frame(struct maker *m)
{
    static const struct frame frames[] = {{{0, 0, -1}, {1, 0, 0}, {0, 1, 0}, 1},
                                          {{2, 3, -6}, {3, -6, -2}, {6, 2, 3}, 7},
                                          {{2, 1, -2}, {1, 2, 2}, {2, -2, 1}, 3},
                                          {{0, 3, -4}, {5, 0, 0}, {0, 4, 3}, 5}};
    struct frame f = frames[dice_next(&m->dice) % 4];
    uint64_t signs = dice_next(&m->dice);

    mirror(&f, signs & 1 ? -1 : 1, signs & 2 ? -1 : 1, 1);
    return f;
}

/* Begins a scene without objects, with all materials and a background. */
void maker_begin(struct maker *m, struct corpus_scene *out, uint64_t seed, unsigned index);

/* Moves the eye to a random place, or leaves it, and moves all objects with it. */
void maker_end(struct maker *m);

#endif
