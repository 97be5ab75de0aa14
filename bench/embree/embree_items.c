#include "embree_items.h"

#include <stdlib.h>

#include "embree_shade.h"

enum { TRIANGLES, BALLS, KINDS };

struct embree_items {
    const struct float_world *world;
    struct embree_scene made;
    uint32_t *item_of[KINDS]; /* indices of items, by the primitive's number */
};

static uint32_t count_of(const struct float_world *world, int kind)
{
    uint32_t count = 0;

    for (uint32_t i = 0; i < world->count; i++)
        count += (world->items[i].radius > 0) == (kind == BALLS);
    return count;
}

static void add_triangles(struct embree_items *e, RTCGeometry geometry, uint32_t count)
{
    struct vec(*corner)[3] = embree_triangles(geometry, count);

    for (uint32_t i = 0; i < count; i++) {
        const struct float_item *item = &e->world->items[e->item_of[TRIANGLES][i]];
        corner[i][0] = item->corner;
        corner[i][1] = vec_along(item->corner, 1, item->side[0]);
        corner[i][2] = vec_along(item->corner, 1, item->side[1]);
    }
}

static void add_balls(struct embree_items *e, RTCGeometry geometry, uint32_t count)
{
    float(*ball)[4] = embree_rounds(geometry, count);

    for (uint32_t i = 0; i < count; i++) {
        const struct float_item *item = &e->world->items[e->item_of[BALLS][i]];
        ball[i][0] = item->corner.x;
        ball[i][1] = item->corner.y;
        ball[i][2] = item->corner.z;
        ball[i][3] = item->radius;
    }
}

static bool add_kind(struct embree_items *e, int kind)
{
    uint32_t count = count_of(e->world, kind), n = 0;

    e->item_of[kind] = malloc((count + 1) * sizeof **e->item_of);
    if (!e->item_of[kind] || !count)
        return e->item_of[kind];
    for (uint32_t i = 0; i < e->world->count; i++)
        if ((e->world->items[i].radius > 0) == (kind == BALLS))
            e->item_of[kind][n++] = i;
    RTCGeometry geometry =
        rtcNewGeometry(e->made.device, kind == BALLS ? RTC_GEOMETRY_TYPE_SPHERE_POINT : RTC_GEOMETRY_TYPE_TRIANGLE);
    if (kind == BALLS)
        add_balls(e, geometry, count);
    else
        add_triangles(e, geometry, count);
    embree_attach(&e->made, geometry, (unsigned)kind);
    return true;
}

struct embree_items *embree_items_open(const struct float_world *world)
{
    struct embree_items *e = calloc(1, sizeof *e);

    if (!e)
        return NULL;
    e->world = world;
    if (!embree_scene_begin(&e->made) || !add_kind(e, TRIANGLES) || !add_kind(e, BALLS)) {
        embree_items_close(e);
        return NULL;
    }
    rtcCommitScene(e->made.scene);
    return e;
}

void embree_items_close(struct embree_items *e)
{
    if (!e)
        return;
    embree_scene_end(&e->made);
    for (int kind = 0; kind < KINDS; kind++)
        free(e->item_of[kind]);
    free(e);
}

static void meet_any(const struct embree_items *e, const struct float_ray *ray, struct float_hit *hit)
{
    struct RTCIntersectContext context;
    struct RTCRay shadow = ray_of(ray, hit->t);

    rtcInitIntersectContext(&context);
    rtcOccluded1(e->made.scene, &context, &shadow);
    hit->item = shadow.tfar < 0 ? e->world->items : NULL;
}

void embree_items_meet(const void *items, const struct float_ray *ray, bool any, struct float_hit *hit)
{
    const struct embree_items *e = items;
    struct RTCRayHit found;

    if (any) {
        meet_any(e, ray, hit);
        return;
    }
    if (!meet_nearest(e->made.scene, ray, hit->t, &found))
        return;
    hit->t = found.ray.tfar;
    hit->item = &e->world->items[e->item_of[found.hit.geomID][found.hit.primID]];
}

unsigned embree_modes_begin(void)
{
    return set_modes(FLUSH_TO_ZERO);
}

void embree_modes_end(unsigned before)
{
    (void)set_modes(before);
}
