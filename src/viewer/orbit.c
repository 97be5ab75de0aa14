/* orbit.c - a camera moved by keys, in 64-bit integers. */
#include <tia/bvh.h>
#include <tia/orbit.h>

#include "math/integer.h"
#include "math/rotation.h"

#define AIM_FAR TIA_Q16(10)
#define HALF_TURN TIA_Q16(180)
#define FOV_WIDEST TIA_Q16(120)

/* Returns a 2^-30, rounded to nearest, ties away from 0. */
static int64_t drop30(int64_t a)
{
    const int64_t one = INT64_C(1) << 30, half = one / 2;

    return a < 0 ? -((half - a) / one) : (a + half) / one;
}

/* A displacement in units of 2^-16; each component is below 2^31 in magnitude. */
struct way {
    int64_t x, y, z;
};

static struct way from_to(struct tia_vec3 a, struct tia_vec3 b)
{
    return (struct way){(int64_t)b.x - a.x, (int64_t)b.y - a.y, (int64_t)b.z - a.z};
}

/* Returns the dot product. The length of `a` is at most 1, so no sum exceeds 2^62. */
static int64_t dot(struct tia_dir3 a, struct way b)
{
    return drop30(a.x * b.x + a.y * b.y + a.z * b.z);
}

static struct way cross(struct tia_dir3 a, struct way b)
{
    return (struct way){drop30(a.y * b.z - a.z * b.y), drop30(a.z * b.x - a.x * b.z), drop30(a.x * b.y - a.y * b.x)};
}

/* Returns the direction of a displacement; +y if it is 0. */
static struct tia_dir3 direction(struct way a)
{
    if (!a.x && !a.y && !a.z)
        a.y = 1;
    return tia_normalise((int32_t)a.x, (int32_t)a.y, (int32_t)a.z);
}

static bool fits(int64_t a)
{
    return a >= INT32_MIN && a <= INT32_MAX;
}

static bool add(struct tia_vec3 *point, struct way by)
{
    int64_t x = point->x + by.x, y = point->y + by.y, z = point->z + by.z;

    if (!fits(x) || !fits(y) || !fits(z))
        return false;
    *point = (struct tia_vec3){(tia_q16)x, (tia_q16)y, (tia_q16)z};
    return true;
}

/* ---- the point looked at ---- */

static int64_t size_of(int64_t a)
{
    return a < 0 ? -a : a;
}

/* Returns the distance to an object ahead, Q16.16, or 0 when it is not ahead or, like a plane, has no bounds. *off
 * receives |x| + |y|, the distance of the object's middle from the line of sight, divided by the result; Q16.16. */
static int64_t ahead_of(const struct tia_camera *camera, const struct tia_scene *scene, uint32_t object, uint64_t *off)
{
    struct tia_bounds b = tia_object_bounds(scene, object);
    int64_t x = ((int64_t)b.min.x + b.max.x) / 2 - camera->eye.x, y = ((int64_t)b.min.y + b.max.y) / 2 - camera->eye.y;
    int64_t z = camera->eye.z - ((int64_t)b.min.z + b.max.z) / 2;

    if (b.max.x < b.min.x || z <= 0 || b.min.x == INT32_MIN || b.max.x == INT32_MAX)
        return 0;
    *off = (uint64_t)(size_of(x) + size_of(y)) * TIA_Q16_ONE / (uint64_t)z;
    return z;
}

/* True if the camera has an up vector, so that it can turn. */
static bool looks_about(const struct tia_camera *camera)
{
    return camera->up.x || camera->up.y || camera->up.z;
}

void tia_camera_aim(struct tia_camera *camera, const struct tia_scene *scene)
{
    int64_t best = AIM_FAR;
    uint64_t least = UINT64_MAX, off = 0;

    if (!camera || !scene || looks_about(camera))
        return;
    for (uint32_t i = 0; i < scene->sphere_count + scene->shape_count; i++) {
        int64_t z = ahead_of(camera, scene, i, &off);
        if (z && off < least) {
            least = off;
            best = z;
        }
    }
    camera->up = (struct tia_vec3){0, TIA_Q16_ONE, 0};
    camera->reference = camera->eye;
    (void)add(&camera->reference, (struct way){0, 0, -(best < INT32_MAX / 2 ? best : INT32_MAX / 2)});
}

/* ---- orbiting ---- */

/* Rotates about the axis K by Rodrigues' formula: v cos + (K x v) sin + K (K.v) (1 - cos); each product is below 2^61.
 */
static struct way rotate(struct way v, struct tia_dir3 k, tia_q16 degrees)
{
    int64_t sine, cosine, along = dot(k, v);
    struct way w = cross(k, v);

    tia_sincos(degrees, &sine, &cosine);
    sine /= INT64_C(1) << 32;
    cosine /= INT64_C(1) << 32;
    int64_t rest = TIA_Q30_ONE - cosine;
    return (struct way){drop30(v.x * cosine + w.x * sine + drop30(k.x * along) * rest),
                        drop30(v.y * cosine + w.y * sine + drop30(k.y * along) * rest),
                        drop30(v.z * cosine + w.z * sine + drop30(k.z * along) * rest)};
}

/* True if v is within 3 degrees of the up axis: cos^2 > 1 - 1/365. */
static bool is_at_pole(struct way v, struct tia_dir3 up)
{
    uint64_t square = (uint64_t)(v.x * v.x) + (uint64_t)(v.y * v.y) + (uint64_t)(v.z * v.z);
    int64_t along = dot(up, v);

    return (uint64_t)(along * along) > square - square / 365;
}

/* True if the displacement is shorter than 32768. */
static bool is_short(struct way v)
{
    return size_of(v.x) <= INT32_MAX && size_of(v.y) <= INT32_MAX && size_of(v.z) <= INT32_MAX &&
           (uint64_t)(v.x * v.x) + (uint64_t)(v.y * v.y) + (uint64_t)(v.z * v.z) < UINT64_C(1) << 62;
}

static bool is_half_turn(tia_q16 degrees)
{
    return degrees >= -HALF_TURN && degrees <= HALF_TURN;
}

void tia_camera_orbit(struct tia_camera *camera, tia_q16 right, tia_q16 up)
{
    if (!camera || !looks_about(camera) || !is_half_turn(right) || !is_half_turn(up))
        return;
    struct way v = from_to(camera->reference, camera->eye), turned;
    struct tia_dir3 axis = tia_normalise(camera->up.x, camera->up.y, camera->up.z);
    struct tia_vec3 eye = camera->reference;

    if (!is_short(v))
        return;
    v = rotate(v, axis, right);
    turned = rotate(v, direction(cross(axis, v)), -up);
    if (!is_at_pole(turned, axis))
        v = turned;
    if (add(&eye, v))
        camera->eye = eye;
}

/* ---- moving along the axes ---- */

static struct way scaled(struct tia_dir3 a, int64_t length)
{
    return (struct way){drop30(a.x * length), drop30(a.y * length), drop30(a.z * length)};
}

/* Returns the direction of a displacement that may be too long for struct way. */
static struct tia_dir3 direction_of_long(struct way a)
{
    while (!is_short(a))
        a = (struct way){a.x / 2, a.y / 2, a.z / 2};
    return direction(a);
}

void tia_camera_walk(struct tia_camera *camera, int right, int up, int ahead)
{
    if (!camera || !is_short(from_to(camera->eye, camera->reference)))
        return;
    struct way v = from_to(camera->eye, camera->reference);
    struct tia_dir3 n = direction(v);
    struct tia_dir3 u = direction_of_long(cross(n, (struct way){camera->up.x, camera->up.y, camera->up.z}));
    struct way n_way = {n.x, n.y, n.z}, above = cross(u, n_way);
    struct tia_dir3 w = direction(above);
    int64_t step = dot(n, v) / 32;

    if (size_of(right * step) > INT32_MAX || size_of(up * step) > INT32_MAX || size_of(ahead * step) > INT32_MAX)
        return;
    struct way x = scaled(u, right * step), y = scaled(w, up * step), z = scaled(n, ahead * step);
    struct way by = {x.x + y.x + z.x, x.y + y.y + z.y, x.z + y.z + z.z};
    struct tia_vec3 eye = camera->eye, reference = camera->reference;

    if (add(&eye, by) && add(&reference, by)) {
        camera->eye = eye;
        camera->reference = reference;
    }
}

/* ---- zooming ---- */

static tia_q16 narrowed(tia_q16 a, bool in)
{
    int64_t to = in ? (int64_t)a * 7 / 8 : (int64_t)a * 8 / 7;

    return fits(to) ? (tia_q16)to : a;
}

void tia_camera_zoom(struct tia_camera *camera, bool in)
{
    if (!camera)
        return;
    struct tia_window *w = &camera->window;

    if (camera->projection == TIA_PERSPECTIVE) {
        tia_q16 fov = narrowed(camera->fov, in);
        if (fov >= TIA_FOV_MIN && (in || fov <= FOV_WIDEST))
            camera->fov = fov;
        return;
    }
    w->left = narrowed(w->left, in);
    w->right = narrowed(w->right, in);
    w->bottom = narrowed(w->bottom, in);
    w->top = narrowed(w->top, in);
}
