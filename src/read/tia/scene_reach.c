#include "scene_reach.h"

#include "math/integer.h"
#include "scene/shapes/description.h"

/* Largest height of an eye above an infinite plane; a scene with a higher eye gets a larger unit of length. Hits end at
 * a distance of 65536. So the horizon of an eye 1 above the plane is 2^-16 too low, and that of an eye 8 above it
 * 2^-13, which is less than a quarter of a pixel. */
#define HEIGHT_MOST TIA_Q16(8)
/* Largest half width of a window whose width depends on the picture, in window heights. */
#define WINDOW_GROWS 32
#define OWN_MOST (INT64_C(1) << 33) /* a length beyond any scene; times the largest scale, it fits in 64 bits */

static int64_t larger(int64_t a, int64_t b)
{
    return a > b ? a : b;
}

static int64_t size_of(struct tia_vec3 v)
{
    int64_t x = v.x < 0 ? -(int64_t)v.x : v.x, y = v.y < 0 ? -(int64_t)v.y : v.y, z = v.z < 0 ? -(int64_t)v.z : v.z;

    return larger(x, larger(y, z));
}

/* Returns an upper bound of the distance from 0 to a point whose coordinates are at most `size`: sqrt(3) `size`,
 * rounded up. */
static int64_t distance(int64_t size)
{
    return size * 7 / 4 + 2;
}

static void lengthen(struct tia_reach *r, int64_t length)
{
    r->lengths.longest = larger(r->lengths.longest, length);
}

static void enlarge_own(struct tia_reach *r, int64_t radius)
{
    r->own = larger(r->own, radius < OWN_MOST ? radius : OWN_MOST);
}

static void place(struct tia_reach *r, struct tia_vec3 position)
{
    tia_span_cover(&r->places, position, 0);
    lengthen(r, size_of(position));
}

static void scale(struct tia_reach *r, struct tia_vec3 s)
{
    const tia_q16 by[3] = {s.x, s.y, s.z};

    for (int i = 0; i < 3; i++) {
        r->scale_least = by[i] < r->scale_least ? by[i] : r->scale_least;
        r->scale_largest = by[i] > r->scale_largest ? by[i] : r->scale_largest;
    }
}

void tia_reach_begin(struct tia_reach *r, int scale_bits, tia_q16 places)
{
    *r = (struct tia_reach){.scale_least = TIA_Q16_ONE, .scale_largest = TIA_Q16_ONE};
    tia_lengths_begin(&r->lengths, scale_bits, places);
    tia_span_begin(&r->places);
}

/* Returns the shape's largest radius. */
static int64_t radius_of(const struct tia_shape *shape)
{
    int64_t radius = 0;

    for (const struct tia_shape_field *f = tia_shape_fields(shape->kind); f->member; f++)
        if (f->value == TIA_SHAPE_Q16)
            radius = larger(radius, *(const tia_q16 *)(const void *)((const char *)shape + f->offset));
    return radius;
}

/* Returns the field of a shape's struct. */
static struct tia_vec3 vector_of(const struct tia_shape *shape, const struct tia_shape_field *f)
{
    return *(const struct tia_vec3 *)(const void *)((const char *)shape + f->offset);
}

void tia_reach_shape(struct tia_reach *r, const struct tia_shape *shape, const struct tia_transform *transform,
                     bool placed, bool moves)
{
    bool solid = shape->kind == TIA_MESH || shape->kind == TIA_GRID || shape->kind == TIA_SOLID;
    int64_t radius = solid ? 0 : radius_of(shape);

    for (const struct tia_shape_field *f = solid ? NULL : tia_shape_fields(shape->kind); f && f->member; f++) {
        if (f->value != TIA_SHAPE_VEC3)
            continue;
        struct tia_vec3 point = vector_of(shape, f);
        if (!placed)
            tia_lengths_cover(&r->lengths, point, radius);
        if (placed || moves)
            enlarge_own(r, distance(size_of(point)) + radius);
    }
    if (placed || moves || solid)
        place(r, transform->position);
    if (placed)
        scale(r, transform->scale);
}

void tia_reach_member(struct tia_reach *r, const struct tia_shape *member, const struct tia_transform *t)
{
    int64_t radius = radius_of(member), at = distance(size_of(t->position)), by = size_of(t->scale);

    scale(r, t->scale);
    for (const struct tia_shape_field *f = tia_shape_fields(member->kind); f->member; f++)
        if (f->value == TIA_SHAPE_VEC3) {
            int64_t around = (distance(size_of(vector_of(member, f))) + radius) * by / TIA_Q16_ONE + at;
            lengthen(r, around);
            enlarge_own(r, around);
        }
}

void tia_reach_vertex(struct tia_reach *r, struct tia_vec3 vertex)
{
    enlarge_own(r, distance(size_of(vertex)));
}

void tia_reach_grid(struct tia_reach *r, const struct tia_grid *grid)
{
    int64_t most = size_of(grid->corner);

    for (int i = 0; i < 3; i++)
        most = larger(most, size_of(grid->corner) + (int64_t)grid->size[i] * grid->cell);
    lengthen(r, most);
    enlarge_own(r, distance(most));
}

void tia_reach_light(struct tia_reach *r, const struct tia_light *light)
{
    int64_t radius = larger(light->radius, size_of(light->side[0]) + size_of(light->side[1]));

    tia_lengths_cover(&r->lengths, light->centre, radius);
    enlarge_own(r, distance(radius));
}

/* Returns the maximum corner of a box around an observer line or, for -line, the minimum corner. The line has the
 * middle `eye`, the half length `line`, and any direction. */
static struct tia_vec3 beside(struct tia_vec3 eye, tia_q16 line)
{
    return (struct tia_vec3){tia_saturate_s32((int64_t)eye.x + line), tia_saturate_s32((int64_t)eye.y + line),
                             tia_saturate_s32((int64_t)eye.z + line)};
}

void tia_reach_camera(struct tia_reach *r, const struct tia_camera *camera)
{
    const struct tia_window *w = &camera->window;
    int64_t side =
        larger(size_of((struct tia_vec3){w->left, w->right, 0}), size_of((struct tia_vec3){w->bottom, w->top, 0}));

    tia_lengths_cover_eye(&r->lengths, beside(camera->eye, -camera->line));
    tia_lengths_cover_eye(&r->lengths, beside(camera->eye, camera->line));
    if (camera->up.x || camera->up.y || camera->up.z)
        tia_lengths_cover(&r->lengths, camera->reference, 0);
    lengthen(r, side * 3 / 2 + camera->line);
    if (!w->left && !w->right)
        lengthen(r, ((int64_t)w->top - w->bottom) * WINDOW_GROWS);
}

/* Returns bounds of a track's values. A smooth curve leaves the box around its keyframes by at most 8/27 of the box's
 * size: neither of its two tangents is longer than the box, and each has a weight of at most 4/27. */
static struct tia_span path(const struct tia_track *track, struct tia_span values)
{
    for (int i = 0; i < 3 && track->smooth; i++) {
        int64_t beyond = (values.max[i] - values.min[i]) / 3 + 1;
        values.min[i] -= beyond;
        values.max[i] += beyond;
    }
    return values;
}

void tia_reach_keys(struct tia_reach *r, const struct tia_track *track, struct tia_span values)
{
    struct tia_span span = path(track, values);

    switch (track->target) {
    case TIA_MOVES_EYE:
        tia_span_join(&r->lengths.eyes, &span);
        tia_span_join(&r->lengths.all, &span);
        break;
    case TIA_MOVES_REFERENCE:
        tia_span_join(&r->lengths.all, &span);
        break;
    case TIA_MOVES_LIGHT:
    case TIA_MOVES_TRANSFORM:
        tia_span_join(&r->places, &span);
        break;
    case TIA_SCALES_TRANSFORM:
        for (int i = 0; i < 3; i++) {
            r->scale_least = span.min[i] < r->scale_least ? (tia_q16)span.min[i] : r->scale_least;
            r->scale_largest = span.max[i] > r->scale_largest ? (tia_q16)span.max[i] : r->scale_largest;
        }
        break;
    default: /* values that are not positions */
        break;
    }
}

void tia_reach_group(struct tia_reach *r, const int64_t position[3])
{
    for (int i = 0; i < 3; i++)
        lengthen(r, (position[i] < 0 ? -position[i] : position[i]) >> 16);
}

void tia_reach_plane(struct tia_reach *r, const struct tia_plane *plane)
{
    const struct tia_span *eyes = &r->lengths.eyes;

    for (int i = 0; i < 8; i++) {
        int64_t x = (i & 1 ? eyes->max : eyes->min)[0] - plane->point.x;
        int64_t y = (i & 2 ? eyes->max : eyes->min)[1] - plane->point.y;
        int64_t z = (i & 4 ? eyes->max : eyes->min)[2] - plane->point.z;
        int64_t height =
            (x * (plane->normal.x >> 10) + y * (plane->normal.y >> 10) + z * (plane->normal.z >> 10)) >> 20;
        r->height = larger(r->height, height < 0 ? -height : height);
    }
}

/* Extends the bounds by a box around all placed objects. Half the diagonal of an object's box, over the smallest scale,
 * must fit as well: see tia_transform. */
static void add_placed(struct tia_reach *r)
{
    int64_t largest = r->scale_largest < TIA_SCALE_MAX ? r->scale_largest : TIA_SCALE_MAX;
    int64_t least = r->scale_least > TIA_SCALE_MIN ? r->scale_least : TIA_SCALE_MIN;
    int64_t around = (r->own * largest >> 16) + 2;

    if (r->places.min[0] > r->places.max[0])
        return;
    for (int i = 0; i < 3; i++) {
        r->places.min[i] -= around;
        r->places.max[i] += around;
    }
    tia_span_join(&r->lengths.all, &r->places);
    if (least < TIA_Q16_ONE)
        lengthen(r, distance(around) * TIA_Q16_ONE / least);
}

int tia_reach_room(const struct tia_reach *reach)
{
    struct tia_reach r = *reach;

    add_placed(&r);
    int bits = tia_lengths_room(&r.lengths);
    bool finer = (r.lengths.rounded || r.lengths.finest) && !r.falls;
    return bits > 0 && !finer ? 0 : bits;
}

int tia_reach_bits(const struct tia_reach *reach, int most)
{
    int bits = most;
    bool sees = !reach->lengths.finest && !reach->falls;

    while (bits > -TIA_SCALE_BITS_MAX && sees &&
           tia_length_times(reach->height, bits - reach->lengths.scale_bits) > HEIGHT_MOST)
        bits--;
    return bits;
}
