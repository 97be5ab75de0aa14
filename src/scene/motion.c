#include <tia/motion.h>

#include "math/align.h"
#include "math/integer.h"
#include "scene/asker.h"

/* a / b as Q2.62, rounded down; 0 <= a <= b < 2^31, b not 0. */
static int64_t fraction(int64_t a, int64_t b)
{
    uint64_t n = (uint64_t)a << 31, d = (uint64_t)b;
    return (int64_t)((n / d) << 31 | (n % d << 31) / d);
}

/* The weights of the ends' distance and of the two tangents, Q2.62: the cubic Hermite polynomials 3u^2 - 2u^3,
 * u - 2u^2 + u^3 and u^3 - u^2, evaluated so that no intermediate exceeds 1. */
struct weights {
    int64_t end, first_slope, last_slope;
};

static struct weights hermite(int64_t u)
{
    int64_t u2 = tia_scaled_product(u, u, 62), u3 = tia_scaled_product(u2, u, 62);
    return (struct weights){u2 + 2 * (u2 - u3), (u - u2) - (u2 - u3), u3 - u2};
}

/* One coordinate of the four keyframes around the time: the segment's two ends, and the ones before and after. A
 * tangent is the difference of an end's neighbours, multiplied by the segment's share of the time between them,
 * first_share or last_share; 0 at the ends of the track. */
struct segment {
    tia_q16 before, first, last, after;
    int64_t first_share, last_share;
};

static tia_q16 interpolate(const struct segment *s, const struct weights *w)
{
    /* Tangents and sum have 32 fractional bits. */
    int64_t first = tia_scaled_product((int64_t)s->last - s->before, s->first_share, 46);
    int64_t last = tia_scaled_product((int64_t)s->after - s->first, s->last_share, 46);
    int64_t sum = tia_scaled_product((int64_t)s->last - s->first, w->end, 46) +
                  tia_scaled_product(first, w->first_slope, 62) + tia_scaled_product(last, w->last_slope, 62);
    int64_t value = s->first + tia_round_shift(sum, 16);
    /* Between keyframes a smooth curve can overshoot Q16.16. */
    return (tia_q16)(value < INT32_MIN ? INT32_MIN : value > INT32_MAX ? INT32_MAX : value);
}

static struct tia_vec3 between(const struct tia_track *track, uint32_t i, tia_q16 time)
{
    const struct tia_keyframe *first = &track->keys[i], *last = first + 1;
    const struct tia_keyframe *before = i > 0 ? first - 1 : first;
    const struct tia_keyframe *after = i + 2 < track->key_count ? last + 1 : last;
    int64_t length = (int64_t)last->time - first->time, u = fraction((int64_t)time - first->time, length);
    struct weights w = {u, 0, 0};
    struct segment s = {0};

    if (track->smooth) {
        w = hermite(u);
        s.first_share = before < first ? fraction(length, (int64_t)last->time - before->time) : 0;
        s.last_share = after > last ? fraction(length, (int64_t)after->time - first->time) : 0;
    }
    struct tia_vec3 value;
#define INTERPOLATE(c)                                                                                                 \
    s.before = before->value.c, s.first = first->value.c, s.last = last->value.c, s.after = after->value.c;            \
    value.c = interpolate(&s, &w)
    INTERPOLATE(x);
    INTERPOLATE(y);
    INTERPOLATE(z);
#undef INTERPOLATE
    return value;
}

static struct tia_vec3 value_at(const struct tia_track *track, tia_q16 time)
{
    uint32_t next = 0;

    while (next < track->key_count && track->keys[next].time <= time)
        next++;
    if (next == 0)
        return track->keys[0].value;
    return next == track->key_count ? track->keys[next - 1].value : between(track, next - 1, time);
}

/* An interpolated direction can pass through 0, which has no direction: the light keeps its own. */
static void set_direction(struct tia_dir3 *direction, struct tia_vec3 to)
{
    if (to.x | to.y | to.z)
        *direction = tia_normalise(to.x, to.y, to.z);
}

/* Bytes for a copy of `count` elements if any track has a target in first..last, otherwise 0. */
static uint64_t copy_size(const struct tia_scene *scene, enum tia_target first, enum tia_target last, uint32_t count,
                          size_t size)
{
    for (uint32_t i = 0; i < scene->track_count; i++)
        if (scene->tracks[i].target >= first && scene->tracks[i].target <= last)
            return ALIGN(count * (uint64_t)size);
    return 0;
}

static uint64_t lights_size(const struct tia_scene *scene)
{
    return copy_size(scene, TIA_MOVES_LIGHT, TIA_ROTATES_LIGHT, scene->light_count, sizeof(struct tia_light));
}

static uint64_t transforms_size(const struct tia_scene *scene)
{
    return copy_size(scene, TIA_MOVES_TRANSFORM, TIA_SCALES_TRANSFORM, scene->transform_count,
                     sizeof(struct tia_transform));
}

size_t tia_scene_at_size(const struct tia_scene *scene)
{
    uint64_t size = lights_size(scene) + transforms_size(scene);
    return size > SIZE_MAX / 2 ? SIZE_MAX : (size_t)size;
}

static void apply(const struct tia_track *track, tia_q16 time, struct tia_camera *camera, struct tia_light *lights,
                  struct tia_transform *transforms)
{
    struct tia_vec3 value = value_at(track, time);

    switch (track->target) {
    case TIA_MOVES_EYE:
        camera->eye = value;
        break;
    case TIA_MOVES_REFERENCE:
        camera->reference = value;
        break;
    case TIA_MOVES_LIGHT:
        lights[track->index].centre = value;
        break;
    case TIA_ROTATES_LIGHT:
        set_direction(&lights[track->index].direction, value);
        break;
    case TIA_MOVES_TRANSFORM:
        transforms[track->index].position = value;
        break;
    case TIA_ROTATES_TRANSFORM:
        transforms[track->index].rotation = value;
        break;
    case TIA_SCALES_TRANSFORM:
        transforms[track->index].scale = value;
        break;
    }
}

int tia_scene_at(struct tia_scene *out, void *memory, size_t size, const struct tia_scene *scene, tia_q16 time)
{
    return tia_scene_at_until(out, memory, size, scene, time, NULL, NULL);
}

int tia_scene_at_until(struct tia_scene *out, void *memory, size_t size, const struct tia_scene *scene, tia_q16 time,
                       bool (*stop)(void *ctx), void *ctx)
{
    const struct tia_scene still = *scene;
    struct asker asker = {stop, ctx, 0, false};
    size_t needed = tia_scene_at_size(scene), for_lights = (size_t)lights_size(scene);

    if (needed == SIZE_MAX || size < needed)
        return TIA_ERR_MEMORY;
    struct tia_light *lights = for_lights ? memory : NULL;
    struct tia_transform *transforms = needed > for_lights ? (void *)((char *)memory + for_lights) : NULL;
    *out = still;
    for (uint32_t i = 0; lights && i < still.light_count && !asker_stops(&asker, 1); i++)
        lights[i] = still.lights[i];
    for (uint32_t i = 0; transforms && i < still.transform_count && !asker_stops(&asker, 1); i++)
        transforms[i] = still.transforms[i];
    if (lights)
        out->lights = lights;
    if (transforms)
        out->transforms = transforms;
    out->tracks = NULL;
    out->track_count = 0;
    out->bvh = NULL;
    for (uint32_t i = 0; i < still.track_count && !asker_stops(&asker, still.tracks[i].key_count); i++)
        apply(&still.tracks[i], time, &out->camera, lights, transforms);
    return asker.stopped ? TIA_STOPPED : TIA_OK;
}

tia_q16 tia_scene_duration(const struct tia_scene *scene)
{
    tia_q16 longest = 0;

    for (uint32_t i = 0; i < scene->track_count; i++) {
        tia_q16 end = scene->tracks[i].keys[scene->tracks[i].key_count - 1].time;
        longest = end > longest ? end : longest;
    }
    return longest;
}
