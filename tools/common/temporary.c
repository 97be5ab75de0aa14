#include "temporary.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <unistd.h>

/* Largest numbers of simultaneous runs with the same output, and of symbolic links to follow (as in Linux). */
enum { NAMES = 64, LINKS_MOST = 40 };

/* ---- names ---- */

static int directory_length(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? (int)(slash + 1 - path) : 0;
}

char *temporary_target(const char *name)
{
    char *path = strdup(name), link[PATH_MAX];
    for (int links = 0; path; links++) {
        ssize_t length = readlink(path, link, sizeof link);
        if (length < 0)
            return path; /* not a link, or it does not exist */
        char *next = NULL;
        if (links == LINKS_MOST || length == sizeof link)
            errno = links == LINKS_MOST ? ELOOP : ENAMETOOLONG;
        else if (asprintf(&next, "%.*s%.*s", link[0] != '/' ? directory_length(path) : 0, path, (int)length, link) < 0)
            next = NULL;
        free(path);
        path = next;
    }
    return NULL;
}

/* Returns the FNV-1a hash of a text. */
static uint32_t hash(const char *text)
{
    uint32_t sum = UINT32_C(2166136261);
    for (; *text != '\0'; text++)
        sum = (sum ^ (unsigned char)*text) * UINT32_C(16777619);
    return sum;
}

/* Returns a name in the directory of `path`. It is short, since the file system may not accept a name longer than that
 * of `path`. */
static char *name_beside(const char *path, unsigned number)
{
    int directory = directory_length(path);
    char *name;
    if (asprintf(&name, "%.*s.tia-%08lx-%u", directory, path, (unsigned long)hash(path + directory), number) < 0) {
        errno = ENOMEM;
        return NULL;
    }
    return name;
}

/* ---- locks ---- */

/* True if `name` is still the name of the open file, and the user owns it. */
static bool has_name(int fd, const char *name)
{
    struct stat file, named;
    return fstat(fd, &file) == 0 && lstat(name, &named) == 0 && S_ISREG(file.st_mode) && file.st_dev == named.st_dev &&
           file.st_ino == named.st_ino && (file.st_uid == geteuid() || geteuid() == 0);
}

/* Removes the file unless another process is writing it. The name is checked again under the lock: another process may
 * have removed the file and created a new one before the lock was taken. */
static void remove_left(const char *name)
{
    int fd = open(name, O_WRONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);
    if (fd < 0)
        return;
    if (has_name(fd, name) && flock(fd, LOCK_EX | LOCK_NB) == 0 && has_name(fd, name))
        (void)unlink(name);
    (void)close(fd);
}

/* Creates and locks a file. Returns -1 and errno on failure. Before the lock is taken, another run may remove the file
 * as a leftover: then errno is EEXIST, and the caller tries the next name. On file systems without locks, leftovers are
 * not removed. */
static int create_locked(const char *name, mode_t mode)
{
    int fd = open(name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOCTTY, mode);
    if (fd < 0)
        return -1;
    bool taken = flock(fd, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    if (taken || !has_name(fd, name)) {
        (void)close(fd);
        errno = EEXIST;
        return -1;
    }
    return fd;
}

/* ---- the file ---- */

/* Removes the file; runs in a signal handler. */
static void undo(void *arg)
{
    (void)unlink(arg);
}

static int take_name(struct temporary *temporary, char *name, mode_t mode)
{
    signals_hold();
    int fd = create_locked(name, mode);
    int error = errno;
    if (fd >= 0) {
        temporary->name = name;
        temporary->cleanup = (struct signals_cleanup){.undo = undo, .arg = name};
        signals_add(&temporary->cleanup);
    }
    signals_allow();
    errno = error;
    return fd;
}

/* Copies owner and mode from the file that will be replaced, except the setuid and setgid bits, which a write would
 * clear, too. Only root may change owners, so a failure to do so is ignored. */
static bool make_like(int fd, const struct stat *before)
{
    bool owned = fchown(fd, before->st_uid, before->st_gid) == 0 || fchown(fd, (uid_t)-1, before->st_gid) == 0;
    (void)owned;
    return fchmod(fd, before->st_mode & (S_IRWXU | S_IRWXG | S_IRWXO)) == 0;
}

static int finish(struct temporary *temporary, int fd, const struct stat *before)
{
    if (fd >= 0 && before && !make_like(fd, before)) {
        int error = errno;
        temporary_remove(temporary);
        (void)close(fd);
        errno = error;
        return -1;
    }
    return fd;
}

/* Checks all names, since a leftover can have any of them: other runs may have had the lower numbers. */
int temporary_create(struct temporary *temporary, const char *path, const struct stat *before)
{
    mode_t mode = before ? S_IRUSR | S_IWUSR : S_IRUSR | S_IWUSR | S_IRGRP | S_IWGRP | S_IROTH | S_IWOTH;
    int fd = -1, error = EEXIST;
    for (unsigned i = 0; i < NAMES; i++) {
        char *name = name_beside(path, i);
        if (!name) {
            error = errno;
            break;
        }
        remove_left(name);
        if (fd < 0 && error == EEXIST) {
            fd = take_name(temporary, name, mode);
            error = errno;
        }
        if (name != temporary->name)
            free(name);
    }
    errno = error;
    return finish(temporary, fd, before);
}

static void forget(struct temporary *temporary)
{
    signals_remove(&temporary->cleanup);
    free(temporary->name);
    temporary->name = NULL;
}

int temporary_rename(struct temporary *temporary, const char *path)
{
    signals_hold();
    int result = rename(temporary->name, path), error = errno;
    if (result == 0)
        forget(temporary);
    signals_allow();
    errno = error;
    return result;
}

void temporary_remove(struct temporary *temporary)
{
    if (temporary->name) {
        (void)unlink(temporary->name);
        forget(temporary);
    }
}
