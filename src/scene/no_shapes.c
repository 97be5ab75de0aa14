/* no_shapes.c - replaces shapes, hierarchies and animation in programs for small boards, which have room for
 * spheres only: scenes with anything else are refused. */
#include <tia/motion.h>

#include "scene/check/check.h"

#define RULE "must be none: this program draws spheres alone"

bool tia_check_has_texture(const struct check *check, uint32_t number, bool opacity)
{
    (void)check;
    (void)number;
    (void)opacity;
    return false;
}

int tia_check_texture(const struct check *check)
{
    return tia_check_refuse(check, "count", RULE);
}

int tia_check_transform(const struct check *check)
{
    return tia_check_refuse(check, "count", RULE);
}

int tia_check_mesh(const struct check *check)
{
    return tia_check_refuse(check, "count", RULE);
}

int tia_check_grid(const struct check *check)
{
    return tia_check_refuse(check, "count", RULE);
}

int tia_check_shape(const struct check *check)
{
    return tia_check_refuse(check, "count", RULE);
}

int tia_check_track(const struct check *check)
{
    return tia_check_refuse(check, "count", RULE);
}

int tia_check_falling(const struct check *check)
{
    return check->scene->falling ? tia_check_refuse(check, "falling", RULE) : TIA_OK;
}

int tia_check_fall(const struct check *check)
{
    return tia_check_refuse(check, "count", RULE);
}

int tia_check_uses(struct check *check)
{
    (void)check;
    return TIA_OK;
}

void tia_check_eyes(const struct tia_camera *camera, struct tia_bounds *eyes)
{
    (void)camera;
    (void)eyes;
}

int tia_check_rendering(struct check *check)
{
    return check->scene->shadows ? tia_check_refuse(check, "shadows", RULE) : TIA_OK;
}

void tia_bounds_add(struct tia_bounds *bounds, const struct tia_bounds *more)
{
    (void)bounds;
    (void)more;
}

size_t tia_bvh_size(const struct tia_scene *scene)
{
    (void)scene;
    return 0;
}

int tia_bvh_build(const struct tia_bvh **bvh, void *memory, size_t size, size_t *used, const struct tia_scene *scene)
{
    return tia_bvh_build_until(bvh, memory, size, used, scene, NULL, NULL);
}

int tia_bvh_build_until(const struct tia_bvh **bvh, void *memory, size_t size, size_t *used,
                        const struct tia_scene *scene, bool (*stop)(void *ctx), void *ctx)
{
    (void)bvh;
    (void)memory;
    (void)size;
    (void)used;
    (void)scene;
    (void)stop;
    (void)ctx;
    return TIA_ERR_UNSUPPORTED;
}

int tia_bvh_build_parallel(const struct tia_bvh **bvh, void *memory, size_t size, size_t *used,
                           const struct tia_scene *scene, const struct tia_workers *workers, void *workers_ctx,
                           bool (*stop)(void *ctx), void *ctx)
{
    (void)workers;
    (void)workers_ctx;
    return tia_bvh_build_until(bvh, memory, size, used, scene, stop, ctx);
}

size_t tia_bvh_move_size(const struct tia_scene *scene)
{
    return tia_bvh_size(scene);
}

int tia_bvh_move(const struct tia_bvh **bvh, void *memory, size_t size, const struct tia_scene *scene,
                 const struct tia_scene *standing, bool (*stop)(void *ctx), void *ctx)
{
    (void)standing;
    return tia_bvh_build_until(bvh, memory, size, NULL, scene, stop, ctx);
}

size_t tia_scene_at_size(const struct tia_scene *scene)
{
    (void)scene;
    return 0;
}

int tia_scene_at(struct tia_scene *out, void *memory, size_t size, const struct tia_scene *scene, tia_q16 time)
{
    return tia_scene_at_until(out, memory, size, scene, time, NULL, NULL);
}

int tia_scene_at_until(struct tia_scene *out, void *memory, size_t size, const struct tia_scene *scene, tia_q16 time,
                       bool (*stop)(void *ctx), void *ctx)
{
    (void)memory;
    (void)size;
    (void)time;
    (void)stop;
    (void)ctx;
    if (!out || !scene)
        return TIA_ERR_ARGUMENT;
    *out = *scene;
    return tia_scene_moves(scene) ? TIA_ERR_UNSUPPORTED : TIA_OK;
}

bool tia_scene_moves(const struct tia_scene *scene)
{
    return scene && (scene->track_count > 0 || scene->falling);
}

tia_q16 tia_scene_duration(const struct tia_scene *scene)
{
    (void)scene;
    return 0;
}
