/* pseudo.h - a pseudo-terminal for the guardian's tests: they make it raw, and expect the guardian to make it cooked
 * again. */
#ifndef TESTS_PSEUDO_H
#define TESTS_PSEUDO_H

#include "check.h"
#include "console/guardian.h"

#include <fcntl.h>
#include <poll.h>
#include <stdbool.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

static int master, terminal;
static struct termios before;

static inline bool open_terminal(void)
{
    master = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
    if (master < 0 || grantpt(master) != 0 || unlockpt(master) != 0) {
        SKIP("no pseudo-terminal here");
        return false;
    }
    terminal = open(ptsname(master), O_RDWR | O_NOCTTY | O_CLOEXEC);
    CHECK(terminal >= 0 && tcgetattr(terminal, &before) == 0);
    return terminal >= 0;
}

static inline void close_terminal(void)
{
    (void)close(terminal);
    (void)close(master);
}

static inline void make_raw(void)
{
    struct termios raw = before;

    cfmakeraw(&raw);
    (void)tcsetattr(terminal, TCSANOW, &raw);
}

static inline int keep_terminal(int fd)
{
    struct termios raw = before;

    cfmakeraw(&raw);
    return guardian_keep_terminal(fd, &raw);
}

static inline bool is_raw(void)
{
    struct termios now;

    return tcgetattr(terminal, &now) == 0 && (now.c_lflag & ICANON) == 0;
}

static inline void keep_and_make_raw(void)
{
    if (keep_terminal(terminal) == 0)
        make_raw();
}

/* True if the terminal becomes cooked again within 10 s. The function polls, since a change of the modes causes no
 * event. */
static inline bool cooked_again(void)
{
    for (int i = 0; i < 1000; i++) {
        if (!is_raw())
            return true;
        (void)poll(NULL, 0, 10);
    }
    return false;
}

#endif
