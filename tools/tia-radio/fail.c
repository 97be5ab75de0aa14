#include "fail.h"

#include <stdarg.h>
#include <stdio.h>

int refuse(int status, const char *format, ...)
{
    char text[1400];
    va_list arguments;

    va_start(arguments, format);
    (void)vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    for (char *at = text; *at != '\0'; at++)
        if ((unsigned char)*at < ' ' || *at == 127)
            *at = '?';
    (void)fprintf(stderr, "tia-radio: %s\n", text);
    return status;
}
