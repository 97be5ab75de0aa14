#include "fall.h"

#include <tia/debug.h>

#include "contact.h"
#include "math/align.h"
#include "math/rotation.h"
#include "math/wide.h"
#include "scene/cancel.h"
#include "scene/object_bounds.h"
#include "tick.h"

#define MOST_Q32 (INT64_C(1) << 50) /* a length beyond any accepted scene; times 256, it fits in 64 bits */

/* Converts Q31.32, such as a product of two Q16.16, to Q23.40, clamped. */
static int64_t fine(int64_t q32)
{
    return (q32 < -MOST_Q32 ? -MOST_Q32 : q32 > MOST_Q32 ? MOST_Q32 : q32) * 256;
}

static int64_t fine_q16(int64_t q16)
{
    return fine((q16 < -(MOST_Q32 >> 16) ? -(MOST_Q32 >> 16) : q16 > MOST_Q32 >> 16 ? MOST_Q32 >> 16 : q16) * 65536);
}

void tia_fall_hide(const struct tia_scene *scene, struct tia_shape *shape)
{
    *shape = (struct tia_shape){.kind = TIA_MESH, .material = shape->material, .mesh = scene->mesh_count - 1};
}

static const struct tia_track *shown(const struct tia_scene *scene, uint32_t shape)
{
    for (uint32_t i = 0; i < scene->track_count; i++)
        if (scene->tracks[i].target == TIA_SHOWS_SHAPE && scene->tracks[i].index == shape)
            return &scene->tracks[i];
    return NULL;
}

static const struct tia_transform *placed(const struct tia_scene *scene, const struct tia_shape *shape)
{
    return shape->transform ? &scene->transforms[shape->transform - 1] : NULL;
}

static bool moves(const struct tia_scene *scene, const struct tia_shape *shape)
{
    for (uint32_t i = 0; shape->transform && i < scene->track_count; i++) {
        enum tia_target target = scene->tracks[i].target;
        if (target >= TIA_MOVES_TRANSFORM && target <= TIA_SCALES_TRANSFORM &&
            scene->tracks[i].index == shape->transform - 1)
            return true;
    }
    return false;
}

bool tia_scene_bounces_off(const struct tia_scene *scene, uint32_t shape)
{
    if (!scene || shape >= scene->shape_count)
        return false;
    const struct tia_shape *block = &scene->shapes[shape];

    return (block->kind == TIA_PLANE || block->kind == TIA_BOX) && !moves(scene, block);
}

uint64_t tia_fall_size(const struct tia_scene *scene)
{
    uint64_t blocks = 0;

    for (uint32_t i = 0; i < scene->shape_count; i++)
        blocks += tia_scene_bounces_off(scene, i);
    return ALIGN(scene->falling->count * (uint64_t)sizeof(struct fall_ball)) + blocks * sizeof(struct fall_block);
}

static void set_ball(const struct tia_scene *scene, const struct tia_fall *fall, struct fall_ball *ball)
{
    const struct tia_shape *shape = &scene->shapes[fall->shape];
    const struct tia_transform *transform = placed(scene, shape);
    const tia_q16 velocity[3] = {fall->velocity.x, fall->velocity.y, fall->velocity.z};
    struct frame frame;

    tia_frame_prepare(&frame, transform);
    *ball = (struct fall_ball){.shown = shown(scene, fall->shape)};
    ball->radius = fine(shape->sphere.radius * (int64_t)(transform ? transform->scale.x : TIA_Q16_ONE));
    for (int i = 0; i < 3; i++) {
        ball->start[i] = ball->place[i] = fine(tia_frame_place(&frame, i, shape->sphere.centre));
        ball->velocity[i] = velocity[i] * INT64_C(65536);
    }
}

static void set_plane(const struct tia_plane *plane, struct fall_block *block)
{
    const int64_t normal[3] = {plane->normal.x, plane->normal.y, plane->normal.z};

    block->place[0] = fine_q16(plane->point.x);
    block->place[1] = fine_q16(plane->point.y);
    block->place[2] = fine_q16(plane->point.z);
    (void)wide_normalise(normal, block->axes[0]);
}

static void set_box(const struct tia_scene *scene, uint32_t index, struct fall_block *block)
{
    const struct tia_shape *shape = &scene->shapes[index];
    const struct tia_transform *placed_by = placed(scene, shape);
    struct tia_transform t = {.scale = {TIA_Q16_ONE, TIA_Q16_ONE, TIA_Q16_ONE}};
    struct bounds_wide bounds;

    if (placed_by)
        t = *placed_by;
    const tia_q16 scale[3] = {t.scale.x, t.scale.y, t.scale.z}, place[3] = {t.position.x, t.position.y, t.position.z};
    const tia_q16 min[3] = {shape->box.min.x, shape->box.min.y, shape->box.min.z};
    const tia_q16 max[3] = {shape->box.max.x, shape->box.max.y, shape->box.max.z};
    block->is_box = true;
    tia_rotation_axes(t.rotation, block->axes);
    (void)tia_bounds_in_world(scene, scene->sphere_count + index, NULL, &bounds);
    for (int i = 0; i < 3; i++) {
        block->place[i] = fine_q16(place[i]);
        block->min[i] = fine(min[i] * (int64_t)scale[i]);
        block->max[i] = fine(max[i] * (int64_t)scale[i]);
        block->low[i] = fine_q16(bounds.min[i]);
        block->high[i] = fine_q16(bounds.max[i]);
    }
}

static void set_blocks(struct falling *f, const struct tia_scene *scene)
{
    for (uint32_t i = 0; i < scene->shape_count && !cancelled(f->cancel, 1 + scene->track_count); i++) {
        const struct tia_shape *shape = &scene->shapes[i];
        if (!tia_scene_bounces_off(scene, i))
            continue;
        struct fall_block *block = &f->blocks[f->block_count++];
        *block = (struct fall_block){.shown = shown(scene, i)};
        if (shape->kind == TIA_PLANE)
            set_plane(&shape->plane, block);
        else
            set_box(scene, i, block);
    }
}

/* Adds the ball's displacement since the start, rounded, to a position. */
static void put(const struct fall_ball *ball, struct tia_vec3 *position)
{
    tia_q16 *const to[3] = {&position->x, &position->y, &position->z};

    for (int i = 0; i < 3; i++) {
        int64_t there = *to[i] + tia_round_shift(ball->place[i] - ball->start[i], 24);
        *to[i] = tia_saturate_s32(there);
    }
}

void tia_fall_begin(struct falling *f, const struct tia_scene *scene, void *memory)
{
    const struct tia_falling *given = scene->falling;

    f->given = given;
    f->balls = memory;
    f->ball_count = given->count;
    f->blocks = (struct fall_block *)(void *)((char *)memory + ALIGN(given->count * sizeof *f->balls));
    f->block_count = 0;
    for (uint32_t i = 0; i < given->count; i++)
        set_ball(scene, &given->balls[i], &f->balls[i]);
    set_blocks(f, scene);
}

void tia_fall_to(struct falling *f, uint32_t tick, uint32_t until)
{
    uint32_t left = until >> 8 >= tick ? until - (tick << 8) : 0;

    if (left)
        tia_fall_tick(f, tick, left < 256 ? left * 16 : FALL_TICK);
}

void tia_fall_put(const struct falling *f, const struct tia_scene *scene, struct tia_transform *transforms,
                  struct tia_shape *shapes)
{
    for (uint32_t i = 0; i < f->ball_count; i++) {
        uint32_t shape = f->given->balls[i].shape;
        put(&f->balls[i], &transforms[scene->shapes[shape].transform - 1].position);
        if (f->balls[i].lost)
            tia_fall_hide(scene, &shapes[shape]);
    }
}

void tia_fall_at(const struct tia_scene *scene, void *memory, tia_q16 time, struct tia_transform *transforms,
                 struct tia_shape *shapes, struct cancel *cancel)
{
    const struct tia_falling *given = scene->falling;
    uint32_t until = (uint32_t)(time < 0 ? 0 : time < given->end ? time : given->end);
    struct falling f = {.cancel = cancel};

    tia_fall_begin(&f, scene, memory);
    for (uint32_t tick = 0; tick <= until >> 8 && !cancel->stopped; tick++)
        tia_fall_to(&f, tick, until);
    tia_fall_put(&f, scene, transforms, shapes);
}
