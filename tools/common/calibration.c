/* calibration.c - reads visual.json, the calibration stored in a Looking Glass. A value is a number, or an object whose
 * "value" is a number.
 *
 * Looking Glass Factory's published shader HoloPlayCore uses two numbers: pitch', the number of lenses in the picture's
 * width, and tilt, the phase gained over the picture's height divided by pitch':
 *
 *     pitch' = pitch screenW/DPI cos(atan(1/slope)),   tilt = screenH/(screenW slope), negated if flipImageX */
#include <math.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>

#include <tia/render.h>

#include "lenticular.h"

__attribute__((format(printf, 3, 4))) static int fail(struct lenticular *panel, int status, const char *format, ...)
{
    va_list values;
    va_start(values, format);
    (void)vsnprintf(panel->why, sizeof panel->why, format, values);
    va_end(values);
    return status;
}

#ifdef TIA_HAVE_JANSSON

#include <jansson.h>

struct values {
    double pitch, slope, center, dpi, width, height, inv_view, flip_x, flip_subp, pattern;
};

static const struct {
    const char *name;
    size_t offset;
    bool needed;
} names[] = {{"pitch", offsetof(struct values, pitch), true},
             {"slope", offsetof(struct values, slope), true},
             {"center", offsetof(struct values, center), true},
             {"DPI", offsetof(struct values, dpi), true},
             {"screenW", offsetof(struct values, width), true},
             {"screenH", offsetof(struct values, height), true},
             {"invView", offsetof(struct values, inv_view), false},
             {"flipImageX", offsetof(struct values, flip_x), false},
             {"flipSubp", offsetof(struct values, flip_subp), false},
             {"CellPatternMode", offsetof(struct values, pattern), false}};

static int read_values(struct lenticular *panel, const char *path, const json_t *root, struct values *v)
{
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        const json_t *item = json_object_get(root, names[i].name);
        const json_t *value = json_is_object(item) ? json_object_get(item, "value") : item;
        if (!item && !names[i].needed)
            continue;
        if (!json_is_number(value))
            return fail(panel, TIA_ERR_RANGE, "%.200s: %s: %s", path, names[i].name,
                        item ? "is not a number" : "is missing");
        *(double *)(void *)((char *)v + names[i].offset) = json_number_value(value);
    }
    return TIA_OK;
}

static bool is_size(double n)
{
    return n >= 1 && n <= TIA_SIZE_MAX && n == floor(n);
}

/* Computes the lens, one operation per statement so that no compiler fuses two: the result is the same on all
 * machines. */
static bool set_lens(struct tia_lenticular *lens, const struct values *v)
{
    double square = v->slope * v->slope;
    double hypotenuse = sqrt(1 + square);
    double cosine = fabs(v->slope) / hypotenuse;
    double inches = v->width / v->dpi;
    double pitch = v->pitch * inches;
    pitch = pitch * cosine;
    double rise = pitch / v->slope;

    lens->inverted = v->inv_view != 0;
    lens->subpixels = v->flip_subp != 0 ? TIA_SUBPIXELS_BGR : TIA_SUBPIXELS_RGB;
    return lenticular_set(lens, pitch, v->flip_x != 0 ? -rise : rise, v->center);
}

static int take(struct lenticular *panel, const char *path, const json_t *root)
{
    struct values v = {0};
    int status = json_is_object(root) ? read_values(panel, path, root, &v)
                                      : fail(panel, TIA_ERR_RANGE, "%.200s: no object", path);

    if (status)
        return status;
    if (!is_size(v.width) || !is_size(v.height))
        return fail(panel, TIA_ERR_RANGE, "%.200s: screenW, screenH: not whole numbers from 1 to %u", path,
                    TIA_SIZE_MAX);
    if (!(v.dpi > 0) || v.slope == 0)
        return fail(panel, TIA_ERR_RANGE, "%.200s: %s", path, v.slope == 0 ? "slope: is 0" : "DPI: not above 0");
    if (v.pattern != 0)
        return fail(panel, TIA_ERR_RANGE, "%.200s: CellPatternMode: only 0, rows of red, green and blue, is known",
                    path);
    panel->width = (uint16_t)v.width;
    panel->height = (uint16_t)v.height;
    if (!set_lens(&panel->lens, &v))
        return fail(panel, TIA_ERR_RANGE, "%.200s: pitch, slope, center: beyond 1048576 lenses, or none", path);
    return TIA_OK;
}

int calibration_read(struct lenticular *panel, const char *path)
{
    json_error_t error;

    *panel = (struct lenticular){.width = 0};
    json_t *root = json_load_file(path, JSON_REJECT_DUPLICATES, &error);

    if (!root && error.line < 0)
        return fail(panel, TIA_ERR_DEVICE, "%.200s", error.text);
    if (!root)
        return fail(panel, TIA_ERR_RANGE, "%.200s:%d:%d: %.200s", path, error.line, error.column, error.text);
    int status = take(panel, path, root);
    json_decref(root);
    return status;
}

#else

int calibration_read(struct lenticular *panel, const char *path)
{
    return fail(panel, TIA_ERR_RANGE, "%.200s: this build reads no .json (make deps has jansson, or use --lenticular)",
                path);
}

#endif
