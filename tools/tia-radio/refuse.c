#include "refuse.h"

#include <stdarg.h>

#include "common/message.h"

int refuse(int status, const char *format, ...)
{
    va_list values;

    va_start(values, format);
    (void)message_list("tia-radio", status, format, values);
    va_end(values);
    return status;
}
