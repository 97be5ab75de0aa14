#include "message.h"

#include <errno.h>
#include <getopt.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

void message_clean(char *text)
{
    for (char *at = text; *at != '\0'; at++)
        if ((unsigned char)*at < ' ' || *at == 127)
            *at = '?';
}

int message_list(const char *tool, int status, const char *format, va_list values)
{
    char text[1400]; /* longer messages are cut */

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

int message_option(const char *tool, int option, char **argv)
{
    const char letter[] = {'-', (char)optopt, '\0'};
    bool is_short = optopt > 0 && optopt < 256 && strncmp(argv[optind - 1], "--", 2) != 0;
    const char *name = is_short ? letter : argv[optind - 1];

    if (option == ':')
        return message(tool, 2, "%.200s: a value is missing (%s -h shows which)", name, tool);
    if (!is_short && optopt != 0)
        return message(tool, 2, "%.200s: takes no value", name);
    return message(tool, 2, "%.200s: unknown option (%s -h lists them)", name, tool);
}

int message_output(const char *tool, const char *text)
{
    if (fputs(text, stdout) < 0 || fflush(stdout) != 0)
        return message_why(tool, 1, "standard output", strerror(errno));
    return 0;
}
