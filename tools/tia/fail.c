#include "fail.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include <tia/fixed.h>

static void say(const char *format, va_list values)
{
    char text[1024];
    (void)vsnprintf(text, sizeof text, format, values);
    for (char *at = text; *at != '\0'; at++)
        if ((unsigned char)*at < ' ' || *at == 127)
            *at = '?';
    (void)fflush(stdout);
    (void)fprintf(stderr, "tia: %s\n", text);
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

void note(const char *format, ...)
{
    va_list values;
    va_start(values, format);
    say(format, values);
    va_end(values);
}
