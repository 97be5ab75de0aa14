#include "field_display.h"

#include <math.h>

/* Slack of comparisons: far more than the doubles' errors, and far less than a visible difference, so that halves are
 * rounded the same way on every machine. */
#define SLACK 0x1p-24

void display_init(struct display *display, const struct tia_scene *scene, unsigned views, const struct modules *modules)
{
    const struct tia_window *w = &scene->camera.window;
    double unit = ldexp(1, -16 - (int)scene->scale_bits);
    double middle = ((double)w->left + w->right) / 2 * unit, half = scene->camera.line * unit;

    *display = (struct display){.unit = unit,
                                .width = ((double)w->right - w->left) * unit,
                                .height = ((double)w->top - w->bottom) * unit,
                                .distance = w->near * unit,
                                .from = -half - middle,
                                .to = half - middle,
                                .count = modules ? modules->count : views,
                                .projects = modules != NULL,
                                .spacing = modules ? modules->spacing * unit : 0,
                                .behind = modules ? modules->distance * unit : 0};
}

static double rounded(double number)
{
    return floor(number + 0.5 + SLACK);
}

/* Returns the position, from the screen's middle, where the ray from the eye through q crosses the observer line's
 * plane. */
static double crossing(const struct display *d, const struct eye *eye, double q)
{
    return q + (eye->x - q) / eye->z * d->distance;
}

/* True if the ray from the eye through q crosses the observer line. The scene's lengths are rounded to units. So an end
 * of the line is off by up to half a unit, the screen's middle by another half if its width is odd, and the line's
 * distance by half a unit, which moves the crossing by half a unit times the ray's slope. `slack` is the sum of these.
 */
static bool on_line(const struct display *d, const struct eye *eye, double q)
{
    double at = crossing(d, eye, q), slack = d->unit * (1 + fabs((eye->x - q) / eye->z) / 2 + SLACK);

    return at >= d->from - slack && at <= d->to + slack;
}

double display_part(const struct display *display, const struct eye *eye, double point)
{
    const struct display *d = display;

    return (crossing(d, eye, (point - 0.5) * d->width) - d->from) / (d->to - d->from);
}

/* Returns -1 or 1 if the light of a module through the screen at q misses the line to its left or right, else 0. The
 * renderer rounds the crossing to units, so points up to a quarter of a unit beyond an end count as on the line. */
static int misses(const struct display *d, double module, double q)
{
    /* position as in modules_place */
    double p = floor(((2 * module - (d->count - 1)) * d->spacing / d->unit + 1) / 2) * d->unit;
    double s = q + (q - p) * d->distance / d->behind;

    return s > d->to + d->unit / 4 ? 1 : s < d->from - d->unit / 4 ? -1 : 0;
}

static double module_of(const struct display *d, const struct eye *eye, double q)
{
    double p = q - (eye->x - q) / eye->z * d->behind, module = rounded(p / d->spacing + (d->count - 1) / 2.0);

    return on_line(d, eye, q) ? module + misses(d, module, q) : module;
}

static double view_of(const struct display *d, const struct eye *eye, double q)
{
    double part = (crossing(d, eye, q) - d->from) / (d->to - d->from);

    return on_line(d, eye, q) ? fmin(fmax(rounded(part * (d->count - 1)), 0), d->count - 1.0) : -1;
}

int display_picture(const struct display *display, const struct eye *eye, unsigned column, unsigned columns)
{
    const struct display *d = display;
    double q = ((2.0 * column + 1) / (2.0 * columns) - 0.5) * d->width;
    double picture = d->projects ? module_of(d, eye, q) : view_of(d, eye, q);

    return picture >= 0 && picture < d->count ? (int)picture : -1;
}
