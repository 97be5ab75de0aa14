#include "regular.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <unistd.h>

int regular_open(const char *path, struct stat *status)
{
    int fd = open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);

    if (fd < 0)
        return -1;
    int result = fstat(fd, status);
    if (!result && S_ISREG(status->st_mode))
        return fd;
    int why = result ? errno : EINVAL;
    (void)close(fd);
    errno = why;
    return -1;
}

int regular_read(int fd, void *bytes, size_t count, uint64_t offset)
{
    for (size_t done = 0; done < count;) {
        ssize_t got = pread(fd, (char *)bytes + done, count - done, (off_t)(offset + done));
        if (got < 0 && errno == EINTR)
            continue;
        if (got == 0)
            errno = 0;
        if (got <= 0)
            return -1;
        done += (size_t)got;
    }
    return 0;
}

const char *regular_reason(void)
{
    return errno == 0 ? "ends too early" : errno == EINVAL ? "not a regular file" : strerror(errno);
}
