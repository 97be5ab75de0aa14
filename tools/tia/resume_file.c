#include "resume_file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "ports.h"

int kept_failed(const struct kept *kept, const char *reason)
{
    (void)snprintf(kept->why, PORT_WHY, "%.150s: %s", kept->path, reason);
    return TIA_ERR_DEVICE;
}

int kept_refused(const struct kept *kept, const char *reason)
{
    (void)kept_failed(kept, reason);
    return TIA_ERR_RANGE;
}

int kept_open(struct kept *kept, const char *path, uint64_t *size, char *why)
{
    struct stat status;

    *kept = (struct kept){.path = path, .why = why};
    kept->fd = open(path, O_RDWR | O_CREAT | O_NONBLOCK | O_CLOEXEC | O_NOCTTY, 0666);
    if (kept->fd < 0 || fstat(kept->fd, &status) != 0)
        return kept_failed(kept, strerror(errno));
    if (!S_ISREG(status.st_mode))
        return kept_failed(kept, "not a regular file");
    if (flock(kept->fd, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) /* some file systems have no locks */
        return kept_failed(kept, "another run uses it");
    *size = (uint64_t)status.st_size;
    return TIA_OK;
}

void kept_close(struct kept *kept)
{
    if (kept->path && kept->fd >= 0)
        (void)close(kept->fd);
    *kept = (struct kept){0};
}

int kept_read(const struct kept *kept, void *bytes, size_t length, uint64_t at, size_t *got)
{
    for (*got = 0; *got < length;) {
        ssize_t more = pread(kept->fd, (char *)bytes + *got, length - *got, (off_t)(at + *got));
        if (more == 0)
            break;
        if (more < 0 && errno != EINTR)
            return kept_failed(kept, strerror(errno));
        *got += more > 0 ? (size_t)more : 0;
    }
    return TIA_OK;
}

int kept_write(const struct kept *kept, const void *bytes, size_t length, uint64_t at)
{
    for (size_t done = 0; done < length;) {
        ssize_t wrote = pwrite(kept->fd, (const char *)bytes + done, length - done, (off_t)(at + done));
        if (wrote < 0 && errno == EINTR)
            continue;
        if (wrote < 0)
            return kept_failed(kept, strerror(errno));
        done += (size_t)wrote;
    }
    return TIA_OK;
}

int kept_cut(const struct kept *kept, uint64_t size)
{
    return ftruncate(kept->fd, (off_t)size) == 0 ? TIA_OK : kept_failed(kept, strerror(errno));
}
