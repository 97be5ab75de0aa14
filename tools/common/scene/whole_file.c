#include "whole_file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "common/inputs.h"

/* See whole_open_by; NULL: files are opened by their paths. */
static whole_opener *opens;
static void *opens_ctx;

void whole_open_by(whole_opener *opener, void *ctx)
{
    opens = opener;
    opens_ctx = ctx;
}

static int failed(const char **why, int error)
{
    *why = strerror(error);
    return error == ENOMEM ? TIA_ERR_MEMORY : TIA_ERR_DEVICE;
}

/* Makes room for at least one more byte. */
static bool grow(struct whole *whole, size_t *room)
{
    if (whole->length < *room)
        return true;
    size_t more = *room * 2;
    char *bytes = realloc(whole->bytes, more);
    if (bytes) {
        whole->bytes = bytes;
        *room = more;
    }
    return bytes;
}

static int read_all(struct whole *whole, int fd, size_t room, size_t most, const char **why)
{
    whole->length = 0;
    whole->bytes = malloc(room);
    for (ssize_t got = 1; got > 0; whole->length += got > 0 ? (size_t)got : 0) {
        if (!whole->bytes || !grow(whole, &room))
            return failed(why, ENOMEM);
        if (whole->length > most) {
            *why = "too large";
            return TIA_ERR_RANGE;
        }
        got = read(fd, whole->bytes + whole->length, room - whole->length);
        if (got < 0)
            return failed(why, errno);
    }
    return TIA_OK;
}

static int read_sized(struct whole *whole, int fd, size_t size, size_t most, const char **why)
{
    /* one byte more than the file's size, so that read can return 0 at its end without growing the buffer */
    int status = read_all(whole, fd, size < most ? size + 1 : most + 1, most, why);
    if (status) {
        free(whole->bytes);
        *whole = (struct whole){NULL, 0};
    }
    return status;
}

int whole_read_from(struct whole *whole, int fd, size_t most, const char **why)
{
    return read_sized(whole, fd, 65535, most, why);
}

static int check(const struct stat *status, size_t most, const char **why)
{
    if (S_ISDIR(status->st_mode))
        return failed(why, EISDIR);
    if (!S_ISREG(status->st_mode)) {
        *why = "not a regular file";
        return TIA_ERR_DEVICE;
    }
    if (status->st_size < 0 || (uint64_t)status->st_size > most) {
        *why = "too large";
        return TIA_ERR_RANGE;
    }
    return TIA_OK;
}

/* Opens the file. Its type is checked before, since opening alone may block (a FIFO) or have effects (a device). */
static int open_path(int *fd, const char *path, size_t most, const char **why)
{
    struct stat status;

    if (!opens && stat(path, &status) != 0)
        return failed(why, errno);
    int result = opens ? TIA_OK : check(&status, most, why);
    if (result)
        return result;
    *fd = opens ? opens(opens_ctx, path) : open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);
    return *fd < 0 ? failed(why, errno) : TIA_OK;
}

/* Reads the file. Its type is checked again, since the name may refer to another file by the time it is open. */
int whole_read(struct whole *whole, const char *path, size_t most, const char **why)
{
    struct stat status;
    int fd = -1, result = open_path(&fd, path, most, why);

    *whole = (struct whole){NULL, 0};
    if (!result)
        result = fstat(fd, &status) != 0 ? failed(why, errno) : check(&status, most, why);
    if (!result) {
        inputs_add(&status);
        result = read_sized(whole, fd, (size_t)status.st_size, most, why);
    }
    if (fd >= 0)
        (void)close(fd);
    return result;
}
