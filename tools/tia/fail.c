#include "fail.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include <tia/render.h>

#include "common/message.h"

/* Where messages go instead of standard error. */
static struct {
    char *text;
    size_t size;
} into;

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
    (void)message_list("tia", 0, format, values);
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

void fail_view_reason(char *why, size_t size, int status, const struct tia_scene *scene, unsigned width,
                      unsigned height)
{
    uint32_t object = status == TIA_ERR_RANGE ? tia_shadow_too_far(scene, width, height) : TIA_NO_OBJECT;
    bool sphere = object < scene->sphere_count;
    if (object == TIA_NO_OBJECT) {
        (void)snprintf(why, size, "%s", fail_reason(status));
        return;
    }
    (void)snprintf(why, size, "shadows %s: %s %u: too far from the camera for so narrow a view",
                   tia_shadows_name(scene->shadows), sphere ? "sphere" : "shape",
                   (unsigned)(sphere ? object : object - scene->sphere_count));
}

void note(const char *format, ...)
{
    va_list values;
    va_start(values, format);
    say(format, values);
    va_end(values);
}
