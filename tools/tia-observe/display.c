#include "display.h"

#include <math.h>

/* Far more than the doubles' errors, and far less than matters: halves go to the right on every machine. */
#define SLACK 0x1p-24

void display_init(struct display *display, const struct tia_scene *scene, unsigned views, const struct modules *modules)
{
    const struct tia_window *w = &scene->camera.window;
    double unit = ldexp(1, -16 - (int)scene->scale_bits);
    double middle = ((double)w->left + w->right) / 2 * unit, half = scene->camera.line * unit;

    *display = (struct display){.width = ((double)w->right - w->left) * unit,
                                .height = ((double)w->top - w->bottom) * unit,
                                .distance = w->near * unit,
                                .from = -half - middle,
                                .to = half - middle,
                                .count = modules ? modules->count : views,
                                .projects = modules != NULL,
                                .spacing = modules ? modules->spacing * unit : 0,
                                .behind = modules ? modules->distance * unit : 0};
}

static int nearest(double number, unsigned count)
{
    double rounded = floor(number + 0.5 + SLACK);

    return rounded >= 0 && rounded < count ? (int)rounded : -1;
}

double display_part(const struct display *display, const struct eye *eye, double point)
{
    const struct display *d = display;
    double q = (point - 0.5) * d->width;

    return (q + (eye->x - q) / eye->z * d->distance - d->from) / (d->to - d->from);
}

int display_picture(const struct display *display, const struct eye *eye, unsigned column, unsigned columns)
{
    const struct display *d = display;
    double point = (2.0 * column + 1) / (2.0 * columns);

    if (d->projects) {
        double q = (point - 0.5) * d->width;
        double p = q - (eye->x - q) / eye->z * d->behind;
        return nearest(p / d->spacing + (d->count - 1) / 2.0, d->count);
    }
    double part = display_part(d, eye, point);
    return part < -SLACK || part > 1 + SLACK ? -1 : nearest(part * (d->count - 1), d->count);
}
