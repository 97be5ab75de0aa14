/* window_signals.c - SIGWINCH and SIGCONT, for the display and the keyboard of one terminal. */
#include "window_signals.h"

#include <errno.h>
#include <setjmp.h>
#include <signal.h>
#include <stddef.h>
#include <unistd.h>

#include "console/guardian.h"

static volatile sig_atomic_t resumes, writing;
static sigjmp_buf before_write;
static unsigned users;
static sigset_t mask_before;
static struct sigaction winch_before, cont_before;

static void on_winch(int number)
{
    (void)number;
}

static void on_cont(int number)
{
    (void)number;
    resumes++;
    if (!writing)
        return;
    writing = false;
    siglongjmp(before_write, 1);
}

static void unblock(int number, sigset_t *before)
{
    sigset_t one;

    (void)sigemptyset(&one);
    (void)sigaddset(&one, number);
    (void)pthread_sigmask(SIG_UNBLOCK, &one, before);
}

/* Blocks the signals except in console_wait: otherwise a signal just before the wait would be missed. */
void terminal_signals_begin(void)
{
    struct sigaction winch = {.sa_handler = on_winch}, cont = {.sa_handler = on_cont};
    sigset_t both;

    if (users++ > 0)
        return;
    (void)sigemptyset(&both);
    (void)sigaddset(&both, SIGWINCH);
    (void)sigaddset(&both, SIGCONT);
    (void)pthread_sigmask(SIG_BLOCK, &both, &mask_before);
    (void)sigaction(SIGWINCH, &winch, &winch_before);
    (void)sigaction(SIGCONT, &cont, &cont_before);
}

static void let_in(int number)
{
    if (!sigismember(&mask_before, number))
        unblock(number, NULL);
}

void terminal_signals_end(void)
{
    if (users == 0 || --users > 0)
        return;
    (void)sigaction(SIGWINCH, &winch_before, NULL);
    (void)sigaction(SIGCONT, &cont_before, NULL);
    let_in(SIGWINCH);
    let_in(SIGCONT);
}

struct terminal_stops terminal_stops_now(void)
{
    sigset_t before;

    unblock(SIGCONT, &before);
    (void)pthread_sigmask(SIG_SETMASK, &before, NULL);
    return (struct terminal_stops){resumes, guardian_put_back()};
}

bool terminal_is_put_back(const struct terminal_stops *since)
{
    return since->put_back != guardian_put_back();
}

bool terminal_is_lost(const struct terminal_stops *since)
{
    return since->resumes != resumes || terminal_is_put_back(since);
}

void terminal_resume_again(void)
{
    (void)raise(SIGCONT);
}

bool terminal_has_other_signal(void)
{
    sigset_t pending;

    if (sigpending(&pending) != 0)
        return false;
    (void)sigdelset(&pending, SIGWINCH);
    (void)sigdelset(&pending, SIGCONT);
    return sigisemptyset(&pending) == 0;
}

/* Writes; after a stop, the handler of SIGCONT jumps out of the write. Without the jump, the kernel would restart a
 * write that the stop has interrupted. If the write had already sent bytes, their number is lost. */
ssize_t terminal_write(int fd, const void *bytes, size_t count)
{
    sigset_t before;

    if (sigsetjmp(before_write, 1) != 0) {
        errno = EINTR;
        return -1;
    }
    writing = true;
    unblock(SIGCONT, &before);
    ssize_t n = write(fd, bytes, count);
    int error = errno;
    writing = false;
    (void)pthread_sigmask(SIG_SETMASK, &before, NULL);
    errno = error;
    return n;
}
