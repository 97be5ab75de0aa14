/* motion.h - animation: keyframes, visibility over time, and falling balls. */
#ifndef TIA_MOTION_H
#define TIA_MOTION_H

#include <tia/job.h>
#include <tia/scene.h>

#ifdef __cplusplus
extern "C" {
#endif

enum tia_target {
    TIA_MOVES_EYE,       /* the camera's eye */
    TIA_MOVES_REFERENCE, /* the point that the camera looks at */
    TIA_MOVES_LIGHT,     /* a light's centre */
    TIA_ROTATES_LIGHT,   /* a light's direction, normalised after interpolation */
    TIA_MOVES_TRANSFORM, /* a transform's position */
    TIA_ROTATES_TRANSFORM,
    TIA_SCALES_TRANSFORM,
    TIA_SHOWS_SHAPE, /* x is 1: shown, 0: hidden; takes effect at its keyframe, without interpolation */
    TIA_SHOWS_LIGHT,
    TIA_SETS_COLOUR, /* a material's colour; here and below, x, y, z are red, green, blue: Q2.30, 0..1 */
    TIA_SETS_TRANSMISSION,
    TIA_SETS_EMISSION, /* a material's emission, without emission_bits */
    TIA_SETS_SPECULAR,
    TIA_SETS_MIRROR,
    TIA_SETS_REFRACTION,
    TIA_SETS_FACING,
    TIA_TARGETS
};

struct tia_keyframe {
    tia_q16 time; /* seconds, 0 or more, strictly increasing within a track */
    struct tia_vec3 value;
};

/* Before its first keyframe a track has the first value, after its last keyframe the last value. In between it is
 * linear; a smooth track is the cubic Hermite curve through the keyframes whose tangent at an inner keyframe is the
 * slope between its neighbours (Catmull-Rom), and 0 at the first and last.
 *
 * Every keyframe's value must be in the range of the field that it sets: lights, reference points and transforms stay
 * within 32768 of every eye position, and directions are not 0. tia_scene_check tests neither where a transform moves
 * its shapes nor how far a smooth curve overshoots: check the scene of each time as well. Colours that overshoot are
 * clamped.
 *
 * A hidden shape keeps its index, but becomes an instance of the scene's last mesh, which must have no faces. Tracks of
 * colours that the span renderer does not draw need that mesh as well, so that the same renderer draws the scene at all
 * times. A hidden light has no emission and no size. */
struct tia_track {
    enum tia_target target;
    uint32_t index; /* index of the light, transform, shape or material; unused for the camera */
    bool smooth;
    const struct tia_keyframe *keys;
    uint32_t key_count; /* 1 or more */
};

/* A ball that falls. Between contacts its centre moves along a parabola. Balls bounce off each other and off planes and
 * boxes whose transform has no track; they pass through everything else. They do not spin, and there is no friction.
 * Hidden shapes (TIA_SHOWS_SHAPE) take no part: a ball waits until it is shown, and is gone once it is hidden. It is
 * gone, too, once a coordinate of its centre reaches a magnitude of 2^14 or its speed exceeds 2^15.
 *
 * At a contact, the speed at which the two part is the speed at which they approached, times the restitution; between
 * two balls, the smaller of their restitutions. A ball that approaches more slowly than if it had fallen for 2/256 s
 * comes to rest, and can then carry others. Times of contact are accurate to 2^-20 s, if balls move less than 16 times
 * their diameter in 1/256 s. */
struct tia_fall {
    uint32_t shape;           /* index of a sphere with a transform of its own, scaled uniformly, that no track moves */
    struct tia_vec3 velocity; /* velocity at the beginning, units of length per second, each within +-1024 */
    tia_q16 restitution;      /* 0..1 */
    tia_q16 mass;             /* 2^-10..1024 */
};

struct tia_falling {
    const struct tia_fall *balls;
    uint32_t count;          /* at most TIA_FALLS_MAX */
    struct tia_vec3 gravity; /* units of length per second^2, each within +-1024 */
    tia_q16 end;             /* seconds, at most TIA_FALL_END_MAX: from then on all balls stay where they are */
};

/* Returns the number of bytes of memory that tia_scene_at needs for a scene that tia_scene_check accepts; SIZE_MAX when
 * that number does not fit. The memory must be aligned for uint64_t, and may be NULL if the result is 0. */
size_t tia_scene_at_size(const struct tia_scene *scene);

/* Sets *out to the scene at `time` (seconds). Arrays with moving elements are copied to `memory`, all others are shared
 * with `scene`. *out has no tracks and no falling balls. out->bvh is NULL, since objects may have moved: build a new
 * hierarchy, or see tia_bvh_move. out->fine is NULL if anything in the scene moves. *out depends on nothing but the
 * scene and the time. So the balls' paths are computed from the beginning each time, in steps of 1/256 s, each of which
 * takes time proportional to the number of balls times that of balls, planes and boxes. TIA_ERR_MEMORY when `size` is
 * too small. `out` may equal `scene`, which is then overwritten. Runs on one thread. After TIA_STOPPED *out is
 * undefined and must not be drawn. */
int tia_scene_at(struct tia_scene *out, void *memory, size_t size, const struct tia_scene *scene, tia_q16 time,
                 const struct tia_job *job);

/* True if the scene may differ at different times. */
bool tia_scene_moves(const struct tia_scene *scene);

/* Returns the time of the last keyframe or of the end of falling, whichever is later, in seconds; 0 when nothing moves.
 */
tia_q16 tia_scene_duration(const struct tia_scene *scene);

#ifdef __cplusplus
}
#endif

#endif
