#include "scene_report.h"

#include <stdio.h>
#include <string.h>

#include "common/message.h"

int scene_report_print(struct scene_file *file, const char *tool, int status)
{
    if (!file->report)
        return message(tool, status, "%s", file->why);
    (void)fflush(stdout);
    for (const char *line = file->report; *line != '\0';) {
        int length = (int)strcspn(line, "\n");
        (void)fprintf(stderr, "%s%s%.*s\n", *line == ' ' ? "" : tool, *line == ' ' ? "" : ": ", length, line);
        line += length + 1;
    }
    scene_report_free(file);
    return status;
}
