#include "stored_file.h"

#include <stdarg.h>
#include <stdio.h>

#include "common/regular.h"

int stored_failed(struct stored *s, const char *format, ...)
{
    va_list values;
    int used = snprintf(s->why, STORED_WHY, "%.300s: ", s->path);

    va_start(values, format);
    (void)vsnprintf(s->why + used, STORED_WHY - (size_t)used, format, values);
    va_end(values);
    return -1;
}

int stored_read_at(struct stored *s, void *bytes, size_t count, uint64_t offset)
{
    return regular_read(s->fd, bytes, count, offset) ? stored_failed(s, "%s", regular_reason()) : 0;
}
