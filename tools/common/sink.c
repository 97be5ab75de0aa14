#include "sink.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "ports.h"

/* Keeps the reason of the first failure, since it causes the later ones. */
static int fail(struct sink *sink, int error)
{
    if (!sink->failed) {
        (void)snprintf(sink->why, PORT_WHY, "%.180s: %s", sink->name, strerror(error));
    }
    sink->failed = true;
    return TIA_ERR_DEVICE;
}

/* Creates a file with an unused name in the directory of `path`. A short name, because the file system may not accept
 * one longer than that of `path`. */
static int create_beside(struct sink *sink)
{
    const char *slash = strrchr(sink->path, '/');
    int directory = slash != NULL ? (int)(slash + 1 - sink->path) : 0;
    for (unsigned attempt = 0; attempt < 100; attempt++) {
        if (asprintf(&sink->temporary, "%.*s.tia-%ld-%u", directory, sink->path, (long)getpid(), attempt) < 0) {
            sink->temporary = NULL;
            return fail(sink, ENOMEM);
        }
        sink->fd = open(sink->temporary, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOCTTY, 0666);
        if (sink->fd >= 0) {
            return TIA_OK;
        }
        int error = errno;
        free(sink->temporary);
        sink->temporary = NULL;
        if (error != EEXIST) {
            return fail(sink, error);
        }
    }
    return fail(sink, EEXIST);
}

static int open_directly(struct sink *sink)
{
    sink->fd = open(sink->name, O_WRONLY | O_CLOEXEC | O_NOCTTY);
    return sink->fd >= 0 ? TIA_OK : fail(sink, errno);
}

/* Finds the final path. A symbolic link stays a link: the file that it points to is replaced. */
static int find_path(struct sink *sink, bool exists)
{
    sink->path = exists ? realpath(sink->name, NULL) : strdup(sink->name);
    if (sink->path == NULL) {
        return fail(sink, errno);
    }
    if (exists && access(sink->path, W_OK) != 0) {
        return fail(sink, errno);
    }
    return TIA_OK;
}

static int open_file(struct sink *sink)
{
    struct stat status;
    bool exists = stat(sink->name, &status) == 0;
    if (!exists && errno != ENOENT) {
        return fail(sink, errno);
    }
    if (exists && S_ISDIR(status.st_mode)) {
        return fail(sink, EISDIR);
    }
    if (exists && !S_ISREG(status.st_mode)) {
        return open_directly(sink);
    }
    int result = find_path(sink, exists);
    return result == TIA_OK ? create_beside(sink) : result;
}

int sink_open(struct sink *sink, const char *name, char *why)
{
    *sink = (struct sink){.fd = -1, .name = name, .why = why};
    int result;
    if (strcmp(name, "-") == 0) {
        sink->name = "standard output";
        sink->fd = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 0);
        result = sink->fd >= 0 ? TIA_OK : fail(sink, errno);
    } else {
        result = open_file(sink);
    }
    if (result != TIA_OK) {
        sink_discard(sink);
    }
    return result;
}

static int drain(struct sink *sink)
{
    for (size_t done = 0; done < sink->used;) {
        ssize_t wrote = write(sink->fd, sink->buffer + done, sink->used - done);
        if (wrote > 0) {
            done += (size_t)wrote;
        } else if (wrote == 0 || errno != EINTR) {
            return fail(sink, wrote == 0 ? EIO : errno);
        }
    }
    sink->used = 0;
    return TIA_OK;
}

int sink_write(struct sink *sink, const void *bytes, size_t count)
{
    const unsigned char *from = bytes;
    while (count > 0 && !sink->failed) {
        size_t room = sizeof sink->buffer - sink->used;
        size_t now = count < room ? count : room;
        memcpy(sink->buffer + sink->used, from, now);
        sink->used += now;
        from += now;
        count -= now;
        if (sink->used == sizeof sink->buffer) {
            (void)drain(sink);
        }
    }
    return sink->failed ? TIA_ERR_DEVICE : TIA_OK;
}

int sink_commit(struct sink *sink)
{
    if (!sink->failed) {
        (void)drain(sink);
    }
    /* Without fsync, the system may report a full disk only after the rename, and a crash may leave an empty file.
     * Only for regular files: pipes and devices refuse it. */
    if (!sink->failed && sink->temporary != NULL && fsync(sink->fd) != 0) {
        (void)fail(sink, errno);
    }
    if (close(sink->fd) != 0 && !sink->failed) {
        (void)fail(sink, errno);
    }
    sink->fd = -1;
    if (!sink->failed && sink->temporary != NULL && rename(sink->temporary, sink->path) != 0) {
        (void)fail(sink, errno);
    }
    if (!sink->failed) {
        free(sink->temporary);
        sink->temporary = NULL;
    }
    sink_discard(sink);
    return sink->failed ? TIA_ERR_DEVICE : TIA_OK;
}

void sink_discard(struct sink *sink)
{
    if (sink->fd >= 0) {
        (void)close(sink->fd);
        sink->fd = -1;
    }
    if (sink->temporary != NULL) {
        (void)unlink(sink->temporary);
    }
    free(sink->temporary);
    free(sink->path);
    sink->temporary = sink->path = NULL;
}
