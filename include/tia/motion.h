/* motion.h - animation: keyframes for the camera, lights and transforms. */
#ifndef TIA_MOTION_H
#define TIA_MOTION_H

#include <tia/scene.h>

enum tia_target {
    TIA_MOVES_EYE,       /* the camera's eye */
    TIA_MOVES_REFERENCE, /* the point that the camera looks at */
    TIA_MOVES_LIGHT,     /* a light's centre */
    TIA_ROTATES_LIGHT,   /* a light's direction, normalised after interpolation */
    TIA_MOVES_TRANSFORM, /* a transform's position */
    TIA_ROTATES_TRANSFORM,
    TIA_SCALES_TRANSFORM
};

struct tia_keyframe {
    tia_q16 time; /* seconds, 0 or more, strictly increasing within a track */
    struct tia_vec3 value;
};

/* Before its first keyframe a track holds the first value, after its last the last. In between it is linear;
 * a smooth track is the cubic Hermite curve through the keyframes whose tangent at an inner keyframe is the
 * slope between its neighbours (Catmull-Rom), and 0 at the first and last.
 *
 * Every keyframe must keep the range of the field that it sets: lights, reference points and transforms stay
 * within 32768 of every eye position, and directions are not 0. tia_scene_check cannot see in advance where a
 * transform carries its shapes, or how far a smooth curve overshoots: check the scene of each time as well. */
struct tia_track {
    enum tia_target target;
    uint32_t index; /* of the light or transform; unused for the camera */
    bool smooth;
    const struct tia_keyframe *keys;
    uint32_t key_count; /* 1 or more */
};

/* Bytes of memory that tia_scene_at needs. The memory must be aligned for uint64_t. */
size_t tia_scene_at_size(const struct tia_scene *scene);

/* Sets *out to the scene at `time` (seconds). Arrays with moving elements are copied to `memory`, all others
 * are shared with `scene`. *out has no tracks and no bvh, since objects moved: build a new one.
 * TIA_ERR_MEMORY when `size` is too small. `out` may equal `scene`, which is then lost. */
int tia_scene_at(struct tia_scene *out, void *memory, size_t size, const struct tia_scene *scene, tia_q16 time);

/* The same, asking `stop` now and then, which may be NULL. Once it says true, returns TIA_STOPPED, and *out may be
 * drawn no more. */
int tia_scene_at_until(struct tia_scene *out, void *memory, size_t size, const struct tia_scene *scene, tia_q16 time,
                       bool (*stop)(void *ctx), void *ctx);

/* The time of the last keyframe, seconds; 0 when nothing moves. */
tia_q16 tia_scene_duration(const struct tia_scene *scene);

#endif
