#include "descriptor.h"

#include <fcntl.h>
#include <signal.h>
#include <termios.h>
#include <unistd.h>

#include "window_signals.h"

int descriptor_open(const char *path, int access)
{
    return open(path, access | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
}

int descriptor_copy(int fd, int access)
{
    char name[64];
    int copy = ttyname_r(fd, name, sizeof name) == 0 ? descriptor_open(name, access) : -1;

    return copy >= 0 ? copy : fcntl(fd, F_DUPFD_CLOEXEC, 3);
}

bool descriptor_in_front(int fd)
{
    pid_t front = tcgetpgrp(fd);

    return front <= 0 || front == getpgrp();
}

/* Waits inside tcsetattr, since the kernel stops a background process there. After SIGCONT the kernel restarts the
 * call, and so stops the process again, unless a signal handler has run. */
bool descriptor_await_front(int fd)
{
    struct termios own;
    sigset_t none, before;

    if (descriptor_in_front(fd))
        return true;
    if (terminal_has_other_signal() || tcgetattr(fd, &own) != 0)
        return false;
    (void)sigemptyset(&none);
    (void)pthread_sigmask(SIG_SETMASK, &none, &before);
    (void)tcsetattr(fd, TCSANOW, &own);
    (void)pthread_sigmask(SIG_SETMASK, &before, NULL);
    return descriptor_in_front(fd);
}

/* Blocks SIGTTOU, by which tcflush would stop a background process. */
void descriptor_drop_output(int fd)
{
    sigset_t stop, before;

    (void)sigemptyset(&stop);
    (void)sigaddset(&stop, SIGTTOU);
    (void)pthread_sigmask(SIG_BLOCK, &stop, &before);
    (void)tcflush(fd, TCOFLUSH);
    (void)pthread_sigmask(SIG_SETMASK, &before, NULL);
}
