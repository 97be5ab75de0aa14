/* No function here may take a lock: see guard.c. */
#include "cooked.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define PATIENCE_MS 200 /* time limit of each of two tries to write, since the shell waits meanwhile */

int cooked_open(const char *path)
{
    return open(path, O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
}

/* True if the open node is the terminal that was saved, not a later one: names of pseudo-terminals are reused. */
static bool is_same_node(const struct saved *saved, int fd)
{
    struct stat s;

    return fstat(fd, &s) == 0 && s.st_ctim.tv_sec == saved->made.tv_sec && s.st_ctim.tv_nsec == saved->made.tv_nsec;
}

/* True if the modes are still those of the guarded program. */
static bool is_untouched(int fd, const struct termios *raw)
{
    struct termios now;

    return tcgetattr(fd, &now) == 0 && now.c_iflag == raw->c_iflag && now.c_lflag == raw->c_lflag &&
           now.c_cc[VMIN] == raw->c_cc[VMIN] && now.c_cc[VTIME] == raw->c_cc[VTIME];
}

/* True if another process group is in the foreground of the terminal; false if that cannot be determined, because the
 * terminal is not the controlling one. */
static bool is_behind(int fd, pid_t group)
{
    pid_t front = tcgetpgrp(fd);

    return front > 0 && front != group;
}

/* Restores the modes, unless a shell has the terminal back and has changed them, as after a stop or where tia could not
 * be traced. */
static void restore_modes(const struct saved *saved, int fd, pid_t group)
{
    if (is_behind(fd, group) && !is_untouched(fd, &saved->was.terminal.raw))
        return;
    (void)tcsetattr(fd, TCSANOW, &saved->was.terminal.before);
    (void)tcflush(fd, TCIFLUSH);
}

bool cooked_write(struct saved *saved, int timeout_ms)
{
    struct pollfd ready = {.fd = saved->fd, .events = POLLOUT};
    char *text = saved->was.text;

    while (*text != '\0') {
        ssize_t n = write(saved->fd, text, strlen(text));
        if (n > 0)
            (void)memmove(text, text + n, strlen(text + n) + 1);
        else if (n < 0 && errno != EAGAIN)
            return true;
        else if (poll(&ready, 1, timeout_ms) <= 0)
            return false;
    }
    return true;
}

/* Writes the text; true when all of it is written. If the terminal does not accept the text within PATIENCE_MS, drops
 * all pending output, such as a part of a frame, and tries the whole text once more. The text begins with the end of
 * any sequence that was cut off. */
static bool write_soon(struct saved *saved)
{
    struct saved again = *saved;

    if (cooked_write(saved, PATIENCE_MS))
        return true;
    (void)tcflush(saved->fd, TCOFLUSH);
    again.fd = saved->fd;
    *saved = again;
    return cooked_write(saved, PATIENCE_MS);
}

/* Opens the entry's terminal; -1 if the terminal is gone or the entry has none. */
static int open_terminal(const struct saved *saved)
{
    int fd = saved->kind == TERMINAL || saved->kind == TEXT ? cooked_open(saved->path) : -1;

    if (fd >= 0 && !is_same_node(saved, fd)) {
        (void)close(fd);
        fd = -1;
    }
    return fd;
}

/* Restores an entry; true when nothing is left to do. */
static bool restore(struct saved *saved, pid_t group)
{
    if (saved->kind == TEXT)
        return write_soon(saved);
    restore_modes(saved, saved->fd, group);
    return true;
}

void cooked_at_the_end(pid_t group)
{
    for (int i = KEPT_MOST - 1; i >= 0; i--) {
        int fd = kept[i].put_back ? -1 : open_terminal(&kept[i]);
        if (fd < 0)
            continue;
        kept[i].fd = fd;
        if (!restore(&kept[i], group))
            continue;
        kept[i].fd = -1;
        (void)close(fd);
    }
}

bool cooked_at_a_stop(pid_t group)
{
    bool any = false;

    for (int i = KEPT_MOST - 1; i >= 0; i--) {
        struct saved once = kept[i];
        once.fd = once.put_back ? -1 : open_terminal(&once);
        if (once.fd < 0)
            continue;
        if (!is_behind(once.fd, group)) {
            (void)restore(&once, group);
            kept[i].put_back = any = true;
        }
        (void)close(once.fd);
    }
    return any;
}
