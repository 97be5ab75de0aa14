/* contact.h - falling balls and their obstacles: positions, contacts and contact normals.
 *
 * Positions are Q23.40, velocities Q31.32 per second, accelerations Q39.24 per second^2, and times are in units of
 * 2^-20 s within a tick of 2^-8 s. With gravity in Q16.16, a whole tick without a contact is therefore exact.
 */
#ifndef TIA_SCENE_FALL_CONTACT_H
#define TIA_SCENE_FALL_CONTACT_H

#include <tia/motion.h>

#define FALL_TICK UINT32_C(4096)         /* units of time */
#define FALL_NEVER UINT32_MAX            /* a time: no contact in this tick */
#define FALL_FARTHEST (INT64_C(1) << 54) /* largest coordinate, 2^14: beyond it a ball is lost */
#define FALL_FASTEST (INT64_C(1) << 47)  /* largest velocity, 2^15: above it a ball is lost */
#define FALL_ONE (INT64_C(1) << 62)      /* 1.0 in a normal, Q1.62 */

struct fall_ball {
    const struct tia_track *shown; /* visibility over time; NULL: always shown */
    int64_t start[3], radius;
    int64_t place[3], velocity[3], pull[3]; /* state at the time `at`; pull: gravity minus the support of other
                                             * bodies */
    uint32_t at;
    uint32_t next, partner; /* next contact: its time, and the number of the other body */
    uint32_t met;           /* number of contacts so far in this tick */
    bool there, lost;       /* there: shown and not lost, and so part of the simulation */
    bool held;              /* rests on a body in this tick */
    bool stopped;           /* stands still: too many contacts in this tick */
};

/* A plane or a box. */
struct fall_block {
    const struct tia_track *shown;
    bool is_box, there;
    int64_t place[3];        /* the plane's point, or the box's origin */
    int64_t axes[3][3];      /* a box's axes, Q2.62; axes[0] of a plane is its normal */
    int64_t min[3], max[3];  /* a box's extent, along its axes */
    int64_t low[3], high[3]; /* the box's bounds in the world */
};

struct cancel;

struct falling {
    const struct tia_falling *given;
    struct fall_ball *balls;
    struct fall_block *blocks;
    uint32_t ball_count, block_count;
    uint32_t now; /* current time in the tick */
    struct cancel *cancel;
};

int64_t tia_fall_place(const struct fall_ball *ball, int axis, uint32_t time);
int64_t tia_fall_velocity(const struct fall_ball *ball, int axis, uint32_t time);

/* True if at `time` the ball overlaps body `other` and moves deeper into it. `other` is the number of a ball, or
 * ball_count plus the number of a block. */
bool tia_fall_touches(const struct falling *f, const struct fall_ball *ball, uint32_t other, uint32_t time);

/* True if the ball may touch body `other` in this tick, unless another contact comes first. */
bool tia_fall_is_near(const struct falling *f, const struct fall_ball *ball, uint32_t other);

/* Writes the normal of the contact at `time`: the direction from body `other` to the ball, Q1.62. */
void tia_fall_normal(const struct falling *f, const struct fall_ball *ball, uint32_t other, uint32_t time,
                     int64_t normal[3]);

/* Returns body `other` if it is a ball, or NULL for a block. */
struct fall_ball *tia_fall_partner(const struct falling *f, uint32_t other);

#endif
