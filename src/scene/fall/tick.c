/* tick.c - the contacts of a tick, in chronological order. Each ball stores its next contact, which depends on the
 * current motion of all bodies. So a contact makes new searches necessary: for both balls, and for all balls whose next
 * contact is with one of them.
 */
#include "tick.h"

#include "math/wide.h"
#include "scene/cancel.h"
#include "scene/track.h"

/* Limit of a ball's contacts in a tick, after which the ball stands still: balls that touch many others could collide
 * forever. */
#define CONTACTS_MAX 32
#define PARTS_MAX 64 /* largest number of parts into which a tick is divided for a search */

static int64_t speed_of(const struct fall_ball *ball)
{
    int64_t most = 0;

    for (int i = 0; i < 3; i++) {
        int64_t speed = ball->velocity[i] < 0 ? -ball->velocity[i] : ball->velocity[i];
        most = speed > most ? speed : most;
    }
    return most;
}

/* Returns the number of parts into which a tick is divided, at most PARTS_MAX. In each part the ball should move,
 * relative to its partner, by at most a quarter of the smaller radius, so that it does not pass through. In a tick it
 * moves v 2^-8. */
static uint32_t parts(const struct fall_ball *ball, const struct fall_ball *partner)
{
    int64_t way = speed_of(ball) + (partner ? speed_of(partner) : 0), size = ball->radius;
    uint32_t count = 1;

    if (partner && partner->radius < size)
        size = partner->radius;
    while (count < PARTS_MAX && way / count > size / 4)
        count *= 2;
    return count;
}

/* Returns the last time before the contact. The bodies do not touch at the time `apart`, but at the time `touching`. */
static uint32_t last_apart(const struct falling *f, const struct fall_ball *ball, uint32_t other, uint32_t apart,
                           uint32_t touching)
{
    while (touching - apart > 1) {
        uint32_t middle = apart + (touching - apart) / 2;
        if (tia_fall_touches(f, ball, other, middle))
            touching = middle;
        else
            apart = middle;
    }
    return apart;
}

/* Returns the next time at which the ball meets body `other`, or FALL_NEVER. */
static uint32_t meeting(const struct falling *f, const struct fall_ball *ball, uint32_t other)
{
    if (!tia_fall_is_near(f, ball, other))
        return FALL_NEVER;
    uint32_t count = parts(ball, tia_fall_partner(f, other)), apart = f->now;
    for (uint32_t i = 1; i <= count; i++) {
        uint32_t time = f->now + (FALL_TICK - f->now) * i / count;
        if (time > apart && tia_fall_touches(f, ball, other, time))
            return last_apart(f, ball, other, apart, time);
        apart = time;
    }
    return FALL_NEVER;
}

static bool is_there(const struct falling *f, uint32_t other)
{
    return other < f->ball_count ? f->balls[other].there : f->blocks[other - f->ball_count].there;
}

/* Finds the ball's next contact; of several at the same time, the one with the body of the lowest number. */
static void look(const struct falling *f, uint32_t index)
{
    struct fall_ball *ball = &f->balls[index];
    uint32_t count = f->ball_count + f->block_count;

    ball->next = FALL_NEVER;
    if (!ball->there || ball->stopped)
        return;
    for (uint32_t other = 0; other < count && !cancelled(f->cancel, 1); other++) {
        uint32_t time = other != index && is_there(f, other) ? meeting(f, ball, other) : FALL_NEVER;
        if (time >= ball->next)
            continue;
        ball->next = time;
        ball->partner = other;
    }
}

static void advance(struct fall_ball *ball, uint32_t time)
{
    for (int i = 0; i < 3; i++) {
        int64_t place = tia_fall_place(ball, i, time);
        ball->velocity[i] = tia_fall_velocity(ball, i, time);
        ball->place[i] = place;
        ball->lost |= place > FALL_FARTHEST || place < -FALL_FARTHEST;
    }
    ball->lost |= speed_of(ball) > FALL_FASTEST;
    ball->there = ball->there && !ball->lost;
    ball->at = time;
}

/* Returns the ball's part of a change of velocity, Q1.62: the partner's share of the sum of both masses, or 1 if the
 * partner is fixed. */
static int64_t share(const struct falling *f, const struct fall_ball *ball, const struct fall_ball *partner)
{
    if (!partner || partner->stopped)
        return FALL_ONE;
    int64_t own = f->given->balls[ball - f->balls].mass, others = f->given->balls[partner - f->balls].mass;
    return wide_quotient(others, own + others, 62);
}

static void push(int64_t vector[3], const int64_t normal[3], int64_t by, int64_t part)
{
    int64_t amount = wide_round(wide_product(by, part), 62);

    for (int i = 0; i < 3; i++)
        vector[i] += wide_round(wide_product(normal[i], amount), 62);
}

/* Returns the speed along the normal at which the first body moves away from the second. `second` is NULL if that body
 * stands still. */
static int64_t parting(const int64_t first[3], const int64_t *second, const int64_t normal[3])
{
    int64_t between[3];

    for (int i = 0; i < 3; i++)
        between[i] = first[i] - (second ? second[i] : 0);
    return wide_round(wide_dot(between, normal), 62);
}

static tia_q16 restitution(const struct falling *f, const struct fall_ball *ball, const struct fall_ball *partner)
{
    tia_q16 own = f->given->balls[ball - f->balls].restitution;
    tia_q16 others = partner ? f->given->balls[partner - f->balls].restitution : own;
    return own < others ? own : others;
}

/* Removes the acceleration of two bodies towards each other. Changes only bodies that do not rest yet. */
static void hold(const struct falling *f, struct fall_ball *ball, struct fall_ball *partner, const int64_t normal[3],
                 int64_t pull)
{
    bool fixed = !partner || partner->stopped || partner->held;

    if (partner && ball->held && !fixed) {
        push(partner->pull, normal, pull, FALL_ONE);
        partner->held = true;
        return;
    }
    push(ball->pull, normal, -pull, fixed ? FALL_ONE : share(f, ball, partner));
    if (fixed)
        ball->held = true;
    else
        push(partner->pull, normal, pull, share(f, partner, ball));
}

/* Bounces the ball off its partner. A pull p, in units of 2^-24, changes a velocity, in units of 2^-32, by 2 p in 2/256
 * s. */
static void collide(struct falling *f, struct fall_ball *ball, struct fall_ball *partner, const int64_t normal[3])
{
    int64_t speed = parting(ball->velocity, partner ? partner->velocity : NULL, normal);
    int64_t pull = parting(ball->pull, partner ? partner->pull : NULL, normal);
    bool rests = pull < 0 && speed > 2 * pull;
    int64_t factor = TIA_Q16_ONE + (rests ? 0 : restitution(f, ball, partner));
    int64_t by = speed < 0 ? wide_round(wide_product(-speed, factor), 16) : 0;

    push(ball->velocity, normal, by, share(f, ball, partner));
    if (partner && !partner->stopped)
        push(partner->velocity, normal, -by, share(f, partner, ball));
    if (rests)
        hold(f, ball, partner, normal, pull);
}

static void count_contact(struct fall_ball *ball)
{
    if (++ball->met < CONTACTS_MAX)
        return;
    ball->stopped = true;
    for (int i = 0; i < 3; i++)
        ball->velocity[i] = ball->pull[i] = 0;
}

/* Searches again for the next contacts of the ball and of the balls whose next contact is with it or, if the ball has
 * stopped, of all balls. */
static void look_again(const struct falling *f, uint32_t index)
{
    for (uint32_t i = 0; i < f->ball_count; i++)
        if (i == index || f->balls[index].stopped || (f->balls[i].next != FALL_NEVER && f->balls[i].partner == index))
            look(f, i);
}

static void meet(struct falling *f, uint32_t index)
{
    struct fall_ball *ball = &f->balls[index], *partner = tia_fall_partner(f, ball->partner);
    uint32_t second = ball->partner;
    int64_t normal[3];

    f->now = ball->next;
    advance(ball, f->now);
    if (partner)
        advance(partner, f->now);
    tia_fall_normal(f, ball, second, f->now, normal);
    collide(f, ball, partner, normal);
    count_contact(ball);
    if (partner)
        count_contact(partner);
    look_again(f, index);
    if (partner)
        look_again(f, second);
}

static uint32_t first_to_meet(const struct falling *f)
{
    uint32_t first = 0;

    for (uint32_t i = 1; i < f->ball_count; i++)
        if (f->balls[i].next < f->balls[first].next)
            first = i;
    return first;
}

static bool is_shown(const struct tia_track *shown, uint32_t tick)
{
    return !shown || tia_track_shows(shown, (tia_q16)tick * (TIA_Q16_ONE >> 8));
}

static void begin(struct falling *f, uint32_t tick)
{
    const struct tia_vec3 *g = &f->given->gravity;

    f->now = 0;
    for (uint32_t i = 0; i < f->block_count; i++)
        f->blocks[i].there = is_shown(f->blocks[i].shown, tick);
    for (uint32_t i = 0; i < f->ball_count; i++) {
        struct fall_ball *ball = &f->balls[i];
        ball->at = ball->met = 0;
        ball->held = ball->stopped = false;
        ball->there = !ball->lost && is_shown(ball->shown, tick);
        ball->pull[0] = g->x * INT64_C(256);
        ball->pull[1] = g->y * INT64_C(256);
        ball->pull[2] = g->z * INT64_C(256);
    }
    for (uint32_t i = 0; i < f->ball_count; i++)
        look(f, i);
}

void tia_fall_tick(struct falling *f, uint32_t tick, uint32_t end)
{
    begin(f, tick);
    for (uint32_t i = first_to_meet(f); f->balls[i].next <= end && !f->cancel->stopped; i = first_to_meet(f))
        meet(f, i);
    for (uint32_t i = 0; i < f->ball_count; i++)
        if (f->balls[i].there)
            advance(&f->balls[i], end);
}
