#include "projected.h"

#include <math.h>

struct axes {
    double u[3], v[3], n[3];
};

static void cross(const double a[3], const double b[3], double c[3])
{
    for (int i = 0; i < 3; i++)
        c[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

static void normalise(double a[3])
{
    double length = sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);

    for (int i = 0; i < 3; i++)
        a[i] /= length;
}

static void difference(struct tia_vec3 a, struct tia_vec3 b, double d[3])
{
    d[0] = ((double)a.x - b.x) / 65536;
    d[1] = ((double)a.y - b.y) / 65536;
    d[2] = ((double)a.z - b.z) / 65536;
}

static struct axes axes_of(const struct tia_camera *camera)
{
    struct axes axes = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    double up[3] = {camera->up.x, camera->up.y, camera->up.z};

    if (camera->up.x == 0 && camera->up.y == 0 && camera->up.z == 0)
        return axes;
    difference(camera->eye, camera->reference, axes.n);
    normalise(axes.n);
    cross(up, axes.n, axes.u);
    normalise(axes.u);
    cross(axes.n, axes.u, axes.v);
    return axes;
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Converts a point in the camera's axes to a pixel, see tia/camera.h. */
static void place(const struct tia_camera *camera, unsigned width, unsigned height, const double p[3], double at[2])
{
    const struct tia_window *w = &camera->window;
    double aspect = (double)width / height, near = camera->projection == TIA_FRUSTUM ? w->near / 65536.0 : 1;
    double bottom = w->bottom / 65536.0, top = w->top / 65536.0, left = w->left / 65536.0, right = w->right / 65536.0;
    double scale = camera->projection == TIA_ORTHOGRAPHIC ? 1 : near / -p[2];

    if (camera->projection == TIA_PERSPECTIVE) {
        top = tan(camera->fov / 65536.0 * 3.14159265358979324 / 360);
        bottom = -top;
        left = right = 0;
    }
    if (left == 0 && right == 0) {
        right = (top - bottom) / 2 * aspect;
        left = -right;
    }
    at[0] = (p[0] * scale - left) / (right - left) * width - 0.5;
    at[1] = (top - p[1] * scale) / (top - bottom) * height - 0.5;
}

/* Converts a point to the camera's axes. */
static void see(const struct tia_camera *camera, const struct axes *axes, struct tia_vec3 point, double p[3])
{
    double d[3];

    difference(point, camera->eye, d);
    p[0] = dot(d, axes->u);
    p[1] = dot(d, axes->v);
    p[2] = dot(d, axes->n);
}

bool projected_segment(const struct tia_camera *camera, unsigned width, unsigned height, struct tia_vec3 a,
                       struct tia_vec3 b, double ends[2][2])
{
    const double behind = camera->projection == TIA_ORTHOGRAPHIC ? 1e9 : -1e-3;
    struct axes axes = axes_of(camera);
    double p[2][3];

    for (int i = 0; i < 2; i++)
        see(camera, &axes, i ? b : a, p[i]);
    if (p[0][2] > behind && p[1][2] > behind)
        return false;
    for (int i = 0; i < 2; i++)
        if (p[i][2] > behind) {
            double t = (behind - p[i][2]) / (p[1 - i][2] - p[i][2]);
            for (int c = 0; c < 3; c++)
                p[i][c] += t * (p[1 - i][c] - p[i][c]);
        }
    place(camera, width, height, p[0], ends[0]);
    place(camera, width, height, p[1], ends[1]);
    return true;
}

/* Returns the width of a pixel at the point p. */
static double length_of_pixel(const struct tia_camera *camera, unsigned width, unsigned height, const double p[3])
{
    double at[2], next[2], beside[3] = {p[0] + 1, p[1], p[2]};

    if (camera->projection == TIA_ORTHOGRAPHIC || p[2] < -1e-3) {
        place(camera, width, height, p, at);
        place(camera, width, height, beside, next);
        if (at[0] >= 0 && at[0] < width && at[1] >= 0 && at[1] < height)
            return 1 / (next[0] - at[0]);
    }
    return 2 * sqrt(dot(p, p)) / width;
}

static tia_q16 moved(tia_q16 from, double by)
{
    return (tia_q16)fmin(fmax(from + by * 65536, INT32_MIN), INT32_MAX);
}

struct tia_vec3 projected_dragged(const struct tia_camera *camera, unsigned width, unsigned height,
                                  struct tia_vec3 point, double right, double down)
{
    struct axes axes = axes_of(camera);
    double p[3], by[3];

    see(camera, &axes, point, p);
    double pixel = length_of_pixel(camera, width, height, p);
    for (int i = 0; i < 3; i++)
        by[i] = pixel * (right * axes.u[i] - down * axes.v[i]);
    return (struct tia_vec3){moved(point.x, by[0]), moved(point.y, by[1]), moved(point.z, by[2])};
}
