/* contact.h - balls that fall and what they bounce off: where they are, whether they touch, and which way they part.
 *
 * Places are Q23.40, velocities Q31.32 a second, accelerations Q39.24 a second^2, and time runs in units of 2^-20 s
 * within a tick of 2^-8 s. With gravity in Q16.16 a whole tick without a contact is then exact.
 */
#ifndef TIA_SCENE_FALL_CONTACT_H
#define TIA_SCENE_FALL_CONTACT_H

#include <tia/motion.h>

#define FALL_TICK UINT32_C(4096)         /* units of time */
#define FALL_NEVER UINT32_MAX            /* not in this tick */
#define FALL_FARTHEST (INT64_C(1) << 54) /* of a place: 2^14 */
#define FALL_FASTEST (INT64_C(1) << 47)  /* of a velocity: 2^15 */
#define FALL_ONE (INT64_C(1) << 62)      /* of a normal, Q1.62 */

struct fall_ball {
    const struct tia_track *shown; /* NULL: always */
    int64_t start[3], radius;
    int64_t place[3], velocity[3], pull[3]; /* at the time `at`; the pull is gravity less what holds the ball */
    uint32_t at;
    uint32_t next, partner; /* when it meets what next: a ball, or ball_count plus a block */
    uint32_t met;           /* contacts in this tick */
    bool there, lost;       /* there: shown, and not lost */
    bool held;              /* it rests on something in this tick */
    bool stopped;           /* it had too many contacts in this tick */
};

/* A plane or a box. */
struct fall_block {
    const struct tia_track *shown;
    bool is_box, there;
    int64_t place[3];        /* of the plane's point, or the box's origin */
    int64_t axes[3][3];      /* of a box, Q2.62; axes[0] of a plane is its normal */
    int64_t min[3], max[3];  /* of a box, along its axes */
    int64_t low[3], high[3]; /* of a box, around it in the world */
};

struct cancel;

struct falling {
    const struct tia_falling *given;
    struct fall_ball *balls;
    struct fall_block *blocks;
    uint32_t ball_count, block_count;
    uint32_t now; /* in the tick */
    struct cancel *cancel;
};

int64_t tia_fall_place(const struct fall_ball *ball, int axis, uint32_t time);
int64_t tia_fall_velocity(const struct fall_ball *ball, int axis, uint32_t time);

/* Whether, at the time, the ball overlaps number `other`, a ball or ball_count plus a block, and gets deeper into it.
 */
bool tia_fall_touches(const struct falling *f, const struct fall_ball *ball, uint32_t other, uint32_t time);

/* Whether the ball may touch it in this tick, if nothing else comes between. */
bool tia_fall_is_near(const struct falling *f, const struct fall_ball *ball, uint32_t other);

/* The direction from the other to the ball, Q1.62. */
void tia_fall_normal(const struct falling *f, const struct fall_ball *ball, uint32_t other, uint32_t time,
                     int64_t normal[3]);

/* The ball with that number; NULL: it is a block. */
struct fall_ball *tia_fall_partner(const struct falling *f, uint32_t other);

#endif
