#include "fail.h"

#include <stdarg.h>
#include <stdio.h>

#include "common/message.h"

int refuse(int status, const char *format, ...)
{
    char text[MESSAGE_SIZE];
    va_list arguments;

    va_start(arguments, format);
    (void)vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    return message("tia-radio", status, "%s", text);
}
