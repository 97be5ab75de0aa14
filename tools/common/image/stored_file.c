#include "stored_file.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

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
    for (size_t done = 0; done < count;) {
        ssize_t got = pread(s->fd, (char *)bytes + done, count - done, (off_t)(offset + done));
        if (got < 0 && errno == EINTR)
            continue;
        if (got <= 0)
            return stored_failed(s, "%s", got == 0 ? "ends too early" : strerror(errno));
        done += (size_t)got;
    }
    return 0;
}
