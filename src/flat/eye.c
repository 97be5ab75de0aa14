/* eye.c - the camera's matrix. With the axes u, v, n, see camera.h, and a point u p + v q + n r relative to the eye
 *
 *     perspective    x = cot(fov/2) height/width p,  y = cot(fov/2) q,  w = -r
 *     frustum        x = (2 near p + (right + left) r)/(right - left),  y likewise,  w = -r
 *     orthographic   x = (2 p - (right + left))/(right - left),  y likewise,  h = r
 *
 * so that the image shows -w..w in x and y. Each coordinate is a sum of three products, rounded once.
 */
#include "eye.h"

#include "math/rotation.h"
#include "math/trig.h"
#include "math/wide.h"
#include "scene/axes.h"

/* A ratio: m 2^-places. */
struct ratio {
    int64_t m; /* 2^58..2^62 */
    int places;
};

static int bits_of(int64_t a)
{
    return 64 - (int)tia_clz64((uint64_t)(a < 0 ? -a : a));
}

/* Returns a/b with a relative error below 2^-57. a and b are above 0; their lengths differ by at most 60 bits.
 */
static struct ratio ratio(int64_t a, int64_t b)
{
    int places = 60 - bits_of(a) + bits_of(b);

    return (struct ratio){wide_quotient(a, b, places), places};
}

static struct ratio product(struct ratio a, struct ratio b)
{
    return (struct ratio){wide_round(wide_product(a.m, b.m), 60), a.places + b.places - 60};
}

/* Returns axis, Q1.62, times scale. */
static struct tia_eye_row scaled(const int64_t axis[3], struct ratio scale)
{
    struct tia_eye_row row = {.places = scale.places};

    for (int i = 0; i < 3; i++)
        row.m[i] = wide_round(wide_product(axis[i], scale.m), 62);
    return row;
}

/* Rounds a row to at most `places` fraction bits. */
static void coarsen(struct tia_eye_row *row, int places)
{
    for (int i = 0; i < 3 && places < row->places; i++)
        row->m[i] =
            row->places - places > 62 ? 0 : wide_round(wide_product(row->m[i], 1), (unsigned)(row->places - places));
    row->places = places < row->places ? places : row->places;
}

static struct tia_eye_row sum(struct tia_eye_row a, struct tia_eye_row b, bool subtract)
{
    int places = (a.places < b.places ? a.places : b.places) - 1;

    coarsen(&a, places);
    coarsen(&b, places);
    for (int i = 0; i < 3; i++)
        a.m[i] += subtract ? -b.m[i] : b.m[i];
    return a;
}

void tia_eye_across(const int64_t n[3], int64_t across[2][3])
{
    int64_t e[3] = {0, 0, 0}, aside[3];
    int least = 0;

    for (int k = 1; k < 3; k++)
        if ((n[k] < 0 ? -n[k] : n[k]) < (n[least] < 0 ? -n[least] : n[least]))
            least = k;
    e[least] = INT64_C(1) << 61;
    tia_axes_cross(e, n, aside);
    (void)wide_normalise(aside, across[0]);
    tia_axes_cross(n, across[0], across[1]);
}

void tia_eye_around(const int64_t a[3], const int64_t b[3], tia_q16 angle, int64_t direction[3])
{
    int64_t sine, cosine;

    tia_sincos(angle, &sine, &cosine);
    for (int k = 0; k < 3; k++)
        direction[k] = wide_round(wide_sum(wide_product(a[k], cosine), wide_product(b[k], sine)), 62);
}

/* Gives a position in Q31.32, with its fine digits unless `fine` is NULL. */
static void finely(struct tia_vec3 place, const struct tia_fine_place *fine, int64_t out[3])
{
    const tia_q16 at[3] = {place.x, place.y, place.z};
    const int digits[3] = {fine ? fine->x : 0, fine ? fine->y : 0, fine ? fine->z : 0};

    for (int i = 0; i < 3; i++)
        out[i] = at[i] * INT64_C(65536) + digits[i];
}

/* Returns a divided by the window's width. */
static struct ratio over_width(int64_t a, const struct tia_window *w, unsigned width, unsigned height)
{
    int64_t upward = (int64_t)w->top - w->bottom;

    if (w->left || w->right)
        return ratio(a, (int64_t)w->right - w->left);
    if (upward * width > (int64_t)height << 32)
        return ratio(a, INT64_C(1) << 32);
    return product(ratio(a, upward), ratio(height, width));
}

/* Returns 2 near/(high - low) axis + (high + low)/(high - low) n. */
static struct tia_eye_row sheared(const int64_t axis[3], struct ratio scale, const int64_t n[3], int64_t low,
                                  int64_t high)
{
    int64_t middle = high + low;
    struct tia_eye_row row = scaled(axis, scale);

    if (!middle)
        return row;
    return sum(row, scaled(n, ratio(middle < 0 ? -middle : middle, high - low)), middle < 0);
}

static void open_frustum(struct tia_eye *eye, const struct tia_window *w, int64_t axes[3][3], unsigned width,
                         unsigned height)
{
    int64_t twice = 2 * (int64_t)w->near;

    eye->row[0] = sheared(axes[0], over_width(twice, w, width, height), axes[2], w->left, w->right);
    eye->row[1] = sheared(axes[1], ratio(twice, (int64_t)w->top - w->bottom), axes[2], w->bottom, w->top);
}

/* Returns 2/(high - low) axis, less (high + low)/(high - low). */
static struct tia_eye_row shifted(const int64_t axis[3], struct ratio scale, int64_t low, int64_t high)
{
    int64_t middle = high + low;
    struct tia_eye_row row = scaled(axis, scale);

    if (!middle)
        return row;
    struct ratio offset = ratio(middle < 0 ? -middle : middle, high - low);
    row.offset = middle < 0 ? offset.m : -offset.m;
    row.offset_places = offset.places;
    return row;
}

static void open_window(struct tia_eye *eye, const struct tia_window *w, int64_t axes[3][3], unsigned width,
                        unsigned height)
{
    eye->row[0] = shifted(axes[0], over_width(INT32_C(2) << 16, w, width, height), w->left, w->right);
    eye->row[1] = shifted(axes[1], ratio(INT32_C(2) << 16, (int64_t)w->top - w->bottom), w->bottom, w->top);
}

static void open_perspective(struct tia_eye *eye, tia_q16 fov, int64_t axes[3][3], unsigned width, unsigned height)
{
    struct ratio cotangent = ratio((int64_t)(tia_cotangent(fov) >> 2), INT64_C(1) << 54);

    eye->row[0] = scaled(axes[0], product(cotangent, ratio(height, width)));
    eye->row[1] = scaled(axes[1], cotangent);
}

void tia_eye_init(struct tia_eye *eye, const struct tia_scene *scene, unsigned width, unsigned height)
{
    static const struct ratio one = {INT64_C(1) << 60, 60};
    const struct tia_camera *camera = &scene->camera;
    int64_t axes[3][3], at[3], reference[3], back[3];

    finely(camera->eye, scene->fine ? &scene->fine->eye : NULL, at);
    finely(camera->reference, scene->fine ? &scene->fine->reference : NULL, reference);
    for (int i = 0; i < 3; i++)
        back[i] = at[i] - reference[i];
    tia_camera_axes(axes, camera, back);
    eye->projection = camera->projection;
    for (int i = 0; i < 3; i++)
        eye->origin[i] = at[i];
    eye->row[2] = scaled(axes[2], one);
    if (camera->projection == TIA_ORTHOGRAPHIC)
        open_window(eye, &camera->window, axes, width, height);
    else if (camera->projection == TIA_FRUSTUM)
        open_frustum(eye, &camera->window, axes, width, height);
    else
        open_perspective(eye, camera->fov, axes, width, height);
    for (int i = 0; i < 3 && camera->projection != TIA_ORTHOGRAPHIC; i++)
        eye->row[2].m[i] = -eye->row[2].m[i];
}

/* ---- vertices ---- */

/* Returns the row's value at p, which is relative to the eye and Q31.32. The result has places + 32 fraction bits; the
 * offset has 15 to 48 fewer, see shifted. */
static wide at_point(const struct tia_eye_row *row, const int64_t p[3])
{
    wide sum = wide_dot(row->m, p);

    if (!row->offset)
        return sum;
    return wide_sum(sum, wide_up(wide_product(row->offset, 1), (unsigned)(row->places + 32 - row->offset_places)));
}

static void relative(const struct tia_eye *eye, const int64_t point[3], int64_t p[3])
{
    for (int i = 0; i < 3; i++)
        p[i] = point[i] - eye->origin[i];
}

unsigned tia_eye_range(const struct tia_eye *eye, const int64_t point[3])
{
    int most = 0;
    int64_t p[3];

    relative(eye, point, p);
    for (int i = 0; i < 3; i++) {
        int range = wide_bits(wide_size(at_point(&eye->row[i], p))) - eye->row[i].places - 32;
        most = range > most ? range : most;
    }
    return (unsigned)most;
}

void tia_eye_point(const struct tia_eye *eye, const int64_t point[3], int fraction, struct tia_raster_vertex *vertex)
{
    int64_t p[3], v[3];

    relative(eye, point, p);
    for (int i = 0; i < 3; i++)
        v[i] = wide_round(at_point(&eye->row[i], p), (unsigned)(eye->row[i].places + 32 - fraction));
    *vertex = eye->projection == TIA_ORTHOGRAPHIC ? (struct tia_raster_vertex){v[0], v[1], INT64_C(1) << fraction, v[2]}
                                                  : (struct tia_raster_vertex){v[0], v[1], v[2], 1};
}

void tia_eye_direction(const struct tia_eye *eye, const int64_t direction[3], int bits,
                       struct tia_raster_vertex *vertex)
{
    const int64_t half[3] = {direction[0] / 2, direction[1] / 2, direction[2] / 2}; /* halved to fit wide_dot */
    int64_t v[3];
    int places = INT16_MAX;

    for (int i = 0; i < 3; i++) {
        int size = wide_bits(wide_size(wide_dot(eye->row[i].m, half)));
        int room = eye->row[i].places + 61 - size + bits - 1; /* 2^room times the coordinate then has bits - 1 bits */
        places = size && room < places ? room : places;
    }
    for (int i = 0; i < 3; i++) {
        int shift = eye->row[i].places + 61 - places;
        v[i] = shift > 126 ? 0 : wide_round(wide_dot(eye->row[i].m, half), (unsigned)shift);
    }
    *vertex = eye->projection == TIA_ORTHOGRAPHIC ? (struct tia_raster_vertex){v[0], v[1], 0, v[2]}
                                                  : (struct tia_raster_vertex){v[0], v[1], v[2], 0};
}
