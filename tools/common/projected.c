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

/* A point in the camera's axes as a pixel, see tia/camera.h. */
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

bool projected_segment(const struct tia_camera *camera, unsigned width, unsigned height, struct tia_vec3 a,
                       struct tia_vec3 b, double ends[2][2])
{
    const double behind = camera->projection == TIA_ORTHOGRAPHIC ? 1e9 : -1e-3;
    struct axes axes = axes_of(camera);
    double d[3], p[2][3];

    for (int i = 0; i < 2; i++) {
        difference(i ? b : a, camera->eye, d);
        p[i][0] = dot(d, axes.u);
        p[i][1] = dot(d, axes.v);
        p[i][2] = dot(d, axes.n);
    }
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
