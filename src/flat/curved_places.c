#include "curved_places.h"

#include "scene/object_bounds.h"

static bool is_curved(const struct tia_scene *scene, uint32_t object)
{
    return !tia_flat_takes(scene, object) && !tia_flat_is_empty(scene, object);
}

uint32_t tia_curved_count(const struct tia_scene *scene)
{
    uint32_t count = 0;

    for (uint32_t i = 0; i < scene->sphere_count + scene->shape_count; i++)
        count += is_curved(scene, i);
    return count;
}

/* Gives corner i of a box, Q31.32. */
static void corner_of(const struct bounds_wide *box, unsigned i, int64_t corner[3])
{
    for (int k = 0; k < 3; k++)
        corner[k] = (i >> k & 1 ? box->max[k] : box->min[k]) * (INT64_C(1) << 16);
}

/* Returns (a + w)/(2 w) times `size` pixels, rounded down, clamped to -size/2..3/2 size. w > 0. */
static int64_t pixel_of(int64_t a, int64_t w, unsigned size)
{
    a = a < -2 * w ? -2 * w : a > 2 * w ? 2 * w : a;
    return (a + 3 * w) * (int64_t)size / (2 * w) - (int64_t)size;
}

static uint16_t clamped(int64_t pixel, unsigned size)
{
    return (uint16_t)(pixel < 0 ? 0 : pixel > (int64_t)size ? (int64_t)size : pixel);
}

struct reach {
    int64_t x0, x1, y0, y1;
};

static void include(struct reach *r, const struct tia_raster_vertex *v, unsigned width, unsigned height)
{
    int64_t x = pixel_of(v->x, v->w, width), y = pixel_of(-v->y, v->w, height);

    r->x0 = x < r->x0 ? x : r->x0;
    r->x1 = x > r->x1 ? x : r->x1;
    r->y0 = y < r->y0 ? y : r->y0;
    r->y1 = y > r->y1 ? y : r->y1;
}

#define RANGE_MAX 20
#define BITS 40
/* With an error of 1/2 in the coordinates, a position in the image is off by at most 8192/2^17 pixels. */
#define LEAST_W (INT32_C(1) << 17)

/* Gives the rectangle of pixels around a box's corners. False when part of the box is not in front of the eye, or is
 * too far aside. */
static bool box_reach(const struct bounds_wide *box, const struct tia_eye *eye, unsigned width, unsigned height,
                      struct reach *r)
{
    *r = (struct reach){INT64_MAX, INT64_MIN, INT64_MAX, INT64_MIN};
    for (unsigned i = 0; i < 8; i++) {
        int64_t corner[3];
        struct tia_raster_vertex v;

        corner_of(box, i, corner);
        unsigned range = tia_eye_range(eye, corner);
        if (range > RANGE_MAX)
            return false;
        tia_eye_point(eye, corner, BITS - (int)range, &v);
        if (v.w < LEAST_W)
            return false;
        include(r, &v, width, height);
    }
    return true;
}

/* Finds the pixels that may show an object: those of the rectangle around its box, and one more on every side for the
 * rounding of corners and rays and for all samples. */
static void find(struct tia_curved_place *place, const struct tia_scene *scene, const struct tia_eye *eye,
                 unsigned width, unsigned height)
{
    struct bounds_wide box;
    struct reach r;

    place->x0 = place->y0 = 0;
    place->x1 = (uint16_t)width;
    place->y1 = (uint16_t)height;
    if (!tia_bounds_in_world(scene, place->object, NULL, &box) || !box_reach(&box, eye, width, height, &r))
        return;
    place->x0 = clamped(r.x0 - 1, width);
    place->x1 = clamped(r.x1 + 2, width);
    place->y0 = clamped(r.y0 - 1, height);
    place->y1 = clamped(r.y1 + 2, height);
}

void tia_curved_find(struct tia_curved_place *places, const struct tia_scene *scene, const struct tia_eye *eye,
                     unsigned width, unsigned height)
{
    uint32_t count = 0;

    for (uint32_t i = 0; i < scene->sphere_count + scene->shape_count; i++)
        if (is_curved(scene, i)) {
            places[count].object = i;
            find(&places[count++], scene, eye, width, height);
        }
}
