#include "message.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

int message_list(const char *tool, int status, const char *format, va_list values)
{
    char text[1400]; /* the message; longer ones are cut */

    (void)vsnprintf(text, sizeof text, format, values);
    message_clean(text);
    (void)fprintf(stderr, "%s: %s\n", tool, text);
    return status;
}

int message(const char *tool, int status, const char *format, ...)
{
    va_list values;

    va_start(values, format);
    (void)message_list(tool, status, format, values);
    va_end(values);
    return status;
}

int message_why(const char *tool, int status, const char *what, const char *why)
{
    return message(tool, status, "%s%s%s", what, *why != '\0' ? ": " : "", why);
}

int message_output(const char *tool, const char *text)
{
    if (fputs(text, stdout) < 0 || fflush(stdout) != 0 || ferror(stdout))
        return message_why(tool, 1, "standard output", strerror(errno));
    return 0;
}
