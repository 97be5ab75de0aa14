#include "sink.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "inputs.h"
#include "ports.h"

/* Stores the reason of the first failure, since the first causes the later ones. */
static int refuse(struct sink *sink, const char *reason)
{
    if (!sink->failed)
        (void)snprintf(sink->why, PORT_WHY, "%.180s: %s", sink->name, reason);
    sink->failed = true;
    return TIA_ERR_DEVICE;
}

static int fail(struct sink *sink, int error)
{
    return refuse(sink, strerror(error));
}

static int open_directly(struct sink *sink)
{
    sink->fd = open(sink->name, O_WRONLY | O_CLOEXEC | O_NOCTTY);
    return sink->fd >= 0 ? TIA_OK : fail(sink, errno);
}

/* Opens a temporary file. A symbolic link stays a link: the file that it points to is replaced, or created. */
static int open_beside(struct sink *sink, const struct stat *before)
{
    sink->path = temporary_target(sink->name);
    if (!sink->path || (before && access(sink->path, W_OK) != 0))
        return fail(sink, errno);
    sink->fd = temporary_create(&sink->temporary, sink->path, before);
    return sink->fd >= 0 ? TIA_OK : fail(sink, errno);
}

static int open_file(struct sink *sink)
{
    struct stat status;
    bool exists = stat(sink->name, &status) == 0;
    if (!exists && errno != ENOENT)
        return fail(sink, errno);
    if (exists && S_ISDIR(status.st_mode))
        return fail(sink, EISDIR);
    if (exists && !S_ISREG(status.st_mode))
        return open_directly(sink);
    if (exists && inputs_have(&status))
        return refuse(sink, "it is one of the files read (choose another name)");
    return open_beside(sink, exists ? &status : NULL);
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
    if (result)
        sink_discard(sink);
    return result;
}

static int drain(struct sink *sink)
{
    for (size_t done = 0; done < sink->used;) {
        ssize_t wrote = write(sink->fd, sink->buffer + done, sink->used - done);
        if (wrote > 0)
            done += (size_t)wrote;
        else if (wrote == 0 || errno != EINTR)
            return fail(sink, wrote == 0 ? EIO : errno);
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
        if (sink->used == sizeof sink->buffer)
            (void)drain(sink);
    }
    return sink->failed ? TIA_ERR_DEVICE : TIA_OK;
}

/* Without fsync, the system may report a full disk only after the rename, and a crash may leave an empty file. Only
 * regular files support fsync; pipes and devices may report a failure when they are closed. A regular file stays open
 * until it is renamed, as closing it would release the lock. */
int sink_seal(struct sink *sink)
{
    if (!sink->failed)
        (void)drain(sink);
    if (!sink->failed && sink->temporary.name && fsync(sink->fd) != 0)
        (void)fail(sink, errno);
    if (!sink->temporary.name) {
        if (close(sink->fd) != 0 && !sink->failed)
            (void)fail(sink, errno);
        sink->fd = -1;
    }
    if (sink->failed) {
        sink_discard(sink);
        return TIA_ERR_DEVICE;
    }
    return TIA_OK;
}

int sink_publish(struct sink *sink)
{
    if (sink->temporary.name && temporary_rename(&sink->temporary, sink->path) != 0)
        (void)fail(sink, errno);
    sink_discard(sink);
    return sink->failed ? TIA_ERR_DEVICE : TIA_OK;
}

int sink_commit(struct sink *sink)
{
    int status = sink_seal(sink);
    return !status ? sink_publish(sink) : status;
}

/* Removes the file before closing it, so that no file without a lock is ever left over. */
void sink_discard(struct sink *sink)
{
    temporary_remove(&sink->temporary);
    if (sink->fd >= 0) {
        (void)close(sink->fd);
        sink->fd = -1;
    }
    free(sink->path);
    sink->path = NULL;
}

/* Returns the path of the file that a sink of this name replaces, without symbolic links, to be freed by free(). NULL
 * if its directory is not there, or memory is short. */
static char *replaced_by(const char *name)
{
    char *target = temporary_target(name), *full = NULL;
    char *slash = target ? strrchr(target, '/') : NULL;
    const char *last = slash ? slash + 1 : target;

    if (slash)
        *slash = '\0';
    char *folder = target ? realpath(!slash ? "." : slash == target ? "/" : target, NULL) : NULL;
    if (folder && asprintf(&full, "%s/%s", folder, last) < 0)
        full = NULL;
    free(folder);
    free(target);
    return full;
}

bool sink_is_same(const char *a, const char *b)
{
    struct stat one, other;

    if (!a || !b || strcmp(a, "-") == 0 || strcmp(b, "-") == 0)
        return false;
    if (strcmp(a, b) == 0)
        return true;
    if (stat(a, &one) == 0 && stat(b, &other) == 0)
        return S_ISREG(one.st_mode) && one.st_dev == other.st_dev && one.st_ino == other.st_ino;
    char *first = replaced_by(a), *second = replaced_by(b);
    bool same = first && second && strcmp(first, second) == 0;
    free(first);
    free(second);
    return same;
}
