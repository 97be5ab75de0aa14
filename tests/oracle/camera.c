/* camera.c - the rays of a picture. */
#include "rays.h"

/* The camera's axes: u to the right, v upwards, n towards the eye. */
struct frame {
    struct oracle_vec u, v, n;
};

static struct frame frame_of(const struct tia_camera *camera, const struct tia_fine *fine)
{
    struct oracle_vec up = position(camera->up);
    struct frame f = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

    if (length(up) > 0) {
        f.n = unit(sub(finely(camera->eye, fine ? &fine->eye : NULL),
                       finely(camera->reference, fine ? &fine->reference : NULL)));
        f.u = unit(cross(up, f.n));
        f.v = cross(f.n, f.u);
    }
    return f;
}

/* Returns the point of the window at (x, y) of the image, in the camera's axes. Its z is the window's distance, or 0 if
 * the camera is orthographic. */
static struct oracle_vec window_point(const struct tia_camera *camera, double w, double h, double x, double y)
{
    const struct tia_window *window = &camera->window;
    double a = tan(radians(camera->fov) / 2.0);
    double left = q16(window->left), right = q16(window->right);
    double bottom = q16(window->bottom), top = q16(window->top);

    if (camera->projection == TIA_PERSPECTIVE)
        return (struct oracle_vec){(2.0 * x / w - 1.0) * a * w / h, (1.0 - 2.0 * y / h) * a, 1.0};
    if (window->left == 0 && window->right == 0) {
        right = (top - bottom) / 2.0 * w / h;
        left = -right;
    }
    return (struct oracle_vec){left + (right - left) * x / w, top - (top - bottom) * y / h,
                               camera->projection == TIA_FRUSTUM ? q16(window->near) : 0.0};
}

struct ray oracle_camera(const struct tia_camera *camera, const struct tia_fine *fine, unsigned width, unsigned height,
                         double x, double y)
{
    struct frame f = frame_of(camera, fine);
    struct oracle_vec p = window_point(camera, width, height, x, y),
                      eye = finely(camera->eye, fine ? &fine->eye : NULL);
    struct oracle_vec aside = along(scaled(f.u, p.x), p.y, f.v);

    if (camera->projection == TIA_ORTHOGRAPHIC)
        return (struct ray){along(eye, 1, aside), scaled(f.n, -1)};
    return (struct ray){eye, unit(along(aside, -p.z, f.n))};
}

void oracle_sample(unsigned samples, unsigned number, double *x, double *y)
{
    unsigned side = samples == 16 ? 4 : samples == 4 ? 2 : 1;
    double n = side, i = number % side, j = number / side;

    *x = (i + (j + 0.5) / n) / n;
    *y = (j + (n - i - 0.5) / n) / n;
}
