#include "modules.h"

#include <stdlib.h>
#include <string.h>

#include "parse.h"

/* Parses "distance=0.5". */
static bool set_length(const char *field, const char *name, int scale_bits, tia_q16 *length)
{
    size_t size = strlen(name);

    return strncmp(field, name, size) == 0 && field[size] == '=' &&
           parse_scaled(field + size + 1, scale_bits, length) && *length > 0;
}

/* Returns the default spacing, rounded up. A ray to the end s of the observer line through an edge q of the screen
 * comes from q + (q - s) d/D on the modules' row, which is at most w/2 + (w/2 + |s|) d/D from the middle. Here w is the
 * screen's width, d the modules' distance, D the line's distance, and s the end of the line that is farther from the
 * middle. */
static int64_t default_spacing(const struct tia_camera *camera, const struct modules *modules)
{
    int64_t screen = (int64_t)camera->window.right - camera->window.left;
    int64_t middle = (int64_t)camera->window.left + camera->window.right;
    int64_t farthest = 2 * (int64_t)camera->line + (middle < 0 ? -middle : middle);
    double reach = (double)(screen + farthest) * modules->distance / camera->window.near;

    return (screen + (int64_t)reach) / modules->count + 1;
}

static bool set_fields(struct modules *modules, const char *text, int bits)
{
    char *copy = strdup(text), *left = copy, *field;
    bool good = copy != NULL;

    while (good && (field = strsep(&left, ",")) != NULL)
        good = set_length(field, "distance", bits, &modules->distance) ||
               set_length(field, "spacing", bits, &modules->spacing);
    free(copy);
    return good;
}

const char *modules_parse(struct modules *modules, const char *text, const struct tia_scene *scene)
{
    const struct tia_camera *camera = &scene->camera;
    const char *rest;

    modules->distance = camera->window.near > 1 ? camera->window.near / 2 : 1;
    modules->spacing = 0;
    if (!parse_number(text, &rest, 1, MODULES_MAX, &modules->count) || (*rest != '\0' && *rest != ','))
        return "not a number from 1 to 65536 (32,distance=0.5,spacing=0.02)";
    if (*rest && !set_fields(modules, rest + 1, scene->scale_bits))
        return "not distance=L or spacing=L, lengths above 0 (32,distance=0.5,spacing=0.02)";
    int64_t spacing = modules->spacing ? modules->spacing : default_spacing(camera, modules);
    modules->spacing = spacing < INT32_MAX ? (tia_q16)spacing : INT32_MAX;
    return (int64_t)modules->spacing * modules->count / 2 > INT32_MAX
               ? "farther from the screen's middle than 32768 of the scene's finest units"
               : NULL;
}

tia_q16 modules_place(uint32_t module, uint32_t count, tia_q16 spacing)
{
    int64_t twice = (2 * (int64_t)module - (count - 1)) * spacing;

    return (tia_q16)((twice + 1) >> 1);
}
