#include <tia/step.h>

#include "math/align.h"
#include "scene/cancel.h"
#include "scene/fall/fall.h"
#include "scene/fall/tick.h"
#include "scene/motion.h"

/* Largest coordinate in a saved state, 2^17: balls begin within 2^16, and one is gone in the tick in which it passes
 * FALL_FARTHEST. */
#define SAVED_FARTHEST (INT64_C(1) << 57)
#define PUSH_MOST (1024 * INT32_C(65536))

#define FNV_START UINT64_C(0xcbf29ce484222325) /* of FNV-1a with 64 bits */
#define FNV_PRIME UINT64_C(0x100000001b3)

static uint32_t balls_of(const struct tia_scene *scene)
{
    return scene->falling ? scene->falling->count : 0;
}

static struct falling falling_of(const struct tia_steps *steps, struct cancel *cancel)
{
    struct falling f = {.given = steps->scene->falling, .ball_count = balls_of(steps->scene), .cancel = cancel};

    f.balls = (struct fall_ball *)steps->balls;
    f.blocks = (struct fall_block *)steps->blocks;
    f.block_count = steps->block_count;
    return f;
}

size_t tia_steps_size(const struct tia_scene *scene)
{
    uint64_t size = !scene ? SIZE_MAX : scene->falling ? tia_fall_size(scene) : 0;
    return size > SIZE_MAX / 2 ? SIZE_MAX : (size_t)size;
}

int tia_steps_init(struct tia_steps *steps, void *memory, size_t size, const struct tia_scene *scene)
{
    struct cancel cancel = cancel_for(NULL);
    struct falling f = {.cancel = &cancel};
    size_t needed = tia_steps_size(scene);

    if (!steps || !scene || (needed && !memory_is_usable(memory)))
        return TIA_ERR_ARGUMENT;
    if (needed == SIZE_MAX || size < needed)
        return TIA_ERR_MEMORY;
    if (scene->falling)
        tia_fall_begin(&f, scene, memory);
    steps->scene = scene;
    steps->balls = f.balls;
    steps->blocks = f.blocks;
    steps->block_count = f.block_count;
    steps->step = 0;
    return TIA_OK;
}

static bool push_fits(tia_q16 velocity)
{
    return velocity >= -PUSH_MOST && velocity <= PUSH_MOST;
}

static int check_pushes(const struct tia_steps *steps, const struct tia_push *pushes, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        const struct tia_vec3 *v = &pushes[i].velocity;
        if (pushes[i].ball >= balls_of(steps->scene))
            return TIA_ERR_ARGUMENT;
        if (!push_fits(v->x) || !push_fits(v->y) || !push_fits(v->z))
            return TIA_ERR_RANGE;
    }
    return TIA_OK;
}

static void push(struct fall_ball *ball, const struct tia_vec3 *by)
{
    const tia_q16 velocity[3] = {by->x, by->y, by->z};

    for (int i = 0; i < 3; i++) {
        int64_t sum = ball->velocity[i] + velocity[i] * INT64_C(65536);
        ball->velocity[i] = sum < -FALL_FASTEST ? -FALL_FASTEST : sum > FALL_FASTEST ? FALL_FASTEST : sum;
    }
}

int tia_scene_step(struct tia_steps *steps, const struct tia_push *pushes, uint32_t count)
{
    if (!steps || !steps->scene || (count && !pushes))
        return TIA_ERR_ARGUMENT;
    struct cancel cancel = cancel_for(NULL);
    struct falling f = falling_of(steps, &cancel);
    int status = check_pushes(steps, pushes, count);

    if (status || steps->step >= TIA_STEPS_MAX)
        return status ? status : TIA_ERR_RANGE;
    for (uint32_t i = 0; i < count; i++)
        if (!f.balls[pushes[i].ball].lost)
            push(&f.balls[pushes[i].ball], &pushes[i].velocity);
    if (f.given)
        tia_fall_to(&f, steps->step, (uint32_t)f.given->end);
    steps->step++;
    return TIA_OK;
}

/* Writes a number of `count` bytes, the low one first; returns the byte behind it. */
static uint8_t *put_number(uint8_t *to, uint64_t number, int count)
{
    for (int i = 0; i < count; i++, number >>= 8)
        *to++ = (uint8_t)(number & 255);
    return to;
}

static uint64_t get_number(const uint8_t *from, int count)
{
    uint64_t number = 0;

    for (int i = count - 1; i >= 0; i--)
        number = number << 8 | from[i];
    return number;
}

/* Returns a number of two's complement. */
static int64_t get_signed(const uint8_t *from)
{
    uint64_t number = get_number(from, 8);
    return number >> 63 ? -(int64_t)~number - 1 : (int64_t)number;
}

static void put_head(const struct tia_steps *steps, uint8_t *to)
{
    *to++ = 't';
    *to++ = 'i';
    *to++ = 's';
    *to++ = '1';
    to = put_number(to, steps->step, 4);
    (void)put_number(to, balls_of(steps->scene), 4);
}

static void put_ball(const struct tia_steps *steps, uint32_t index, uint8_t *to)
{
    const struct fall_ball *ball = (const struct fall_ball *)steps->balls + index;

    *to++ = ball->lost;
    for (int i = 0; i < 3; i++)
        to = put_number(to, (uint64_t)ball->place[i], 8);
    for (int i = 0; i < 3; i++)
        to = put_number(to, (uint64_t)ball->velocity[i], 8);
}

static uint64_t hash(uint64_t sum, const uint8_t *bytes, int count)
{
    for (int i = 0; i < count; i++)
        sum = (sum ^ bytes[i]) * FNV_PRIME;
    return sum;
}

uint64_t tia_steps_hash(const struct tia_steps *steps)
{
    uint8_t bytes[TIA_STEPS_BALL];

    if (!steps || !steps->scene)
        return 0;
    put_head(steps, bytes);
    uint64_t sum = hash(FNV_START, bytes, TIA_STEPS_HEAD);
    for (uint32_t i = 0; i < balls_of(steps->scene); i++) {
        put_ball(steps, i, bytes);
        sum = hash(sum, bytes, TIA_STEPS_BALL);
    }
    return sum;
}

size_t tia_steps_saved_size(const struct tia_steps *steps)
{
    return steps && steps->scene ? TIA_STEPS_HEAD + (size_t)balls_of(steps->scene) * TIA_STEPS_BALL : SIZE_MAX;
}

int tia_steps_save(const struct tia_steps *steps, uint8_t *bytes, size_t size)
{
    if (!steps || !steps->scene || !bytes)
        return TIA_ERR_ARGUMENT;
    if (size < tia_steps_saved_size(steps))
        return TIA_ERR_MEMORY;
    put_head(steps, bytes);
    for (uint32_t i = 0; i < balls_of(steps->scene); i++)
        put_ball(steps, i, bytes + TIA_STEPS_HEAD + (size_t)i * TIA_STEPS_BALL);
    return TIA_OK;
}

static bool is_within(int64_t number, int64_t most)
{
    return number >= -most && number <= most;
}

/* True if a ball's bytes are those of a ball between two steps, for which no computation overflows. */
static bool is_ball(const uint8_t *from)
{
    for (int i = 0; i < 3; i++)
        if (!is_within(get_signed(from + 1 + 8 * i), SAVED_FARTHEST) ||
            (!from[0] && !is_within(get_signed(from + 25 + 8 * i), FALL_FASTEST)))
            return false;
    return from[0] <= 1;
}

static bool is_state(const struct tia_steps *steps, const uint8_t *bytes, size_t size)
{
    uint32_t count = balls_of(steps->scene);

    if (size != tia_steps_saved_size(steps) || bytes[0] != 't' || bytes[1] != 'i' || bytes[2] != 's' ||
        bytes[3] != '1' || get_number(bytes + 4, 4) > TIA_STEPS_MAX || get_number(bytes + 8, 4) != count)
        return false;
    for (uint32_t i = 0; i < count; i++)
        if (!is_ball(bytes + TIA_STEPS_HEAD + (size_t)i * TIA_STEPS_BALL))
            return false;
    return true;
}

int tia_steps_restore(struct tia_steps *steps, const uint8_t *bytes, size_t size)
{
    if (!steps || !steps->scene || !bytes)
        return TIA_ERR_ARGUMENT;
    if (!is_state(steps, bytes, size))
        return TIA_ERR_RANGE;
    steps->step = (uint32_t)get_number(bytes + 4, 4);
    for (uint32_t n = 0; n < balls_of(steps->scene); n++) {
        const uint8_t *from = bytes + TIA_STEPS_HEAD + (size_t)n * TIA_STEPS_BALL;
        struct fall_ball *ball = (struct fall_ball *)steps->balls + n;
        ball->lost = from[0];
        for (int i = 0; i < 3; i++) {
            ball->place[i] = get_signed(from + 1 + 8 * i);
            ball->velocity[i] = get_signed(from + 25 + 8 * i);
        }
    }
    return TIA_OK;
}

int tia_steps_scene(const struct tia_steps *steps, struct tia_scene *out, void *memory, size_t size,
                    const struct tia_job *job)
{
    if (!steps || !steps->scene || out == steps->scene)
        return TIA_ERR_ARGUMENT;
    struct cancel cancel = cancel_for(job);
    struct falling f = falling_of(steps, &cancel);

    return tia_motion_at(out, memory, size, steps->scene, (tia_q16)(steps->step * 256), &f, job);
}
