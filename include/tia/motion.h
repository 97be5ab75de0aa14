/* motion.h - a scene at a time: keyframes for the camera, lights and transforms. */
#ifndef TIA_MOTION_H
#define TIA_MOTION_H

#include <tia/scene.h>

enum tia_target {
    TIA_MOVES_EYE,       /* the camera's eye */
    TIA_MOVES_REFERENCE, /* the point that it looks at */
    TIA_MOVES_LIGHT,     /* a light's centre */
    TIA_TURNS_LIGHT,     /* its direction, normalised after */
    TIA_MOVES_TRANSFORM, /* a transform's position */
    TIA_ROTATES_TRANSFORM,
    TIA_SCALES_TRANSFORM
};

struct tia_keyframe {
    tia_q16 time; /* seconds, 0 or more, rising within a track */
    struct tia_vec3 value;
};

/* Before its first keyframe a track holds the first value, after its last the last. Between two it runs
 * along the line; when smooth, along the cubic Hermite curve through all of them whose tangent at an inner
 * keyframe is the slope between its neighbours (Catmull-Rom), and 0 at the first and last.
 *
 * Keyframes keep the ranges of what they set: they bring lights, reference points and transforms no
 * farther than 32768 from any place of the eye, and a direction is not 0; but where a transform takes its
 * shapes, and a smooth curve what it moves, tia_scene_check tells only of the scene at that time. */
struct tia_track {
    enum tia_target target;
    uint32_t index; /* of the light or transform */
    bool smooth;
    const struct tia_keyframe *keys;
    uint32_t key_count; /* 1 or more */
};

/* Bytes of memory, aligned for uint64_t, that tia_scene_at takes. */
size_t tia_scene_at_size(const struct tia_scene *scene);

/* *out becomes the scene at `time` (seconds), sharing all arrays but those of what moves, which are in
 * `memory`; without tracks and without a bvh, which no longer fits. TIA_ERR_MEMORY when `size` is too
 * small. `out` may be scene only if nothing else uses it. */
int tia_scene_at(struct tia_scene *out, void *memory, size_t size, const struct tia_scene *scene, tia_q16 time);

/* The time of the last keyframe, seconds; 0 when nothing moves. */
tia_q16 tia_scene_duration(const struct tia_scene *scene);

#endif
