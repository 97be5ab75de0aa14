#include "file_watch.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

struct watched_file {
    int folder; /* watch descriptor */
    unsigned round;
    char *name;
};

#ifdef __linux__

#include <sys/inotify.h>

/* A folder that is created, and may contain the file later, is reported as created. */
#define EVENTS (IN_CLOSE_WRITE | IN_MOVED_TO | IN_CREATE)

static void wake(int number)
{
    (void)number;
}

bool file_watch_open(struct file_watch *watch)
{
    const struct sigaction action = {.sa_handler = wake};
    sigset_t set;

    watch->fd = inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
    watch->is_open = watch->fd >= 0;
    if (!watch->is_open)
        return false;
    (void)sigemptyset(&set);
    (void)sigaddset(&set, SIGIO);
    (void)sigaction(SIGIO, &action, NULL);
    (void)sigprocmask(SIG_BLOCK, &set, NULL);
    return fcntl(watch->fd, F_SETOWN, getpid()) == 0 && fcntl(watch->fd, F_SETFL, O_NONBLOCK | O_ASYNC) == 0;
}

static int watch_folder(const struct file_watch *watch, const char *path)
{
    return inotify_add_watch(watch->fd, *path ? path : "/", EVENTS | IN_ONLYDIR);
}

/* True if the event may have changed the contents behind a name. A created file is not complete yet. */
static bool changes(const struct inotify_event *event)
{
    return !(event->mask & IN_CREATE) || event->mask & IN_ISDIR;
}

static bool is_known(const struct file_watch *watch, const struct inotify_event *event)
{
    if (event->mask & IN_Q_OVERFLOW)
        return true;
    for (size_t i = 0; i < watch->count && event->len; i++)
        if (watch->files[i].folder == event->wd && strcmp(watch->files[i].name, event->name) == 0)
            return changes(event);
    return false;
}

bool file_watch_fires(struct file_watch *watch)
{
    _Alignas(struct inotify_event) char events[4096];
    ssize_t length;
    bool fires = false;

    while (watch->is_open && (length = read(watch->fd, events, sizeof events)) > 0)
        for (char *at = events; at < events + length;) {
            const struct inotify_event *event = (const struct inotify_event *)(const void *)at;
            fires = fires || is_known(watch, event);
            at += sizeof *event + event->len;
        }
    return fires;
}

#else /* no inotify */

bool file_watch_open(struct file_watch *watch)
{
    (void)watch;
    errno = ENOSYS;
    return false;
}

static int watch_folder(const struct file_watch *watch, const char *path)
{
    (void)watch;
    (void)path;
    return -1;
}

bool file_watch_fires(struct file_watch *watch)
{
    (void)watch;
    return false;
}

#endif

void file_watch_close(struct file_watch *watch)
{
    for (size_t i = 0; i < watch->count; i++)
        free(watch->files[i].name);
    free(watch->files);
    if (watch->is_open)
        (void)close(watch->fd);
    *watch = (struct file_watch){.is_open = false};
}

void file_watch_begin(struct file_watch *watch)
{
    watch->round++;
}

void file_watch_end(struct file_watch *watch)
{
    size_t kept = 0;

    for (size_t i = 0; i < watch->count; i++)
        if (watch->files[i].round == watch->round)
            watch->files[kept++] = watch->files[i];
        else
            free(watch->files[i].name);
    watch->count = kept;
}

/* Adds a name, which is freed here or later. */
static void add(struct file_watch *watch, int folder, char *name)
{
    size_t room = watch->room ? 2 * watch->room : 16;

    for (size_t i = 0; i < watch->count && name; i++)
        if (watch->files[i].folder == folder && strcmp(watch->files[i].name, name) == 0) {
            watch->files[i].round = watch->round;
            free(name);
            return;
        }
    if (watch->count == watch->room) {
        struct watched_file *files = realloc(watch->files, room * sizeof *files);
        if (!files) {
            free(name);
            return;
        }
        watch->files = files;
        watch->room = room;
    }
    if (name)
        watch->files[watch->count++] = (struct watched_file){folder, watch->round, name};
}

/* Adds the file by its folder or, as long as there is no such folder, the folder by its own folder. Changes the path.
 */
static void add_path(struct file_watch *watch, char *path)
{
    for (char *slash = strrchr(path, '/');; slash = strrchr(path, '/')) {
        const char *name = slash ? slash + 1 : path;
        if (slash)
            *slash = '\0';
        int folder = watch_folder(watch, slash ? path : ".");
        if (folder >= 0)
            add(watch, folder, strdup(name));
        if (folder >= 0 || errno != ENOENT || !slash || !*path)
            return;
    }
}

bool file_watch_add(void *ctx, const char *path)
{
    char *copy = strdup(path), *target = realpath(path, NULL);

    if (copy)
        add_path(ctx, copy);
    if (target)
        add_path(ctx, target);
    free(copy);
    free(target);
    return true;
}
