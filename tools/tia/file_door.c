#include "file_door.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "common/inputs.h"

enum { FILES_MOST = 4096, READS = O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY };

/* ---- messages: a path one way, an error number and at most one descriptor the other way ---- */

union control {
    struct cmsghdr align;
    char bytes[CMSG_SPACE(sizeof(int))];
};

/* Sends the descriptor; error if it is -1. */
static bool answer(int socket, int fd)
{
    int error = fd >= 0 ? 0 : errno;
    union control control = {.bytes = {0}};
    struct iovec text = {&error, sizeof error};
    struct msghdr message = {.msg_iov = &text, .msg_iovlen = 1};

    if (fd >= 0) {
        message.msg_control = control.bytes;
        message.msg_controllen = sizeof control.bytes;
        struct cmsghdr *head = CMSG_FIRSTHDR(&message);
        head->cmsg_level = SOL_SOCKET;
        head->cmsg_type = SCM_RIGHTS;
        head->cmsg_len = CMSG_LEN(sizeof fd);
        memcpy(CMSG_DATA(head), &fd, sizeof fd);
    }
    return sendmsg(socket, &message, MSG_NOSIGNAL) == (ssize_t)sizeof error;
}

static int receive(int socket)
{
    int error = EIO, fd = -1;
    union control control = {.bytes = {0}};
    struct iovec text = {&error, sizeof error};
    struct msghdr message = {
        .msg_iov = &text, .msg_iovlen = 1, .msg_control = control.bytes, .msg_controllen = sizeof control.bytes};

    /* glibc calls socketcall on some processors, for which the filter of confine.c has no rule */
    if (syscall(SYS_recvmsg, socket, &message, MSG_CMSG_CLOEXEC) == (long)sizeof error && !error) {
        struct cmsghdr *head = CMSG_FIRSTHDR(&message);
        if (head && head->cmsg_level == SOL_SOCKET && head->cmsg_type == SCM_RIGHTS &&
            head->cmsg_len == CMSG_LEN(sizeof fd))
            memcpy(&fd, CMSG_DATA(head), sizeof fd);
        error = EIO;
    }
    errno = error;
    return fd;
}

/* ---- files ---- */

static int refuse(int folder, int error)
{
    if (folder >= 0)
        (void)close(folder);
    errno = error;
    return -1;
}

/* Opens a file below an open folder, which it closes, step by step. */
static int open_below(int folder, char *name)
{
    for (char *slash; folder >= 0 && (slash = strchr(name, '/')) != NULL; name = slash + 1) {
        *slash = '\0';
        if (strcmp(name, "..") == 0)
            return refuse(folder, EACCES);
        if (*name == '\0')
            continue;
        int next = openat(folder, name, READS | O_DIRECTORY | O_NOFOLLOW), error = errno;
        (void)close(folder);
        folder = next;
        errno = error == ELOOP || error == ENOTDIR ? EACCES : error;
    }
    if (folder < 0)
        return -1;
    int fd = openat(folder, name, READS | O_NOFOLLOW), error = errno == ELOOP ? EACCES : errno;
    (void)close(folder);
    errno = error;
    return fd;
}

/* Opens a file beside the model. Its path must begin with that of the model's folder. */
static int open_beside(const char *model, char *path)
{
    const char *slash = strrchr(model, '/');
    size_t length = slash ? (size_t)(slash + 1 - model) : 0;
    char folder[PATH_MAX];

    if (strncmp(path, model, length) != 0 || path[length] == '/')
        return refuse(-1, EACCES);
    (void)snprintf(folder, sizeof folder, "%.*s", (int)length, model);
    return open_below(open(length ? folder : ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC), path + length);
}

/* Opens the model. Its type is checked before, since opening alone may block (a FIFO) or have effects (a device). */
static int open_model(const char *path)
{
    struct stat status;

    if (stat(path, &status) == 0 && !S_ISREG(status.st_mode))
        return refuse(-1, S_ISDIR(status.st_mode) ? EISDIR : EACCES);
    return open(path, READS);
}

static int open_file(struct file_door *door, char *path)
{
    struct stat status;

    if (door->served++ >= FILES_MOST)
        return refuse(-1, EMFILE);
    int fd = strcmp(path, door->model) == 0 ? open_model(path) : open_beside(door->model, path);
    if (fd < 0)
        return fd;
    if (fstat(fd, &status) != 0 || !S_ISREG(status.st_mode))
        return refuse(fd, EACCES);
    inputs_add(&status);
    return fd;
}

bool file_door_serve(struct file_door *door)
{
    char path[PATH_MAX + 1];
    ssize_t length = recv(door->socket, path, PATH_MAX, 0);

    if (length <= 0)
        return false;
    path[length] = '\0';
    int fd = open_file(door, path);
    bool goes_on = answer(door->socket, fd);
    if (fd >= 0)
        (void)close(fd);
    return goes_on;
}

int file_door_open(void *ctx, const char *path)
{
    int socket = *(const int *)ctx;
    size_t length = strlen(path);

    if (length == 0 || length >= PATH_MAX)
        return refuse(-1, ENAMETOOLONG);
    return write(socket, path, length) == (ssize_t)length ? receive(socket) : refuse(-1, EIO);
}
