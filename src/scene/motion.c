#include <tia/motion.h>

#include "math/align.h"
#include "math/integer.h"
#include "scene/cancel.h"
#include "scene/fall/fall.h"
#include "scene/motion.h"
#include "scene/track.h"

/* Sets a light's direction. A value of 0, which an interpolation can pass through, changes nothing. */
static void set_direction(struct tia_dir3 *direction, struct tia_vec3 to)
{
    if (to.x | to.y | to.z)
        *direction = tia_normalise(to.x, to.y, to.z);
}

/* Hides a light. The kind stays, so that the scene needs the same memory at all times. */
static void hide_light(struct tia_light *light)
{
    const struct tia_vec3 none = {0, 0, 0};

    light->emission = (struct tia_rgb){0, 0, 0};
    light->radius = 0;
    light->side[0] = light->side[1] = none;
}

static tia_q30 channel(int32_t value)
{
    return value < 0 ? 0 : value > TIA_Q30_ONE ? TIA_Q30_ONE : value;
}

static void set_colour(struct tia_material *material, enum tia_target target, struct tia_vec3 value)
{
    struct tia_rgb *const colours[] = {&material->colour,   &material->transmission, &material->emission,
                                       &material->specular, &material->mirror,       &material->refraction,
                                       &material->facing};

    *colours[target - TIA_SETS_COLOUR] = (struct tia_rgb){channel(value.x), channel(value.y), channel(value.z)};
}

/* Copies of the camera and of the arrays that have moving elements, in their order in memory. */
struct moving {
    struct tia_camera camera;
    struct tia_light *lights;
    struct tia_transform *transforms;
    struct tia_shape *shapes;
    struct tia_material *materials;
    void *falling;
};

static bool has_track(const struct tia_scene *scene, enum tia_target first, enum tia_target last)
{
    for (uint32_t i = 0; i < scene->track_count; i++)
        if (scene->tracks[i].target >= first && scene->tracks[i].target <= last)
            return true;
    return false;
}

/* Returns the bytes for a copy of `count` elements; 0 if none of them moves. */
static uint64_t copy_size(bool moves, uint32_t count, size_t size)
{
    return moves ? ALIGN(count * (uint64_t)size) : 0;
}

enum { LIGHTS, TRANSFORMS, SHAPES, MATERIALS, FALLING, PARTS };

static uint64_t sizes_of(const struct tia_scene *scene, uint64_t sizes[PARTS])
{
    bool falls = scene->falling, lights = has_track(scene, TIA_MOVES_LIGHT, TIA_ROTATES_LIGHT);

    sizes[LIGHTS] = copy_size(lights || has_track(scene, TIA_SHOWS_LIGHT, TIA_SHOWS_LIGHT), scene->light_count,
                              sizeof(struct tia_light));
    sizes[TRANSFORMS] = copy_size(falls || has_track(scene, TIA_MOVES_TRANSFORM, TIA_SCALES_TRANSFORM),
                                  scene->transform_count, sizeof(struct tia_transform));
    sizes[SHAPES] = copy_size(falls || has_track(scene, TIA_SHOWS_SHAPE, TIA_SHOWS_SHAPE), scene->shape_count,
                              sizeof(struct tia_shape));
    sizes[MATERIALS] = copy_size(has_track(scene, TIA_SETS_COLOUR, TIA_SETS_FACING), scene->material_count,
                                 sizeof(struct tia_material));
    sizes[FALLING] = falls ? ALIGN(tia_fall_size(scene)) : 0;
    return sizes[LIGHTS] + sizes[TRANSFORMS] + sizes[SHAPES] + sizes[MATERIALS] + sizes[FALLING];
}

size_t tia_scene_at_size(const struct tia_scene *scene)
{
    uint64_t sizes[PARTS], size = scene ? sizes_of(scene, sizes) : SIZE_MAX;
    return size > SIZE_MAX / 2 ? SIZE_MAX : (size_t)size;
}

static void apply(const struct tia_scene *scene, const struct tia_track *track, tia_q16 time, struct moving *to)
{
    struct tia_vec3 value = tia_track_value(track, time);

    switch (track->target) {
    case TIA_MOVES_EYE:
        to->camera.eye = value;
        break;
    case TIA_MOVES_REFERENCE:
        to->camera.reference = value;
        break;
    case TIA_MOVES_LIGHT:
        to->lights[track->index].centre = value;
        break;
    case TIA_ROTATES_LIGHT:
        set_direction(&to->lights[track->index].direction, value);
        break;
    case TIA_MOVES_TRANSFORM:
        to->transforms[track->index].position = value;
        break;
    case TIA_ROTATES_TRANSFORM:
        to->transforms[track->index].rotation = value;
        break;
    case TIA_SCALES_TRANSFORM:
        to->transforms[track->index].scale = value;
        break;
    case TIA_SHOWS_SHAPE:
        if (!tia_track_shows(track, time))
            tia_fall_hide(scene, &to->shapes[track->index]);
        break;
    case TIA_SHOWS_LIGHT:
        if (!tia_track_shows(track, time))
            hide_light(&to->lights[track->index]);
        break;
    case TIA_SETS_COLOUR:
    case TIA_SETS_TRANSMISSION:
    case TIA_SETS_EMISSION:
    case TIA_SETS_SPECULAR:
    case TIA_SETS_MIRROR:
    case TIA_SETS_REFRACTION:
    case TIA_SETS_FACING:
        set_colour(&to->materials[track->index], track->target, value);
        break;
    case TIA_TARGETS:
        break;
    }
}

/* Allocates memory for a copy in the block. Returns NULL for the size 0: the array is not copied. */
static void *part(char **memory, uint64_t size)
{
    char *here = *memory;

    if (!size)
        return NULL;
    *memory += (size_t)size;
    return here;
}

#define COPY(array, count)                                                                                             \
    for (uint32_t i = 0; to->array && i < scene->count && !cancelled(cancel, 1); i++)                                  \
    to->array[i] = scene->array[i]

static void copy(struct moving *to, char *memory, const struct tia_scene *scene, struct cancel *cancel)
{
    uint64_t sizes[PARTS];

    (void)sizes_of(scene, sizes);
    to->lights = part(&memory, sizes[LIGHTS]);
    to->transforms = part(&memory, sizes[TRANSFORMS]);
    to->shapes = part(&memory, sizes[SHAPES]);
    to->materials = part(&memory, sizes[MATERIALS]);
    to->falling = part(&memory, sizes[FALLING]);
    to->camera = scene->camera;
    COPY(lights, light_count);
    COPY(transforms, transform_count);
    COPY(shapes, shape_count);
    COPY(materials, material_count);
}

static void put(struct tia_scene *out, const struct moving *from, bool moves)
{
    out->camera = from->camera;
    if (from->lights)
        out->lights = from->lights;
    if (from->transforms)
        out->transforms = from->transforms;
    if (from->shapes)
        out->shapes = from->shapes;
    if (from->materials)
        out->materials = from->materials;
    out->fine = moves ? NULL : out->fine;
    out->tracks = NULL;
    out->track_count = 0;
    out->falling = NULL;
    out->bvh = NULL;
}

int tia_motion_at(struct tia_scene *out, void *memory, size_t size, const struct tia_scene *scene, tia_q16 time,
                  const struct falling *at, const struct tia_job *job)
{
    if (!out || !scene)
        return TIA_ERR_ARGUMENT;
    const struct tia_scene base = *scene;
    struct cancel cancel = cancel_for(job);
    size_t needed = tia_scene_at_size(scene);
    struct moving to;

    if (needed && !memory_is_usable(memory))
        return TIA_ERR_ARGUMENT;
    if (needed == SIZE_MAX || size < needed)
        return TIA_ERR_MEMORY;
    copy(&to, memory, &base, &cancel);
    for (uint32_t i = 0; i < base.track_count && !cancelled(&cancel, base.tracks[i].key_count); i++)
        apply(&base, &base.tracks[i], time, &to);
    if (base.falling && at)
        tia_fall_put(at, &base, to.transforms, to.shapes);
    else if (base.falling && !cancel.stopped)
        tia_fall_at(&base, to.falling, time, to.transforms, to.shapes, &cancel);
    *out = base;
    put(out, &to, tia_scene_moves(&base));
    return cancel.stopped ? TIA_STOPPED : TIA_OK;
}

int tia_scene_at(struct tia_scene *out, void *memory, size_t size, const struct tia_scene *scene, tia_q16 time,
                 const struct tia_job *job)
{
    return tia_motion_at(out, memory, size, scene, time, NULL, job);
}

bool tia_scene_moves(const struct tia_scene *scene)
{
    return scene && (scene->track_count > 0 || scene->falling);
}

tia_q16 tia_scene_duration(const struct tia_scene *scene)
{
    tia_q16 longest = scene && scene->falling ? scene->falling->end : 0;

    for (uint32_t i = 0; scene && i < scene->track_count; i++) {
        tia_q16 end = scene->tracks[i].keys[scene->tracks[i].key_count - 1].time;
        longest = end > longest ? end : longest;
    }
    return longest;
}
