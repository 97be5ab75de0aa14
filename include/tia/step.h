/* step.h - lockstep: a scene step by step, with inputs, the same bits on every processor.
 *
 *     tia_steps_init(&steps, memory, sizeof memory, &scene);
 *     for each 1/256 s:
 *         tia_scene_step(&steps, pushes, count);       everybody's inputs for this step
 *         tia_steps_hash(&steps)                       equal for all who had the same inputs
 *
 * Programs that share a scene and send each other only their inputs see the same motion. After step n the scene is that
 * of tia_scene_at at n/256 s, except for what pushes have changed. A step costs as much as 1/256 s of tia_scene_at,
 * however many steps came before. A step depends on the scene, the state and the pushes and on nothing else, so a
 * program can go back, or join later, by a saved state. tia.h does not include this header.
 *
 * The state is the number of steps so far and for each falling ball its centre, its velocity, and whether it is gone.
 * Keyframes are functions of the number of steps. The scene is no part of the state: all need the same one. A saved
 * state has the same bytes on every processor, numbers with the low byte first:
 *
 *     bytes        contents
 *     0..3         "tis1"
 *     4..7         number of steps
 *     8..11        number of balls
 *     12..         for each ball, in the order of scene->falling, TIA_STEPS_BALL bytes:
 *     +0           1 if the ball is gone, see struct tia_fall; else 0
 *     +1..24       its centre's x, y and z, Q23.40, two's complement, 8 bytes each
 *     +25..48      its velocity, Q31.32 units of length per second, the same
 *
 * The hash is FNV-1a of 64 bits over these bytes. It notices differences that happen, not those that someone computes.
 */
#ifndef TIA_STEP_H
#define TIA_STEP_H

#include <tia/motion.h>

#ifdef __cplusplus
extern "C" {
#endif

#define TIA_STEPS_MAX (INT32_MAX >> 8) /* so that the time, the number of steps times 256, fits tia_q16 */
#define TIA_STEPS_HEAD 12              /* bytes of a saved state before its balls */
#define TIA_STEPS_BALL 49              /* bytes of a ball in a saved state */

/* A scene at a step. All members are private. */
struct tia_steps {
    const struct tia_scene *scene;
    void *balls, *blocks;
    uint32_t step, block_count;
};

/* An input: a change of a ball's velocity at the beginning of a step. */
struct tia_push {
    uint32_t ball;            /* index in scene->falling->balls */
    struct tia_vec3 velocity; /* is added; units of length per second, each within +-1024 */
};

/* Returns the number of bytes of memory that tia_steps_init needs for a scene that tia_scene_check accepts; SIZE_MAX
 * when that number does not fit. The memory must be aligned for uint64_t, and may be NULL if the result is 0. */
size_t tia_steps_size(const struct tia_scene *scene);

/* Sets *steps to step 0, the scene's beginning. `scene` and `memory` must stay as long as *steps is used. Several
 * *steps may share a scene, but not memory. TIA_ERR_MEMORY when `size` is too small. */
int tia_steps_init(struct tia_steps *steps, void *memory, size_t size, const struct tia_scene *scene);

/* Does one step of 1/256 s. First the pushes are added, in their order; each component of a velocity saturates at
 * +-2^15. A push of a ball that is gone has no effect, and from scene->falling->end on none moves anything. On an
 * error the state does not change: TIA_ERR_ARGUMENT when a pointer is NULL or a ball does not exist, TIA_ERR_RANGE when
 * a velocity is out of its range or there have been TIA_STEPS_MAX steps. `pushes` may be NULL when `count` is 0. */
int tia_scene_step(struct tia_steps *steps, const struct tia_push *pushes, uint32_t count);

/* Returns the hash of the state; 0 when `steps` is NULL. */
uint64_t tia_steps_hash(const struct tia_steps *steps);

/* Returns the number of bytes of a saved state: TIA_STEPS_HEAD + balls * TIA_STEPS_BALL; SIZE_MAX when `steps` is NULL.
 */
size_t tia_steps_saved_size(const struct tia_steps *steps);

/* Writes the state. TIA_ERR_MEMORY when `size` is less than tia_steps_saved_size. */
int tia_steps_save(const struct tia_steps *steps, uint8_t *bytes, size_t size);

/* Sets the state to a saved one of the same scene, which may come from another program or processor. TIA_ERR_RANGE, and
 * nothing changes, when `size` is not tia_steps_saved_size, or the bytes are no state of a scene with as many balls:
 * centres within +-2^17 and, unless a ball is gone, velocities within +-2^15. */
int tia_steps_restore(struct tia_steps *steps, const uint8_t *bytes, size_t size);

/* Sets *out to the scene at this step, as tia_scene_at does for a time: the same memory, and the same errors; `out` may
 * not be the scene of *steps. */
int tia_steps_scene(const struct tia_steps *steps, struct tia_scene *out, void *memory, size_t size,
                    const struct tia_job *job);

#ifdef __cplusplus
}
#endif

#endif
