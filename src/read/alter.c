/* alter.c - a camera with an eye, a target or a projection other than the file's. */
#include "alter.h"

#include <tia/fit.h>

#include "math/integer.h"

/* Returns a - b, saturated. */
static int64_t less(int64_t a, int64_t b)
{
    if (b < 0 ? a > INT64_MAX + b : a < INT64_MIN + b)
        return b < 0 ? INT64_MAX : INT64_MIN;
    return a - b;
}

/* Returns a length of Q31.32 in the scene's unit, with 16 fractional bits: rounded to nearest, ties away from 0, and
 * saturated. */
static int64_t stored_length(int64_t a, int bits)
{
    uint64_t size = a < 0 ? 0 - (uint64_t)a : (uint64_t)a;
    int shift = 16 - bits;

    if (shift > 0)
        size = shift > 63 ? 0 : (size >> shift) + (size >> (shift - 1) & 1);
    else if (size)
        size = tia_clz64(size) > (unsigned)-shift ? size << -shift : (uint64_t)INT64_MAX;
    return a < 0 ? -(int64_t)(size < INT64_MAX ? size : INT64_MAX) : (int64_t)(size < INT64_MAX ? size : INT64_MAX);
}

/* Returns a length; *longest is at least its size. */
static tia_q16 length_of(int64_t a, const struct tia_placement *placement, int64_t *longest)
{
    int64_t length = stored_length(a, placement->bits), size = length < 0 ? -length : length;

    *longest = size > *longest ? size : *longest;
    return tia_saturate_s32(length);
}

static struct tia_vec3 position_of(const int64_t p[3], const struct tia_placement *placement, int64_t *longest)
{
    tia_q16 at[3];

    for (int i = 0; i < 3; i++)
        at[i] = length_of(less(p[i], placement->origin[i]), placement, longest);
    return (struct tia_vec3){at[0], at[1], at[2]};
}

static bool has_up(const struct tia_camera *camera)
{
    return camera->up.x || camera->up.y || camera->up.z;
}

static void alter_target(struct tia_camera *camera, const struct tia_camera_change *change,
                         const struct tia_placement *placement, int64_t *longest)
{
    if (change->has_eye)
        camera->eye = position_of(change->eye, placement, longest);
    if (change->has_reference)
        camera->reference = position_of(change->reference, placement, longest);
    else if (change->has_up && !has_up(camera))
        camera->reference =
            (struct tia_vec3){camera->eye.x, camera->eye.y, tia_saturate_s32((int64_t)camera->eye.z - TIA_Q16_ONE)};
    if (change->has_up)
        camera->up = tia_vector_of(change->up);
    else if (change->has_reference && !has_up(camera))
        camera->up.y = TIA_Q16_ONE;
}

static void alter(struct tia_camera *camera, const struct tia_camera_change *change,
                  const struct tia_placement *placement, int64_t *longest)
{
    alter_target(camera, change, placement, longest);
    if ((!change->fov && !change->height) || camera->line)
        return;
    camera->projection = change->height ? TIA_ORTHOGRAPHIC : TIA_PERSPECTIVE;
    camera->fov = change->fov;
    tia_q16 half = length_of(change->height / 2, placement, longest);
    camera->window = (struct tia_window){.bottom = tia_saturate_s32(-(int64_t)half), .top = half};
}

void tia_camera_alter(struct tia_camera *camera, const struct tia_camera_change *change,
                      const struct tia_placement *placement)
{
    int64_t longest = 0;

    if (camera && change && placement)
        alter(camera, change, placement, &longest);
}

void tia_alter_measured(const struct tia_reader *reader, struct tia_camera *camera, struct tia_lengths *lengths)
{
    const struct tia_placement placement = {.bits = lengths->scale_bits};
    int64_t longest = 0;

    if (!reader->camera)
        return;
    alter(camera, reader->camera, &placement, &longest);
    if (!lengths->filling && longest > lengths->longest)
        lengths->longest = longest;
}
