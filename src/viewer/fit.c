/* fit.c - the place for the eye from which the whole scene is visible, in 64-bit integers.
 *
 * A point with the coordinates x, y, z along the camera's axes u, v, n, from the middle of all boxes, is in the picture
 * of an eye at (ex, ey, d) that sees from the slope `low` to the slope `high` along u if
 *
 *     (d - z) low <= x - ex <= (d - z) high,
 *
 * so d high + ex >= x + z high =: a and -d low - ex >= -x - z low =: b. The nearest eye has d (high - low) = max a +
 * max b; for a larger d, ex is the middle of what it may be, from max a - d high to -d low - max b. Along v likewise.
 */
#include <tia/bvh.h>
#include <tia/fit.h>
#include <tia/port.h>

#include "math/rotation.h"
#include "scene/axes.h"

#define SLOPE_BITS 16
#define SLOPE_MOST (INT64_C(16) << SLOPE_BITS) /* wider pictures are not filled */
#define DISTANCE_MOST (INT64_C(1) << 40)       /* Q16: times a slope below 2^61 */
#define IN_FRONT (TIA_Q16_ONE / 16)            /* the least distance of the eye from the boxes */

/* What the boxes need along an axis of the picture. */
struct fit_side {
    int64_t low, high; /* slopes, Q16 */
    int64_t a, b;      /* maxima */
    int64_t min, max;
};

struct fit_job {
    const struct tia_scene *scene;
    int64_t axes[3][3]; /* Q30 */
    struct tia_bounds all;
    int64_t middle[3], nearest;
    struct fit_side side[2];
};

/* ---- the boxes ---- */

typedef void fit_box(struct fit_job *job, const struct tia_bounds *box);

static bool is_finite(const struct tia_bounds *b)
{
    return b->max.x >= b->min.x && b->min.x > INT32_MIN && b->min.y > INT32_MIN && b->min.z > INT32_MIN &&
           b->max.x < INT32_MAX && b->max.y < INT32_MAX && b->max.z < INT32_MAX;
}

static void for_each_box(struct fit_job *job, fit_box *take)
{
    const struct tia_bvh *bvh = job->scene->bvh;

    for (uint32_t i = 0; bvh && i < bvh->objects.node_count; i++)
        if (bvh->objects.nodes[i].count)
            take(job, &bvh->objects.nodes[i].bounds);
    for (uint32_t i = 0; !bvh && i < job->scene->sphere_count + job->scene->shape_count; i++) {
        struct tia_bounds box = tia_object_bounds(job->scene, i);
        if (is_finite(&box))
            take(job, &box);
    }
}

static tia_q16 smaller(tia_q16 a, tia_q16 b)
{
    return a < b ? a : b;
}

static tia_q16 larger(tia_q16 a, tia_q16 b)
{
    return a > b ? a : b;
}

static void join(struct fit_job *job, const struct tia_bounds *box)
{
    struct tia_bounds *all = &job->all;

    all->min = (struct tia_vec3){smaller(all->min.x, box->min.x), smaller(all->min.y, box->min.y),
                                 smaller(all->min.z, box->min.z)};
    all->max = (struct tia_vec3){larger(all->max.x, box->max.x), larger(all->max.y, box->max.y),
                                 larger(all->max.z, box->max.z)};
}

static void cover_side(struct fit_side *side, int64_t x, int64_t z)
{
    int64_t a = x + ((z * side->high) >> SLOPE_BITS), b = -x - ((z * side->low) >> SLOPE_BITS);

    side->a = a > side->a ? a : side->a;
    side->b = b > side->b ? b : side->b;
    side->min = x < side->min ? x : side->min;
    side->max = x > side->max ? x : side->max;
}

/* Covers the corners of a box. Each is at most 2^31 sqrt(3) from the middle, so no sum of products exceeds 2^62. */
static void cover(struct fit_job *job, const struct tia_bounds *box)
{
    for (unsigned corner = 0; corner < 8; corner++) {
        int64_t p[3] = {corner & 1 ? box->min.x : box->max.x, corner & 2 ? box->min.y : box->max.y,
                        corner & 4 ? box->min.z : box->max.z};
        int64_t at[3];
        for (int i = 0; i < 3; i++) {
            at[i] = 0;
            for (int k = 0; k < 3; k++)
                at[i] += job->axes[i][k] * (p[k] - job->middle[k]);
            at[i] >>= 30;
        }
        job->nearest = at[2] > job->nearest ? at[2] : job->nearest;
        cover_side(&job->side[0], at[0], at[2]);
        cover_side(&job->side[1], at[1], at[2]);
    }
}

/* ---- the picture ---- */

static int64_t slope(int64_t a, int64_t by)
{
    int64_t s = a * (INT64_C(1) << SLOPE_BITS) / by;
    return s > SLOPE_MOST ? SLOPE_MOST : s < -SLOPE_MOST ? -SLOPE_MOST : s;
}

/* Returns the side with these slopes, less the margins. */
static struct fit_side between(int64_t low, int64_t high)
{
    int64_t margin = (high - low) / 64;

    return (struct fit_side){.low = low + margin,
                             .high = high > low ? high - margin : low + 1,
                             .a = INT64_MIN,
                             .b = INT64_MIN,
                             .min = INT64_MAX,
                             .max = INT64_MIN};
}

/* Sets the slopes. Those of an orthographic camera do not matter. */
static void set_sides(struct fit_job *job, unsigned width, unsigned height)
{
    const struct tia_camera *c = &job->scene->camera;
    const struct tia_window *w = &c->window;
    int64_t sine = 0, cosine = INT64_C(1) << 62, bottom = w->bottom, top = w->top, near = w->near;

    if (c->projection == TIA_PERSPECTIVE) {
        tia_sincos(c->fov / 2, &sine, &cosine);
        top = sine >> 31;
        bottom = -top;
        near = cosine >> 31;
    }
    bool centred = c->projection == TIA_PERSPECTIVE || (!w->left && !w->right);
    int64_t half = (top - bottom) / 2 * width / height;
    near = near > 0 ? near : TIA_Q16_ONE;
    job->side[0] =
        centred ? between(slope(-half, near), slope(half, near)) : between(slope(w->left, near), slope(w->right, near));
    job->side[1] = between(slope(bottom, near), slope(top, near));
}

static int64_t distance_for(const struct fit_side *side)
{
    return (side->a + side->b) * (INT64_C(1) << SLOPE_BITS) / (side->high - side->low);
}

/* Returns the eye's place along the axis of a side, at the distance d. */
static int64_t place_for(const struct fit_side *side, int64_t d)
{
    int64_t from = side->a - (d * side->high >> SLOPE_BITS), to = -(d * side->low >> SLOPE_BITS) - side->b;
    return from + (to - from) / 2;
}

/* Finds the place along the axes. */
static int place(struct tia_fit *fit, const struct fit_job *job, unsigned width, unsigned height, int64_t at[3])
{
    const struct fit_side *u = &job->side[0], *v = &job->side[1];
    int64_t d = job->nearest + IN_FRONT, x = distance_for(u), y = distance_for(v);

    if (job->scene->camera.projection == TIA_ORTHOGRAPHIC) {
        int64_t wide = (u->max - u->min) * height / width, high = v->max - v->min;
        fit->height = (wide > high ? wide : high) * 32 / 31 + 2;
        at[0] = u->min + (u->max - u->min) / 2;
        at[1] = v->min + (v->max - v->min) / 2;
    } else {
        d = x > d ? x : d;
        d = y > d ? y : d;
        d = d < DISTANCE_MOST ? d : DISTANCE_MOST;
        at[0] = place_for(u, d);
        at[1] = place_for(v, d);
    }
    at[2] = d;
    return d < DISTANCE_MOST ? TIA_OK : TIA_ERR_RANGE;
}

/* Returns a component of an axis times a length of up to 2^40; for long ones with 22 of its 30 bits. */
static int64_t times(int64_t axis, int64_t length)
{
    bool is_long = length > INT64_C(1) << 31 || length < -(INT64_C(1) << 31);
    return is_long ? (axis >> 8) * length >> 22 : axis * length >> 30;
}

static void set_axes(struct fit_job *job)
{
    const struct tia_camera *c = &job->scene->camera;
    const int64_t back[3] = {(int64_t)c->eye.x - c->reference.x, (int64_t)c->eye.y - c->reference.y,
                             (int64_t)c->eye.z - c->reference.z};

    tia_camera_axes(job->axes, c, back);
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            job->axes[i][k] >>= 32;
}

int tia_camera_fit(struct tia_fit *fit, const struct tia_scene *scene, unsigned width, unsigned height)
{
    struct fit_job job = {.scene = scene,
                          .all = {{INT32_MAX, INT32_MAX, INT32_MAX}, {INT32_MIN, INT32_MIN, INT32_MIN}},
                          .nearest = INT64_MIN};
    int64_t at[3];

    if (!fit || !scene || !width || !height || width > TIA_SIZE_MAX || height > TIA_SIZE_MAX)
        return TIA_ERR_ARGUMENT;
    *fit = (struct tia_fit){.height = 0};
    for_each_box(&job, join);
    if (job.all.max.x < job.all.min.x)
        return TIA_ERR_RANGE;
    job.middle[0] = ((int64_t)job.all.min.x + job.all.max.x) / 2;
    job.middle[1] = ((int64_t)job.all.min.y + job.all.max.y) / 2;
    job.middle[2] = ((int64_t)job.all.min.z + job.all.max.z) / 2;
    set_axes(&job);
    set_sides(&job, width, height);
    for_each_box(&job, cover);
    int status = place(fit, &job, width, height, at);
    for (int k = 0; k < 3 && !status; k++) {
        fit->reference[k] = job.middle[k] + times(job.axes[0][k], at[0]) + times(job.axes[1][k], at[1]);
        fit->eye[k] = fit->reference[k] + times(job.axes[2][k], at[2]);
    }
    return status;
}
