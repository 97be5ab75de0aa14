#include "fail.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include <tia/debug.h>
#include <tia/render.h>

#include "common/message.h"
#include "common/scene/scene_report.h"

/* The target of messages; text NULL: standard error. */
static struct {
    char *text;
    size_t size;
} into;

static const char *tool = "tia";

void fail_as(const char *name)
{
    tool = name;
}

void fail_into(char *text, size_t size)
{
    into.text = text;
    into.size = size;
}

static void say(const char *format, va_list values)
{
    if (into.text) {
        (void)vsnprintf(into.text, into.size, format, values);
        message_clean(into.text);
        return;
    }
    (void)fflush(stdout);
    (void)message_list(tool, 0, format, values);
}

int fail(int status, const char *format, ...)
{
    va_list values;
    va_start(values, format);
    say(format, values);
    va_end(values);
    return status;
}

int wrong(const char *option, const char *value, const char *rule)
{
    return fail(EXIT_USAGE, "%s '%.200s': %s", option, value, rule);
}

int fail_scene(int status, struct scene_file *file)
{
    if (!into.text)
        return scene_report_print(file, tool, status);
    scene_report_free(file);
    return fail(status, "%s", file->why);
}

int fail_output(void)
{
    return fail(EXIT_RUNNING, "standard output: %s", strerror(errno));
}

const char *fail_reason(int status)
{
    switch (status) {
    case TIA_ERR_MEMORY:
        return "memory: exhausted";
    case TIA_ERR_RANGE:
        return "scene: a value is out of range";
    case TIA_ERR_UNSUPPORTED:
        return "scene: this build draws no such scenes";
    default:
        return "display: failed";
    }
}

#define TOO_FAR "too far from the camera for so narrow a view"

/* Writes a reason that names a light too far away; false: there is none. */
static bool blame_light(char *why, size_t size, const struct fail_view *view)
{
    const struct tia_scene *scene = view->scene;
    unsigned range;
    uint32_t light =
        tia_shadow_light_too_far(scene, view->lights, view->light_count, view->width, view->height, &range);

    if (light == TIA_NO_OBJECT)
        light = tia_shadow_light_too_far(scene, scene->lights, scene->light_count, view->width, view->height, &range);
    if (light == TIA_NO_OBJECT)
        return false;
    (void)snprintf(why, size, "shadows %s: light %u: " TOO_FAR ": 2^%u times half of it, or more",
                   tia_shadows_name(scene->shadows), (unsigned)light, range);
    return true;
}

void fail_view_reason(char *why, size_t size, int status, const struct fail_view *view)
{
    const struct tia_scene *scene = view->scene;
    uint32_t object = status == TIA_ERR_RANGE ? tia_shadow_too_far(scene, view->width, view->height) : TIA_NO_OBJECT;
    bool sphere = object < scene->sphere_count;

    if (object != TIA_NO_OBJECT)
        (void)snprintf(why, size, "shadows %s: %s %u: " TOO_FAR, tia_shadows_name(scene->shadows),
                       sphere ? "sphere" : "shape", (unsigned)(sphere ? object : object - scene->sphere_count));
    else if (status != TIA_ERR_RANGE || !blame_light(why, size, view))
        (void)snprintf(why, size, "%s", fail_reason(status));
}

void note(const char *format, ...)
{
    va_list values;
    va_start(values, format);
    say(format, values);
    va_end(values);
}
